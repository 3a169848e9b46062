// SPDX-License-Identifier: Apache-2.0
// Equilibrium where all goes well: how fast, by which criterion, and what is reported.
#include <cmath>
#include <gmock/gmock.h>

#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mechanics/attachment.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::Controls;
using mechanics::Prescribed;
using mechanics::State;
using support::SolidModel;
using support::Supports;
using ::testing::HasSubstr;

SolidModel make_bar(int threads = 1) {
  const mesh::Mesh mesh = support::make_block(
      {.size = {4, 1, 1}, .n = {4, 2, 2}, .cells = support::BlockCells::mixed, .shake = 0.15});
  return {mesh,
          support::uniform_solid(mesh, support::example_law("mooney_rivlin"),
                                 support::log_volume(50.0)),
          threads};
}

/// A bar of soft tissue, its left end clamped.
class Bar : public ::testing::Test {
 protected:
  /// The force, shared by the nodes of the right end.
  [[nodiscard]] Controls pulled(const Vec3& force) const {
    Controls controls;
    controls.nodal_force.assign(bar_.mesh.n_nodes(), Vec3::Zero());
    const std::span<const Index> end = bar_.mesh.nodes("x_max");
    for (const Index node : end)
      controls.nodal_force[at(node)] = force / double(end.size());
    return controls;
  }

  /// The right end moved, too.
  [[nodiscard]] Prescribed moved(const Vec3& u) const {
    Supports supports;
    supports.clamp(bar_.mesh.nodes("x_min"));
    for (const Index node : bar_.mesh.nodes("x_max"))
      supports.place(node, u);
    return supports.prescribed();
  }

  SolidModel bar_ = make_bar();
  Prescribed clamped_ = Supports().clamp(bar_.mesh.nodes("x_min")).prescribed();
  State state_ = bar_.model.initial_state();
};

/// The order that three successive residuals show: log(r2 / r1) / log(r1 / r0).
double last_order(const std::vector<double>& residuals, double rounding) {
  double order = 0.0;
  for (std::size_t k = 2; k < residuals.size(); ++k) {
    if (residuals[k] <= rounding) break;
    order =
        std::log(residuals[k] / residuals[k - 1]) / std::log(residuals[k - 1] / residuals[k - 2]);
  }
  return order;
}

TEST_F(Bar, IsFoundQuadratically) {
  const NewtonSettings exact{.relative_tolerance = 1e-12, .absolute_tolerance = 0.0};
  std::vector<double> residuals;
  const auto listen = [&](const Iteration& iteration) {
    residuals.push_back(iteration.relative);
    EXPECT_EQ(iteration.shift, 0.0);
  };
  const auto expect_quadratic = [&](const NewtonReport& report) {
    EXPECT_TRUE(report.converged) << report.reason;
    EXPECT_LE(report.iterations, 9);
    EXPECT_GE(last_order(residuals, 1e-12), 1.8) << ::testing::PrintToString(residuals);
    residuals.clear();
  };
  Equilibrium under_load(bar_.model, clamped_.dofs);
  expect_quadratic(
      under_load.solve(state_, pulled({0.1, 0.002, 0.004}), clamped_.values, exact, listen));
  state_ = bar_.model.initial_state();
  const Prescribed both_ends = moved({0.5, 0.1, -0.15});
  Equilibrium stretched(bar_.model, both_ends.dofs);
  expect_quadratic(stretched.solve(state_, {}, both_ends.values, exact, listen));
}

TEST_F(Bar, PutsPrescribedUnknownsWhereTheyBelong) {
  const Prescribed both_ends = moved({1.5, 0.2, -0.3});
  const NewtonReport report = solve_equilibrium(bar_.model, state_, {}, both_ends);
  EXPECT_TRUE(report.converged) << report.reason;
  for (std::size_t k = 0; k < both_ends.dofs.size(); ++k) {
    const Index dof = both_ends.dofs[k];
    EXPECT_NEAR(state_.u[at(dof / 3)](dof % 3), both_ends.values[k], 1e-14);
  }
}

TEST_F(Bar, IsHeldByReactionsThatBalanceTheLoad) {
  const Vec3 force(0.3, 0.005, 0.01);
  const NewtonReport report =
      solve_equilibrium(bar_.model, state_, pulled(force), clamped_, {.relative_tolerance = 1e-10});
  ASSERT_TRUE(report.converged) << report.reason;
  const Eigen::VectorXd r = support::residual(bar_.model, state_, pulled(force));
  Vec3 reaction = Vec3::Zero();
  for (const Index dof : clamped_.dofs)
    reaction(dof % 3) += r(dof);
  EXPECT_LE((reaction + force).norm(), 1e-8 * force.norm());
}

TEST_F(Bar, ReportsTheResidualItsScaleAndItsWorstNode) {
  const Controls controls = pulled({0.3, 0.0, 0.0});
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  const NewtonReport report =
      equilibrium.solve(state_, controls, clamped_.values, {.max_iterations = 1});
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.factorisations, 1);
  EXPECT_THAT(report.reason, HasSubstr("after 1 iterations"));
  EXPECT_EQ(report.inadmissible.element, -1);

  const Eigen::VectorXd r = support::residual(bar_.model, state_, controls);
  double free_sum = 0.0;
  double fixed_sum = 0.0;
  double largest = 0.0;
  Index worst = -1;
  for (Index dof = 0; dof < to_index(bar_.model.n_dofs()); ++dof) {
    const bool held = std::binary_search(clamped_.dofs.begin(), clamped_.dofs.end(), dof);
    (held ? fixed_sum : free_sum) += r(dof) * r(dof);
    if (!held && std::abs(r(dof)) > largest) {
      largest = std::abs(r(dof));
      worst = dof / 3;
    }
  }
  const double applied = 0.3 / std::sqrt(double(bar_.mesh.nodes("x_max").size()));
  EXPECT_NEAR(report.residual, std::sqrt(free_sum), 1e-12);
  EXPECT_NEAR(report.relative, std::sqrt(free_sum) / std::max(std::sqrt(fixed_sum), applied),
              1e-12);
  EXPECT_EQ(report.worst_node, worst);
  EXPECT_NEAR(equilibrium.residual_norm(state_, controls), report.residual, 1e-12);
}

TEST_F(Bar, IsAlreadyInEquilibriumWithoutALoad) {
  const NewtonReport report = solve_equilibrium(bar_.model, state_, {}, clamped_);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_THAT(report.reason, HasSubstr("of the load"));
}

TEST_F(Bar, ConvergesByTheCriterionAndNotByTheCount) {
  for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
    State state = bar_.model.initial_state();
    std::vector<double> relative;
    Equilibrium equilibrium(bar_.model, clamped_.dofs);
    const NewtonReport report = equilibrium.solve(
        state, pulled({0.3, 0.0, 0.0}), clamped_.values,
        {.relative_tolerance = tolerance, .absolute_tolerance = 0.0},
        [&](const Iteration& iteration) { relative.push_back(iteration.relative); });
    EXPECT_TRUE(report.converged);
    EXPECT_LE(relative.back(), tolerance);
    EXPECT_GT(relative[relative.size() - 2], tolerance) << "no iteration too many";
    EXPECT_EQ(relative.size(), at(report.iterations) + 1) << "every iteration is heard";
  }
}

TEST_F(Bar, TellsEachIteration) {
  std::vector<Iteration> heard;
  const State start = state_;
  State after_first;
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  const NewtonReport report = equilibrium.solve(state_, pulled({0.3, 0.0, 0.0}), clamped_.values,
                                                {}, [&](const Iteration& iteration) {
                                                  heard.push_back(iteration);
                                                  if (iteration.number == 1) after_first = state_;
                                                });
  ASSERT_TRUE(report.converged);
  for (std::size_t k = 0; k < heard.size(); ++k)
    EXPECT_EQ(heard[k].number, static_cast<int>(k));
  EXPECT_EQ(heard[0].factorisations, 0);
  EXPECT_EQ(heard[0].correction, 0.0);
  double largest = 0.0;
  for (std::size_t node = 0; node < start.u.size(); ++node) {
    for (int axis = 0; axis < 3; ++axis)
      largest = std::max(largest, std::abs(after_first.u[node](axis) - start.u[node](axis)));
  }
  EXPECT_NEAR(heard[1].correction, largest, 1e-14);
  EXPECT_GT(heard[1].step_length, 0.0);
  EXPECT_LE(heard[1].step_length, 1.0);
  EXPECT_EQ(heard.back().residual, report.residual);
}

TEST_F(Bar, GivesTheSameBytesTwiceAndForAnyNumberOfThreads) {
  const Controls controls = pulled({0.3, 0.02, 0.01});
  const NewtonReport report = solve_equilibrium(bar_.model, state_, controls, clamped_);
  ASSERT_TRUE(report.converged);
  for (const int threads : {1, 3}) {
    const SolidModel bar = make_bar(threads);
    State again = bar.model.initial_state();
    (void)solve_equilibrium(bar.model, again, controls, clamped_);
    EXPECT_TRUE(support::same_bits(state_.u, again.u)) << threads;
  }
}

TEST_F(Bar, MayHaveNothingFree) {
  Supports supports;
  for (Index node = 0; node < to_index(bar_.mesh.n_nodes()); ++node)
    supports.place(node, 0.1 * bar_.mesh.X()[at(node)]);
  const Prescribed all = supports.prescribed();
  const NewtonReport report = solve_equilibrium(bar_.model, state_, {}, all);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(state_.u[5].x(), 0.1 * bar_.mesh.X()[5].x(), 1e-15);
}

TEST_F(Bar, NeedsAValueForEveryPrescribedUnknown) {
  Equilibrium equilibrium(bar_.model, clamped_.dofs);
  EXPECT_THROW((void)equilibrium.solve(state_, {}, std::vector<double>(3), {}), BugError);
}

TEST(Newton, TellsTheResidualItselfWhereNothingIsALoad) {
  mechanics::Model model(1);
  const Vec3 X(10, 0, 0);
  model.add(std::make_unique<mechanics::Attachment>(
      model,
      std::vector<mechanics::Attachment::Tie>{
          {mechanics::Anchor::on_node(0, X), mechanics::Anchor::in_space({0, 0, 0})}},
      100.0));
  mechanics::State state = model.initial_state();
  state.u[0] = {1, 2, 3};
  const NewtonReport report = solve_equilibrium(model, state, {}, {}, {.max_iterations = 0});
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "residual still 3.7e+02 mN after 0 iterations");
}

}  // namespace
}  // namespace facies::solve
