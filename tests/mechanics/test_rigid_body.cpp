// SPDX-License-Identifier: Apache-2.0
// Poses of rigid bodies, and points that hang on them.
#include <numbers>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/math/rotation.hpp"
#include "facies/mechanics/anchor.hpp"

namespace facies::mechanics {
namespace {

RigidBody some_body() {
  RigidBody body;
  body.name = "jaw";
  body.centre = {97, 0, 87};
  body.mass = 0.2;
  body.inertia = Vec3(250, 160, 290).asDiagonal();
  return body;
}

TEST(RigidBody, CountsRotationsAsWaysAtItsRadiusOfGyration) {
  // Kinetic energy of a unit of way, m/2, is that of a unit of way of the arm, tr(inertia)/3 / arm^2 / 2, on average, times 3/2.
  const RigidBody body = some_body();
  EXPECT_DOUBLE_EQ(body.arm() * body.arm() * body.mass, 0.5 * (250 + 160 + 290));
  EXPECT_EQ(RigidBody().arm(), 1.0);
}

TEST(Pose, KeepsDistancesAndTurnsAboutTheCentre) {
  const RigidBody body = some_body();
  const Pose pose = moved({}, {1, 2, 3}, {0, 0.5, 0});
  EXPECT_TRUE(place_of(body, pose, body.centre).isApprox(body.centre + Vec3(1, 2, 3)));
  const Vec3 a(50, 10, 90);
  const Vec3 b(130, -40, 130);
  EXPECT_NEAR((place_of(body, pose, a) - place_of(body, pose, b)).norm(), (a - b).norm(), 1e-12);
}

TEST(Pose, StaysARotationAfterManySmallTurns) {
  Pose pose;
  for (int i = 0; i < 1000; ++i)
    pose = moved(pose, Vec3::Zero(), {0.01, 0.0, 0.0});
  EXPECT_TRUE(pose.R.isApprox(rotation_matrix({10.0, 0.0, 0.0}), 1e-12));
  EXPECT_TRUE((pose.R.transpose() * pose.R).isIdentity(1e-12));
}

TEST(ExtrapolatedPose, GoesOnAlongTheLastWayAndTurn) {
  const Pose before = moved({}, {1, 0, 0}, {0.1, 0.2, -0.1});
  const Vec3 turn(0.05, -0.3, 0.2);
  const Pose now = moved(before, {2, 0, 1}, turn);
  const Pose beyond = extrapolate(before, now, 0.5);
  EXPECT_TRUE(beyond.u.isApprox(now.u + Vec3(1, 0, 0.5)));
  EXPECT_TRUE(beyond.R.isApprox(rotation_matrix(1.5 * turn) * before.R, 1e-14));
}

TEST(ExtrapolatedPose, StaysWhereNothingMoved) {
  const Pose pose = moved({}, {1, 0, 0}, {0.1, 0.2, -0.1});
  const Pose beyond = extrapolate(pose, pose, 3.0);
  EXPECT_TRUE(beyond.u.isApprox(pose.u));
  EXPECT_TRUE(beyond.R.isApprox(pose.R, 1e-15));
}

TEST(MovedModel, MovesNodesAndBodiesByTheirIncrements) {
  const Model model(1, {some_body()});
  const double arm = model.bodies()[0].arm();
  const std::vector<double> increments{1, 2, 3, 4, 5, 6, 0.0, 0.0, 0.2 * arm};
  ASSERT_EQ(model.n_dofs(), increments.size());
  const State state = model.moved(model.initial_state(), increments, 0.5);
  EXPECT_TRUE(state.u[0].isApprox(Vec3(0.5, 1, 1.5)));
  EXPECT_TRUE(state.bodies[0].u.isApprox(Vec3(2, 2.5, 3)));
  EXPECT_TRUE(state.bodies[0].R.isApprox(rotation_matrix({0, 0, 0.1}), 1e-15));
}

TEST(Anchor, IsWhereItsNodeBodyOrPlaceIs) {
  const Model model(1, {some_body()});
  State state = model.initial_state();
  state.u[0] = {1, 1, 1};
  state.bodies[0] = moved({}, {0, 0, 5}, {0, 0, 0.5 * std::numbers::pi});
  EXPECT_EQ(place_of(model, state, Anchor::in_space({1, 2, 3})), Vec3(1, 2, 3));
  EXPECT_EQ(place_of(model, state, Anchor::on_node(0, {1, 2, 3})), Vec3(2, 3, 4));
  const Vec3 turned = place_of(model, state, Anchor::on_body(0, {107, 0, 87}));
  EXPECT_TRUE(turned.isApprox(Vec3(97, 10, 92), 1e-14));
}

TEST(Anchor, CountsUnknownsThatSeveralHangOnOnce) {
  const Model model(2, {some_body()});
  const std::vector<Anchor> anchors{Anchor::on_body(0, {1, 0, 0}), Anchor::on_node(1, {0, 0, 0}),
                                    Anchor::on_body(0, {2, 0, 0}), Anchor::in_space({0, 0, 0})};
  EXPECT_EQ(dofs_of(model, anchors), (std::vector<Index>{3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

}  // namespace
}  // namespace facies::mechanics
