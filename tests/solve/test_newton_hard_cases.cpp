// SPDX-License-Identifier: Apache-2.0
// Equilibrium where a textbook's Newton method fails: inverted trial states, indefinite tangents, problems without solution.
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::Controls;
using mechanics::Prescribed;
using mechanics::State;
using support::SolidModel;
using support::Supports;
using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A block on the plane z = 0.
SolidModel make_block_model(const support::BlockOptions& options, const std::string& law) {
  const mesh::Mesh mesh = support::make_block(options);
  return {mesh, support::uniform_solid(mesh, support::example_law(law), support::log_volume(50.0))};
}

Controls loaded_top(const mesh::Mesh& mesh, const Vec3& force) {
  Controls controls;
  controls.nodal_force.assign(mesh.n_nodes(), Vec3::Zero());
  const std::span<const Index> top = mesh.nodes("z_max");
  for (const Index node : top)
    controls.nodal_force[at(node)] = force / double(top.size());
  return controls;
}

/// What was heard of a solution.
struct Heard {
  double smallest_step = 1.0;
  bool met_indefinite = false;
  int without_factorisation = 0;
  std::function<void(const Iteration&)> listen = [this](const Iteration& iteration) {
    if (iteration.number == 0) return;
    smallest_step = std::min(smallest_step, iteration.step_length);
    met_indefinite = met_indefinite || !iteration.exact;
    if (iteration.factorisations == 0) ++without_factorisation;
  };
};

TEST(Newton, PassesByTrialStatesThatAreInsideOut) {
  // Pressed so hard that the full first step turns elements inside out.
  const SolidModel block = make_block_model({.n = {3, 3, 3}, .shake = 0.1}, "fung_orthotropic");
  const Prescribed held = Supports().clamp(block.mesh.nodes("z_min")).prescribed();
  State state = block.model.initial_state();
  Heard heard;
  Equilibrium equilibrium(block.model, held.dofs);
  const NewtonReport report =
      equilibrium.solve(state, loaded_top(block.mesh, {0, 0, -30}), held.values, {}, heard.listen);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_GE(report.inadmissible.element, 0) << "the case does not test what it should";
  EXPECT_LE(report.inadmissible.J, 0.0);
  EXPECT_LT(heard.smallest_step, 1.0);
}

TEST(Newton, PassesByTrialStatesThatAreInsideOutWhilePrescribedUnknownsMove) {
  // The middle of the top is pushed to a tenth of the height in one go.
  const SolidModel block =
      make_block_model({.size = {2, 2, 1}, .n = {6, 6, 3}}, "fung_orthotropic");
  Supports supports;
  supports.clamp(block.mesh.nodes("z_min"));
  for (const Index node : block.mesh.nodes("z_max")) {
    const Vec3 X = block.mesh.X()[at(node)];
    if ((X - Vec3(1, 1, 1)).norm() < 0.4) supports.place(node, {0, 0, -0.7});
  }
  const Prescribed pushed = supports.prescribed();
  State state = block.model.initial_state();
  Heard heard;
  Equilibrium equilibrium(block.model, pushed.dofs);
  const NewtonReport report = equilibrium.solve(state, {}, pushed.values, {}, heard.listen);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_GE(report.inadmissible.element, 0) << "the case does not test what it should";
}

/// A slender column, its base clamped, its top pressed down by 10 % and kept from turning.
class Column : public ::testing::Test {
 protected:
  void SetUp() override {
    Supports supports;
    supports.clamp(column_.mesh.nodes("z_min"));
    supports.hold(column_.mesh.nodes("z_max"), 2, -1.0);
    supports.hold(column_.mesh.nodes("z_max"), 1, 0.0);
    pressed_ = supports.prescribed();
  }

  /// Pushed to one side by a thousandth of a millimetre, so that it knows where to buckle.
  [[nodiscard]] State slightly_bent() const {
    State state = column_.model.initial_state();
    for (std::size_t node = 0; node < state.u.size(); ++node)
      state.u[node].x() = 1e-3 * std::sin(0.15 * column_.mesh.X()[node].z());
    return state;
  }

  /// Sideways displacement of the middle of the top [mm].
  [[nodiscard]] double sway(const State& state) const {
    return state.u[at(column_.mesh.nodes("z_max")[0])].x();
  }

  [[nodiscard]] int negative_eigenvalues(const State& state) const {
    const Assembly assembly(column_.model, pressed_.dofs);
    std::vector<double> values(assembly.pattern().n_nonzeros());
    assembly.tangent(state, {}, 0.0, values, {}, {});
    SymmetricFactor factor(assembly.pattern());
    return factor.factorise(values);
  }

  SolidModel column_ = make_block_model({.size = {1, 1, 10}, .n = {2, 2, 10}}, "mooney_rivlin");
  Prescribed pressed_;
};

TEST_F(Column, BucklesThroughIndefiniteTangents) {
  State state = slightly_bent();
  Heard heard;
  Equilibrium equilibrium(column_.model, pressed_.dofs);
  const NewtonReport report = equilibrium.solve(state, {}, pressed_.values, {}, heard.listen);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_TRUE(heard.met_indefinite) << "the case does not test what it should";
  EXPECT_GT(std::abs(sway(state)), 1.0);
  EXPECT_EQ(negative_eigenvalues(state), 0) << "a stable equilibrium";
  EXPECT_GT(heard.without_factorisation, 0) << "a factor is used again";
  EXPECT_LT(report.factorisations, report.iterations);
}

TEST_F(Column, HasLessEnergyBentThanStraight) {
  const NewtonSettings exact{.relative_tolerance = 1e-8};
  // Held in its plane of symmetry it stays straight; nothing pushes on that hold, so it is an equilibrium without it too.
  Supports supports;
  supports.clamp(column_.mesh.nodes("z_min"));
  supports.hold(column_.mesh.nodes("z_max"), 2, -1.0);
  supports.hold(column_.mesh.nodes("z_max"), 1, 0.0);
  for (Index node = 0; node < to_index(column_.mesh.n_nodes()); ++node) {
    const Vec3& X = column_.mesh.X()[at(node)];
    if (X.z() > 0.0 && std::abs(X.x() - 0.5) < 1e-9) supports.hold(std::array{node}, 0, 0.0);
  }
  State straight = column_.model.initial_state();
  const NewtonReport held =
      solve_equilibrium(column_.model, straight, {}, supports.prescribed(), exact);
  ASSERT_TRUE(held.converged) << held.reason;
  Equilibrium free_sideways(column_.model, pressed_.dofs);
  EXPECT_LE(free_sideways.residual_norm(straight, {}), 1e-5);
  EXPECT_GT(negative_eigenvalues(straight), 0) << "an equilibrium that is not stable";

  State bent = slightly_bent();
  const NewtonReport buckled = solve_equilibrium(column_.model, bent, {}, pressed_, exact);
  ASSERT_TRUE(buckled.converged) << buckled.reason;
  EXPECT_LT(column_.model.energy(bent, {}), 0.9 * column_.model.energy(straight, {}));
}

TEST(Newton, DoesNotCallTornTissueAnAnswer) {
  // Pulled harder than the volumetric law can hold (3 kappa / e), the block flies apart and its energy falls for ever.
  const SolidModel block = make_block_model({.n = {2, 2, 2}}, "fung_orthotropic");
  State state = block.model.initial_state();
  const NewtonReport report = solve_equilibrium(
      block.model, state, loaded_top(block.mesh, {0, 0, 200}),
      Supports().clamp(block.mesh.nodes("z_min")).prescribed(), {.max_iterations = 500});
  EXPECT_FALSE(report.converged);
  EXPECT_THAT(report.reason, HasSubstr("tears"));
  EXPECT_GE(report.inadmissible.element, 0);
  EXPECT_GT(report.inadmissible.J, std::exp(2.0));
  EXPECT_LT(report.iterations, 100);
}

TEST(Newton, RefusesABalanceWhereALawNoLongerHolds) {
  // Blown up to more than e^2 times its volume and held there: in balance, and torn.
  const SolidModel block = make_block_model({.n = {1, 1, 1}}, "mooney_rivlin");
  const double lambda = 2.0;  // J = 8
  State state = support::affine_state(block.mesh, lambda * Mat3::Identity());
  Supports all;
  for (Index node = 0; node < to_index(block.mesh.n_nodes()); ++node)
    all.place(node, state.u[at(node)]);
  const NewtonReport report = solve_equilibrium(block.model, state, {}, all.prescribed());
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.inadmissible.element, 0);
  EXPECT_NEAR(report.inadmissible.J, lambda * lambda * lambda, 1e-12);
}

TEST(Newton, SaysWhereTheStateItStartsFromIsInsideOut) {
  const SolidModel block = make_block_model({.n = {2, 2, 2}}, "mooney_rivlin");
  State state = block.model.initial_state();
  state.u[26] = {0, 0, -2.0};  // the last node, and with it the last element
  const NewtonReport report = solve_equilibrium(
      block.model, state, {}, Supports().clamp(block.mesh.nodes("z_min")).prescribed());
  EXPECT_FALSE(report.converged);
  EXPECT_THAT(report.reason, HasSubstr("inadmissible"));
  EXPECT_EQ(report.inadmissible.element, 7);
  EXPECT_LT(report.inadmissible.J, 0.0);
}

TEST(Newton, EndsWithAReasonWhereNothingHoldsTheBody) {
  const SolidModel block = make_block_model({.n = {2, 2, 2}}, "mooney_rivlin");
  State state = block.model.initial_state();
  const NewtonReport report = solve_equilibrium(
      block.model, state, loaded_top(block.mesh, {0, 0, -1}), {}, {.max_iterations = 10});
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

TEST(Newton, NeverConvergesToNotANumber) {
  const SolidModel block = make_block_model({.n = {2, 2, 2}}, "mooney_rivlin");
  Supports supports;
  supports.clamp(block.mesh.nodes("z_min"));
  const Prescribed held = supports.prescribed();
  State state = block.model.initial_state();
  NewtonReport report =
      solve_equilibrium(block.model, state, loaded_top(block.mesh, {0, nan, 0}), held);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());

  supports.place(26, {0, 0, nan});
  state = block.model.initial_state();
  report = solve_equilibrium(block.model, state, {}, supports.prescribed());
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

TEST(Newton, EndsWithAReasonWhereTheEnergyOverflows) {
  // exp(Q) of the skin law is infinite at fifty times the length.
  const SolidModel block = make_block_model({.n = {2, 2, 2}}, "fung_orthotropic");
  State state = support::affine_state(block.mesh, Vec3(1, 1, 50).asDiagonal());
  Equilibrium equilibrium(block.model,
                          Supports().clamp(block.mesh.nodes("z_min")).prescribed().dofs);
  EXPECT_EQ(equilibrium.residual_norm(state, {}), std::numeric_limits<double>::infinity());
  const NewtonReport report =
      equilibrium.solve(state, {}, std::vector<double>(equilibrium.prescribed().size(), 0.0), {});
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace facies::solve
