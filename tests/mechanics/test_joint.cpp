// SPDX-License-Identifier: Apache-2.0
// Guides hold from both sides, stops from one.
#include <gtest/gtest.h>

#include "facies/mechanics/joint.hpp"

namespace facies::mechanics {
namespace {

TEST(Joint, StopsLetGoAndHoldBack) {
  const Model model(1);
  const Vec3 normal = Vec3(1, 0, 2).normalized();
  const Joint joint(model, {}, {{"wall", Anchor::on_node(0, {5, 5, 5}), {5, 5, 5}, normal}}, 1e6);
  State state = model.initial_state();
  state.u[0] = 0.3 * normal + Vec3(0, 7, 0);
  EXPECT_NEAR(joint.distance(state, 0), 0.3, 1e-14);
  EXPECT_EQ(joint.stop_reaction(state, 0), Vec3::Zero());
  EXPECT_EQ(joint.energy(state, {}), 0.0);
  state.u[0] = -0.3 * normal;
  EXPECT_NEAR(joint.distance(state, 0), -0.3, 1e-14);
  EXPECT_TRUE(joint.stop_reaction(state, 0).isApprox(1e6 * (0.3 - 0.005) * normal, 1e-12));
}

TEST(Joint, StopsBearABiteWithoutSinkingInVisibly) {
  // 300 N on one side: 0.035 mm.
  const Model model(1);
  const Joint joint(model, {}, {{"bite", Anchor::on_node(0, {0, 0, 0}), {0, 0, 0}, Vec3::UnitZ()}});
  State state = model.initial_state();
  state.u[0] = {0, 0, -0.035};
  EXPECT_NEAR(joint.stop_reaction(state, 0).z(), 300e3, 1.0);
}

TEST(Joint, GuidesHoldFromBothSidesAlongTheNormal) {
  const Model model(1);
  const SweptCurve slope = swept_curve(10.0, 0.0, 4.0, 4.0, -1.0, -1.0);
  const Joint joint(model, {{"TMJ", Anchor::on_node(0, {8, 3, -2}), slope}}, {}, 1e6);
  State state = model.initial_state();
  EXPECT_NEAR(joint.view(state, 0).distance, 0.0, 1e-14);
  const Vec3 normal = Vec3(-1, 0, 1).normalized();
  for (const double d : {-0.2, 0.2}) {
    state.u[0] = d * normal + Vec3(0, 9, 0);
    EXPECT_NEAR(joint.view(state, 0).distance, d, 1e-14);
    EXPECT_TRUE(joint.guide_reaction(state, 0).isApprox(-1e6 * d * normal, 1e-10));
  }
}

TEST(Joint, GuidesBearTheStrongestMuscleWithinTwentyMicrometres) {
  const Model model(1);
  const Joint joint(
      model, {{"TMJ", Anchor::on_node(0, {0, 0, 0}), swept_curve(0.0, 0.0, 12.0, 0.0, 0.0, 0.0)}},
      {});
  State state = model.initial_state();
  state.u[0] = {0, 0, 0.019};
  EXPECT_NEAR(joint.guide_reaction(state, 0).z(), -190e3, 1.0);
}

}  // namespace
}  // namespace facies::mechanics
