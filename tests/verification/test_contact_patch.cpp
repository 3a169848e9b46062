// SPDX-License-Identifier: Apache-2.0
// Tissue pressed on bone: a uniform pressure stays uniform, what one feels the other feels, and nothing passes at any speed.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/math/barrier.hpp"
#include "facies/mechanics/attachment.hpp"
#include "facies/mechanics/contact.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::Anchor;
using support::SolidModel;

constexpr mechanics::ContactSettings settings{.d_hat = 0.2, .stiffness = 100.0, .reach = 2.0};

/// The bottom of a block as contact points, each with its share of the area.
std::vector<mechanics::ContactPoint> bottom_of(const mesh::Mesh& mesh) {
  std::map<Index, double> area;
  for (const mesh::Face& face : mesh::boundary_faces(mesh)) {
    const std::array<mesh::Face, 1> alone = {face};
    const std::vector<Index> nodes = mesh::face_set_nodes(mesh, alone);
    const bool at_bottom = std::all_of(nodes.begin(), nodes.end(),
                                       [&](Index node) { return mesh.X()[at(node)].z() == 0.0; });
    if (!at_bottom) continue;
    for (const Index node : nodes)
      area[node] += mesh::face_area(mesh, face, mesh.X()) / static_cast<double>(nodes.size());
  }
  std::vector<mechanics::ContactPoint> points;
  for (const auto& [node, share] : area)
    points.push_back({Anchor::on_node(node, mesh.X()[at(node)]), share});
  return points;
}

/// A plane at this height in triangles that have nothing to do with the block's faces.
mechanics::ContactSurface plane(double height, const std::function<Anchor(const Vec3&)>& anchor) {
  mechanics::ContactSurface surface{"plane", {}, {}};
  constexpr Index n = 7;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      surface.vertices.push_back(anchor({-3.0 + 1.31 * i, -3.0 + 1.27 * j, height}));
      if (i == n || j == n) continue;
      const Index a = i * (n + 1) + j;
      surface.triangles.push_back({a, a + n + 1, a + n + 2});
      surface.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  return surface;
}

/// A block of 2 x 2 x 1 mm, 0.2 mm above a plane, its sides on rollers.
class BlockOnBone : public ::testing::Test {
 protected:
  static SolidModel make() {
    const mesh::Mesh mesh = support::make_block({.size = {2, 2, 1}, .n = {4, 3, 3}});
    return {mesh, support::uniform_solid(mesh, support::example_law("mooney_rivlin"),
                                         support::log_volume(50.0))};
  }

  [[nodiscard]] support::Supports rollers() const {
    support::Supports supports;
    supports.hold(block_.mesh.nodes("x_min"), 0).hold(block_.mesh.nodes("x_max"), 0);
    supports.hold(block_.mesh.nodes("y_min"), 1).hold(block_.mesh.nodes("y_max"), 1);
    return supports;
  }

  SolidModel block_ = make();
};

TEST_F(BlockOnBone, CarriesAUniformPressureHoweverTheBoneIsCut) {
  const auto& contact = block_.model.add(std::make_unique<mechanics::Contact>(
      block_.model, bottom_of(block_.mesh), plane(-0.2, Anchor::in_space), settings));
  const mechanics::Prescribed pressed =
      rollers().hold(block_.mesh.nodes("z_max"), 2, -0.4).prescribed();
  mechanics::State state = block_.model.initial_state();
  const NewtonReport report =
      solve_equilibrium(block_.model, state, {}, pressed, {.relative_tolerance = 1e-10});
  ASSERT_TRUE(report.converged) << report.reason;

  // One unknown: the distance d. The block is squeezed to 1 - (0.2 + d) of its height; its stress is the barrier's.
  const std::vector<mechanics::ElementMeans> means = block_.solid->means(state, {});
  const mechanics::ContactReport felt = contact.report(state);
  const double d = felt.smallest_distance;
  EXPECT_EQ(felt.n_points, 5 * 4);
  const double p = -settings.stiffness * barrier(d, settings.d_hat).db_dd;
  EXPECT_NEAR(felt.largest_pressure, p, 1e-7 * p);
  for (const mechanics::ElementMeans& element : means) {
    EXPECT_NEAR(element.J, 1.0 - 0.4 + 0.2 - d, 1e-8);
    EXPECT_NEAR(element.sigma.zz, -p, 1e-6 * p);
    EXPECT_NEAR(element.sigma.xz, 0.0, 1e-6 * p);
  }
  EXPECT_NEAR(felt.force.z(), -4.0 * p, 1e-6 * p) << "four square millimetres";
}

TEST_F(BlockOnBone, MovesABodyThatNothingHoldsUntilASpringDoes) {
  // The bone is a free body on a spring of the stiffness of its tie: Newton finds both at once.
  const mechanics::RigidBody bone{"bone", {1, 1, -2}, 0.2, Vec3(250, 150, 280).asDiagonal()};
  mechanics::Model model(block_.mesh.n_nodes(), {bone});
  model.add(std::make_unique<mechanics::Solid>(
      block_.mesh,
      support::uniform_solid(block_.mesh, support::example_law("mooney_rivlin"),
                             support::log_volume(50.0)),
      1));
  const auto on_body = [](const Vec3& X) { return Anchor::on_body(0, X); };
  const auto& contact = model.add(std::make_unique<mechanics::Contact>(
      model, bottom_of(block_.mesh), plane(-0.2, on_body), settings));
  std::vector<mechanics::Attachment::Tie> ties;
  for (const Vec3& X : {Vec3(0, 0, -3), Vec3(2, 0, -3), Vec3(0, 2, -3)})
    ties.push_back({Anchor::on_body(0, X), Anchor::in_space(X)});
  const double stiffness = 100.0;
  model.add(std::make_unique<mechanics::Attachment>(model, ties, stiffness));
  const mechanics::Prescribed pressed =
      rollers().hold(block_.mesh.nodes("z_max"), 2, -0.4).prescribed();
  mechanics::State state = model.initial_state();
  const NewtonReport report =
      solve_equilibrium(model, state, {}, pressed, {.relative_tolerance = 1e-10});
  ASSERT_TRUE(report.converged) << report.reason;
  const double force = contact.report(state).force.z();
  EXPECT_LT(force, -0.1);
  double springs = 0.0;
  for (const mechanics::Attachment::Tie& tie : ties)
    springs += stiffness * (mechanics::place_of(model, state, tie.a) - tie.b.X).z();
  EXPECT_NEAR(springs, force, 1e-6 * std::abs(force)) << "the springs carry what the block gives";
}

TEST_F(BlockOnBone, DoesNotPassAThinBoneThatItIsThrownAt) {
  block_.model.add(std::make_unique<mechanics::Contact>(block_.model, bottom_of(block_.mesh),
                                                        plane(-0.2, Anchor::in_space), settings));
  mechanics::Controls thrown;
  thrown.nodal_force.assign(block_.mesh.n_nodes(), Vec3(0, 0, -0.5));
  mechanics::State state = block_.model.initial_state();
  const NewtonReport report =
      solve_equilibrium(block_.model, state, thrown, rollers().prescribed());
  ASSERT_TRUE(report.converged) << report.reason;
  for (std::size_t node = 0; node < block_.mesh.n_nodes(); ++node)
    EXPECT_GT(block_.mesh.X()[node].z() + state.u[node].z(), -0.2);
}

}  // namespace
}  // namespace facies::solve
