// SPDX-License-Identifier: Apache-2.0
// Nothing passes a bone, however far a step would take it: a thin block inside a hollow bone is thrown at its wall by a
// hundred times its thickness. The wall is convex, so that inside is told by its planes, without the library's distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/random.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/attachment.hpp"
#include "facies/mechanics/contact.hpp"
#include "facies/mechanics/loads.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::Anchor;
using mechanics::Contact;
using mechanics::State;

constexpr double thickness = 0.05;         // [mm]
constexpr double way = 100.0 * thickness;  // of a throw
constexpr double mass = 0.1;               // of the bone [kg]
constexpr double g = 9810.0;               // [mm/s^2]
/// At each corner of the bone [mN/mm]: its weight takes it `way` far.
constexpr double spring = mass * g / (6.0 * way);
constexpr mechanics::ContactSettings settings{.d_hat = 0.02, .stiffness = 500.0, .reach = 0.5};

/// An octahedron of 2 mm about the origin, its triangles counter-clockwise from outside.
const std::array<Vec3, 6> corners = {Vec3(2, 0, 0),  Vec3(-2, 0, 0), Vec3(0, 2, 0),
                                     Vec3(0, -2, 0), Vec3(0, 0, 2),  Vec3(0, 0, -2)};
const std::vector<std::array<Index, 3>> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

/// Whether a place in the bone's own frame is within all planes of its wall.
bool is_inside(const Vec3& x) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const std::array<Index, 3>& t) {
    const Vec3& a = corners[at(t[0])];
    const Vec3 normal = (corners[at(t[1])] - a).cross(corners[at(t[2])] - a);
    return normal.dot(x - a) < 0.0;
  });
}

/// A block of 1 x 1 x 0.05 mm in the middle of the bone; all its nodes are points.
class ThinBlockInABone : public ::testing::Test {
 protected:
  ThinBlockInABone() {
    model_.add(std::make_unique<mechanics::NodalForces>());
    model_.add(std::make_unique<mechanics::Gravity>(std::vector<double>(mesh_.n_nodes(), 0.0),
                                                    model_.bodies()));
    model_.add(std::make_unique<mechanics::Solid>(
        mesh_, support::uniform_solid(mesh_, support::neo_hookean(0.5), support::log_volume(2.0)),
        1));
    std::vector<mechanics::ContactPoint> points;
    for (std::size_t node = 0; node < mesh_.n_nodes(); ++node)
      points.push_back({Anchor::on_node(to_index(node), mesh_.X()[node]), 0.02});
    mechanics::ContactSurface wall{"wall", {}, triangles};
    for (const Vec3& corner : corners)
      wall.vertices.push_back(Anchor::on_body(0, corner));
    std::vector<mechanics::Attachment::Tie> ties;
    for (const Vec3& corner : corners)
      ties.push_back({Anchor::on_body(0, corner), Anchor::in_space(corner)});
    model_.add(std::make_unique<mechanics::Attachment>(model_, ties, spring));
    contact_ = &model_.add(std::make_unique<Contact>(model_, points, wall, settings));
  }

  /// The bone where it is, in these of its six unknowns.
  [[nodiscard]] mechanics::Prescribed hold_bone(support::Supports supports,
                                                std::initializer_list<int> components) const {
    mechanics::Prescribed prescribed = supports.prescribed();
    for (const int component : components) {
      prescribed.dofs.push_back(model_.body_dof(0, component));
      prescribed.values.push_back(0.0);
    }
    return prescribed;
  }

  void expect_inside(const State& state) const {
    const mechanics::Pose& bone = state.bodies[0];
    for (std::size_t node = 0; node < mesh_.n_nodes(); ++node) {
      ASSERT_TRUE(is_inside(bone.R.transpose() * (mesh_.X()[node] + state.u[node] - bone.u)))
          << "node " << node;
    }
  }

  /// Iterates one by one, wherever that leads, and looks at the state after each.
  void expect_inside_all_the_way(const mechanics::Controls& controls,
                                 const mechanics::Prescribed& prescribed) {
    Equilibrium equilibrium(model_, prescribed.dofs);
    State state = model_.initial_state();
    for (int iteration = 0; iteration < 12; ++iteration) {
      (void)equilibrium.solve(state, controls, prescribed.values, {.max_iterations = 1});
      expect_inside(state);
    }
    EXPECT_GT(contact_->report(state).n_points, 0) << "it has been thrown at something";
  }

  /// The longest part of a step that is free, found as the solver finds it: a part of a turn is no part of the straight
  /// way that the whole is in the frame of the bone, so every part is looked at anew.
  void go(State& state, std::span<const double> increments) const {
    for (double part = 1.0; part > 1e-9;) {
      State trial = model_.moved(state, model_.bent(state, increments, part), 1.0);
      const double free = model_.longest_step(state, trial);
      if (free == 1.0) {
        state = std::move(trial);
        return;
      }
      part *= std::min(free, 0.999);
    }
  }

  mesh::Mesh mesh_ =
      support::mapped(support::make_block({.size = {1, 1, thickness}, .n = {3, 3, 1}}),
                      [](const Vec3& X) { return Vec3(X - Vec3(0.5, 0.5, 0.5 * thickness)); });
  mechanics::Model model_{mesh_.n_nodes(), {{"bone", Vec3::Zero(), mass, 0.1 * Mat3::Identity()}}};
  const Contact* contact_ = nullptr;
  support::Random random_{17};
};

TEST_F(ThinBlockInABone, StaysInsideWhereverAForceThrowsIt) {
  for (int trial = 0; trial < 6; ++trial) {
    mechanics::Controls thrown;
    thrown.nodal_force.assign(mesh_.n_nodes(), 0.05 * random_.unit_vector());
    const std::array<Index, 1> corner = {0};
    expect_inside_all_the_way(thrown,
                              hold_bone(support::Supports().clamp(corner), {0, 1, 2, 3, 4, 5}));
  }
}

TEST_F(ThinBlockInABone, StaysInsideWhereItsOwnSideIsLedThroughTheWall) {
  for (int trial = 0; trial < 6; ++trial) {
    const Vec3 led = way * random_.unit_vector();
    support::Supports supports;
    for (const Index node : mesh_.nodes("z_max"))
      supports.place(node, led);
    expect_inside_all_the_way({}, hold_bone(supports, {0, 1, 2, 3, 4, 5}));
  }
}

TEST_F(ThinBlockInABone, StaysInsideWhereTheBoneIsThrownOverIt) {
  for (int trial = 0; trial < 6; ++trial) {
    mechanics::Controls falling;
    falling.body_gravity = g * random_.unit_vector();
    expect_inside_all_the_way(
        falling, hold_bone(support::Supports().clamp(mesh_.nodes("z_max")), {3, 4, 5}));
  }
}

TEST_F(ThinBlockInABone, StaysInsideInStepsOfAnySizeInWhichBothMoveAndTurn) {
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<double> increments(model_.n_dofs());
    const double size = way * std::pow(10.0, random_.uniform(-1.0, 2.0));
    const Vec3 together = size * random_.unit_vector();
    for (std::size_t dof = 0; dof < increments.size(); ++dof) {
      const double alone = random_.uniform(-thickness, thickness);
      increments[dof] = dof < 3 * mesh_.n_nodes()
                            ? together(static_cast<Eigen::Index>(dof % 3)) + alone
                            : random_.uniform(-size, size);
    }
    State state = model_.initial_state();
    for (int step = 0; step < 4; ++step) {
      go(state, increments);
      expect_inside(state);
    }
  }
}

}  // namespace
}  // namespace facies::solve
