// SPDX-License-Identifier: Apache-2.0
// The paper's release on a small scale: held nodes become free with their reactions as forces on them, and the forces fade.
#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::Controls;
using mechanics::State;
using support::BlockCells;
using support::SolidModel;

constexpr double tsf = 1.10;

class Release : public ::testing::TestWithParam<BlockCells> {
 protected:
  static SolidModel make() {
    const mesh::Mesh mesh =
        support::make_block({.size = {6, 4, 2}, .n = {5, 4, 2}, .cells = GetParam(), .shake = 0.2});
    return {mesh, support::uniform_solid(
                      mesh, support::example_law("fung_orthotropic", support::Random(2).rotation()),
                      support::log_volume(250.0), tsf * Mat3::Identity())};
  }

  /// Tension: the bottom clamped in place, equilibrium, and what holds the bottom.
  void SetUp() override {
    const mechanics::Prescribed clamped =
        support::Supports().clamp(block_.mesh.nodes("z_min")).prescribed();
    const NewtonReport report = solve_equilibrium(block_.model, state_, {}, clamped, exact_);
    ASSERT_TRUE(report.converged) << report.reason;
    std::vector<double> r(block_.model.n_dofs());
    ASSERT_TRUE(block_.model.residual(state_, {}, r));
    reactions_.nodal_force.assign(block_.mesh.n_nodes(), Vec3::Zero());
    for (const Index dof : clamped.dofs)
      reactions_.nodal_force[at(dof / 3)](dof % 3) = r[at(dof)];
  }

  /// Three nodes of the bottom, held just so that the block cannot move as a whole.
  [[nodiscard]] mechanics::Prescribed three_points() const {
    support::Supports supports;
    for (const Index node : block_.mesh.nodes("z_min")) {
      const Vec3 X = block_.mesh.X()[at(node)];
      if (X == Vec3(0, 0, 0)) supports.place(node, Vec3::Zero());
      if (X == Vec3(6, 0, 0)) supports.hold({&node, 1}, 1).hold({&node, 1}, 2);
      if (X == Vec3(0, 4, 0)) supports.hold({&node, 1}, 2);
    }
    return supports.prescribed();
  }

  const NewtonSettings exact_{.relative_tolerance = 1e-11, .absolute_tolerance = 0.0};
  SolidModel block_ = make();
  State state_ = block_.model.initial_state();
  Controls reactions_;  ///< as forces
};

TEST_P(Release, DoesNotMoveAnythingWhileTheReactionsAct) {
  double largest = 0.0;
  for (const Vec3& force : reactions_.nodal_force)
    largest = std::max(largest, force.norm());
  EXPECT_GT(largest, 0.1) << "the case does not test what it should";

  const State held = state_;
  Equilibrium free(block_.model, three_points().dofs);
  EXPECT_LE(free.residual_norm(state_, reactions_), 1e-8 * largest);
  const std::vector<double> places(free.prescribed().size(), 0.0);
  const NewtonReport report = free.solve(state_, reactions_, places, {});
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_TRUE(support::same_bits(state_.u, held.u));
}

TEST_P(Release, EndsInTheStressFreeState) {
  Equilibrium free(block_.model, three_points().dofs);
  const std::vector<double> places(free.prescribed().size(), 0.0);
  Controls nothing;
  Observer silent;
  StepSettings settings;
  settings.first_increment = 0.25;
  settings.newton.relative_tolerance = 1e-12;
  settings.newton.absolute_tolerance = 1e-10;
  const StepReport report =
      advance(free, state_, reactions_, nothing, places, settings, {}, silent);
  ASSERT_TRUE(report.converged) << report.last.reason;
  EXPECT_GE(report.increments, 2);
  // What is left is the block divided by TSF about the node that stayed where it was.
  for (std::size_t node = 0; node < state_.u.size(); ++node) {
    const Vec3 X = block_.mesh.X()[node];
    EXPECT_LE((X + state_.u[node] - X / tsf).norm(), 1e-8);
  }
  for (const mechanics::ElementMeans& means : block_.solid->means(state_, {})) {
    EXPECT_LE(std::sqrt(double_dot(means.sigma, means.sigma)), 1e-7);
    EXPECT_NEAR(means.J, 1.0, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, Release,
                         ::testing::Values(BlockCells::hexahedra, BlockCells::wedges,
                                           BlockCells::mixed),
                         [](const auto& which) { return support::name_of(which.param); });

}  // namespace
}  // namespace facies::solve
