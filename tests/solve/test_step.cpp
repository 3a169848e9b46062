// SPDX-License-Identifier: Apache-2.0
// Increments: cut-back, extrapolation, the end of the road, and being stopped.
#include <cmath>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::Controls;
using mechanics::Prescribed;
using mechanics::State;
using support::SolidModel;
using support::Supports;

/// Writes everything down, and may ask to stop.
class Recorder final : public Observer {
 public:
  void increment_begins(const Increment& increment) override { begun.push_back(increment); }
  void iteration_done(const Increment& increment, const Iteration& iteration) override {
    EXPECT_EQ(increment.number, begun.back().number);
    ++heard;
    if (iteration.number == 0) first_residual.push_back(iteration.residual);
  }
  void increment_ends(const Increment& increment, const IncrementEnd& end) override {
    EXPECT_EQ(increment.number, begun.back().number);
    ended.push_back(end);
  }
  [[nodiscard]] bool stop_requested() const override { return heard >= stop_after; }

  std::vector<Increment> begun;
  std::vector<IncrementEnd> ended;
  std::vector<double> first_residual;  ///< of each increment, before its first correction
  int heard = 0;
  int stop_after = 1000000;
};

/// A bar of soft tissue that is pulled at its right end, its left end clamped.
class Step : public ::testing::Test {
 protected:
  static SolidModel make() {
    const mesh::Mesh mesh = support::make_block({.size = {4, 1, 1}, .n = {4, 2, 2}});
    return {mesh, support::uniform_solid(mesh, support::example_law("mooney_rivlin"),
                                         support::log_volume(50.0))};
  }

  [[nodiscard]] Controls pulled(double force) const {
    Controls controls;
    controls.nodal_force.assign(bar_.mesh.n_nodes(), Vec3::Zero());
    const std::span<const Index> end = bar_.mesh.nodes("x_max");
    for (const Index node : end)
      controls.nodal_force[at(node)].x() = force / double(end.size());
    return controls;
  }

  [[nodiscard]] StepReport pull(double force, const StepSettings& settings) {
    Equilibrium equilibrium(bar_.model, clamped_.dofs);
    return advance(equilibrium, state_, {}, pulled(force), clamped_.values, settings, label_,
                   recorder_);
  }

  SolidModel bar_ = make();
  Prescribed clamped_ = Supports().clamp(bar_.mesh.nodes("x_min")).prescribed();
  State state_ = bar_.model.initial_state();
  Increment label_{.step = "express", .step_number = 2, .n_steps = 3};
  Recorder recorder_;
};

TEST_F(Step, TakesOneIncrementWhereOneWillDo) {
  const StepReport report = pull(0.3, {});
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.reached, 1.0);
  EXPECT_EQ(report.increments, 1);
  EXPECT_EQ(report.cut_backs, 0);
  EXPECT_EQ(report.iterations, report.last.iterations);
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  EXPECT_LE(equilibrium.residual_norm(state_, pulled(0.3)), 1e-6);
}

TEST_F(Step, TellsWhichStepAndIncrementItWorksOn) {
  const StepReport report = pull(0.3, {.newton = {}, .first_increment = 0.25});
  ASSERT_TRUE(report.converged);
  ASSERT_EQ(recorder_.begun.size(), recorder_.ended.size());
  EXPECT_EQ(recorder_.begun.front().from, 0.0);
  EXPECT_EQ(recorder_.begun.back().to, 1.0) << "ends at the end to the last bit";
  for (std::size_t k = 0; k < recorder_.begun.size(); ++k) {
    const Increment& increment = recorder_.begun[k];
    EXPECT_EQ(increment.step, "express");
    EXPECT_EQ(increment.step_number, 2);
    EXPECT_EQ(increment.n_steps, 3);
    EXPECT_EQ(increment.number, static_cast<int>(k) + 1);
    EXPECT_EQ(increment.from, k == 0 ? 0.0 : recorder_.begun[k - 1].to);
    EXPECT_TRUE(recorder_.ended[k].converged);
    EXPECT_FALSE(recorder_.ended[k].reason.empty());
  }
}

TEST_F(Step, StopsWhereItIsToldTo) {
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  StepSettings settings;
  settings.stops = 5;
  std::vector<double> parts;
  const StepReport report =
      advance(equilibrium, state_, {}, pulled(0.3), clamped_.values, settings, label_, recorder_,
              [&](double part) {
                parts.push_back(part);
                EXPECT_LE(equilibrium.residual_norm(state_, pulled(part * 0.3)), 1e-6) << part;
              });
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.increments, 5);
  EXPECT_EQ(parts, (std::vector<double>{1.0 / 5, 2.0 / 5, 3.0 / 5, 4.0 / 5, 1.0}));
}

TEST_F(Step, StopsAsOftenWhereIncrementsFailBetweenTheStops) {
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  StepSettings settings;
  settings.newton.max_iterations = 3;
  settings.stops = 2;
  std::vector<double> parts;
  const StepReport report = advance(equilibrium, state_, {}, pulled(1.0), clamped_.values, settings,
                                    label_, recorder_, [&](double part) { parts.push_back(part); });
  EXPECT_TRUE(report.converged);
  EXPECT_GE(report.cut_backs, 1);
  EXPECT_EQ(parts, (std::vector<double>{0.5, 1.0}));
}

TEST_F(Step, GrowsItsIncrementsWhereTheyAreEasy) {
  const StepReport report = pull(0.3, {.newton = {}, .first_increment = 1.0 / 32});
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.increments, 6) << "1/32, 1/16, 1/8 ... and the rest";
}

TEST_F(Step, CutsAnIncrementBackThatFails) {
  StepSettings impatient;
  impatient.newton.max_iterations = 3;
  const StepReport report = pull(0.5, impatient);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.reached, 1.0);
  EXPECT_GE(report.cut_backs, 1);
  EXPECT_EQ(recorder_.begun.size(), static_cast<std::size_t>(report.increments + report.cut_backs));
  EXPECT_FALSE(recorder_.ended.front().converged);
  EXPECT_EQ(recorder_.begun[1].from, 0.0);
  EXPECT_EQ(recorder_.begun[1].to, 0.5) << "half of the one that failed";

  // Where it ends does not depend on the way.
  State direct = bar_.model.initial_state();
  ASSERT_TRUE(solve_equilibrium(bar_.model, direct, pulled(0.5), clamped_).converged);
  for (std::size_t node = 0; node < direct.u.size(); ++node)
    EXPECT_LE((state_.u[node] - direct.u[node]).norm(), 1e-5);
}

TEST_F(Step, StartsAnIncrementWhereTheLastOnePointed) {
  const StepReport report = pull(0.01, {.newton = {}, .first_increment = 0.5});
  ASSERT_TRUE(report.converged);
  ASSERT_EQ(report.increments, 2);
  // Without a guess the second increment would begin with half of the load, like the first.
  EXPECT_LE(recorder_.first_residual[1], 0.5 * recorder_.first_residual[0]);
}

TEST_F(Step, MovesPrescribedUnknownsInProportion) {
  Supports supports;
  supports.clamp(bar_.mesh.nodes("x_min"));
  for (const Index node : bar_.mesh.nodes("x_max"))
    supports.place(node, {1.0, 0.3, 0.0});
  const Prescribed both_ends = supports.prescribed();
  Equilibrium equilibrium(bar_.model, both_ends.dofs);

  /// Sees where the right end stands after the first increment.
  StepSettings settings;
  settings.first_increment = 0.25;
  settings.max_increments = 1;
  const StepReport first =
      advance(equilibrium, state_, {}, {}, both_ends.values, settings, label_, recorder_);
  EXPECT_FALSE(first.converged) << "one increment was not enough";
  EXPECT_EQ(first.reached, 0.25);
  const Index end = bar_.mesh.nodes("x_max")[0];
  EXPECT_LE((state_.u[at(end)] - Vec3(0.25, 0.075, 0.0)).norm(), 1e-14);

  const StepReport rest =
      advance(equilibrium, state_, {}, {}, both_ends.values, {}, label_, recorder_);
  EXPECT_TRUE(rest.converged);
  EXPECT_LE((state_.u[at(end)] - Vec3(1.0, 0.3, 0.0)).norm(), 1e-14);
}

TEST_F(Step, FailsWithTheSmallestIncrementAndLeavesTheStateAlone) {
  StepSettings hopeless;
  hopeless.newton = {.relative_tolerance = 0.0, .absolute_tolerance = 0.0, .max_iterations = 2};
  hopeless.smallest_increment = 1.0 / 8.0;
  state_.u[40].y() = 1e-3;
  const State before = state_;
  const StepReport report = pull(0.3, hopeless);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reached, 0.0);
  EXPECT_EQ(report.increments, 0);
  EXPECT_EQ(report.cut_backs, 4) << "1, 1/2, 1/4, 1/8";
  EXPECT_EQ(report.last_increment.to, 1.0 / 8.0);
  EXPECT_FALSE(report.last.converged);
  EXPECT_FALSE(report.last.reason.empty());
  EXPECT_TRUE(support::same_bits(state_.u, before.u));
}

TEST_F(Step, StopsWhenAskedAndKeepsTheLastConvergedState) {
  StepSettings settings;
  settings.first_increment = 0.25;
  Recorder patient;
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  settings.max_increments = 1;
  State after_one = state_;
  (void)advance(equilibrium, after_one, {}, pulled(0.3), clamped_.values, settings, label_,
                patient);

  settings.max_increments = 100;
  recorder_.stop_after = patient.heard + 2;  // in the middle of the second increment
  const StepReport report = pull(0.3, settings);
  EXPECT_TRUE(report.interrupted);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reached, 0.25);
  EXPECT_EQ(report.increments, 1);
  EXPECT_EQ(recorder_.heard, recorder_.stop_after) << "nothing is done after the request";
  EXPECT_TRUE(support::same_bits(state_.u, after_one.u));
}

TEST_F(Step, GivesTheSameBytesTwice) {
  const StepReport report = pull(0.5, {.newton = {}, .first_increment = 0.25});
  ASSERT_TRUE(report.converged);
  const State first = state_;
  state_ = bar_.model.initial_state();
  (void)pull(0.5, {.newton = {}, .first_increment = 0.25});
  EXPECT_TRUE(support::same_bits(first.u, state_.u));
}

TEST(StepBeyondTheLimitLoad, EndsAtTheLoadThatTheLawCanHold) {
  // A cube pulled on all sides by dead forces of T per reference area: kappa ln J / J lambda^2 = T. The volumetric law
  // holds up to J = e^2, lambda = e^(2/3), T = 2 kappa / lambda. Shear stiffness keeps it a cube.
  const double kappa = 1.0;
  const double limit = 2.0 * kappa / std::exp(2.0 / 3.0);
  const mesh::Mesh mesh = support::make_block({.n = {1, 1, 1}});
  const SolidModel cube(
      mesh, support::uniform_solid(mesh, support::neo_hookean(50.0), support::log_volume(kappa)));
  const Prescribed rollers = Supports()
                                 .hold(mesh.nodes("x_min"), 0)
                                 .hold(mesh.nodes("y_min"), 1)
                                 .hold(mesh.nodes("z_min"), 2)
                                 .prescribed();
  Controls loaded;
  loaded.nodal_force.assign(mesh.n_nodes(), Vec3::Zero());
  const std::array<const char*, 3> far = {"x_max", "y_max", "z_max"};
  for (int axis = 0; axis < 3; ++axis) {
    for (const Index node : mesh.nodes(far[static_cast<std::size_t>(axis)]))
      loaded.nodal_force[at(node)](axis) = 2.0 * limit / 4.0;
  }
  State state = cube.model.initial_state();
  Equilibrium equilibrium(cube.model, rollers.dofs);
  Observer silent;
  const StepReport report = advance(equilibrium, state, {}, loaded, rollers.values, {}, {}, silent);
  EXPECT_FALSE(report.converged);
  EXPECT_LE(report.reached, 0.5);
  EXPECT_GE(report.reached, 0.5 - 2.0 / 32.0);
  EXPECT_GE(report.cut_backs, 1);
  EXPECT_EQ(report.last.inadmissible.element, 0);
  EXPECT_GT(report.last.inadmissible.J, std::exp(2.0));
  // At the last converged state the stress is that of the load which was reached.
  const double lambda = 1.0 + state.u[1].x();
  const double T = kappa * 3.0 * std::log(lambda) / lambda;
  EXPECT_NEAR(T, 2.0 * limit * report.reached, 1e-5);
  EXPECT_LE(lambda, std::exp(2.0 / 3.0));
}

}  // namespace
}  // namespace facies::solve
