// SPDX-License-Identifier: Apache-2.0
// Controls between two controls, and a model as the sum of its terms.
#include "support/models.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"

namespace facies::mechanics {
namespace {

Controls controls(double activation, const Vec3& gravity, std::vector<Vec3> nodal_force) {
  Controls controls;
  controls.activation = {activation};
  controls.gravity = gravity;
  controls.nodal_force = std::move(nodal_force);
  return controls;
}

TEST(InterpolatedControls, LieOnTheLineBetweenTheirEnds) {
  const Controls a = controls(0.2, {0, 0, -100}, {{1, 2, 3}});
  const Controls b = controls(0.6, {0, 0, -500}, {{3, 2, -1}});
  const Controls middle = interpolate(a, b, 0.25);
  EXPECT_DOUBLE_EQ(middle.activation[0], 0.3);
  EXPECT_TRUE(middle.gravity.isApprox(Vec3(0, 0, -200)));
  EXPECT_TRUE(middle.nodal_force[0].isApprox(Vec3(1.5, 2, 2)));
}

TEST(InterpolatedControls, AreTheirEndsToTheLastBit) {
  const Controls a = controls(0.1, {0, 0, -0.3}, {{0.1, 0.2, 0.3}});
  const Controls b = controls(0.7, {0, 0, -9800}, {{7, 7, 7}});
  for (const auto& [s, end] : {std::pair{0.0, &a}, std::pair{1.0, &b}}) {
    const Controls at_end = interpolate(a, b, s);
    EXPECT_EQ(at_end.activation, end->activation);
    EXPECT_EQ(at_end.gravity, end->gravity);
    EXPECT_EQ(at_end.nodal_force, end->nodal_force);
  }
}

TEST(InterpolatedControls, TakeNoForcesAsZeroForces) {
  const Controls loaded = controls(0.0, Vec3::Zero(), {{4, 0, 0}, {0, 8, 0}});
  const Controls free = controls(0.0, Vec3::Zero(), {});
  EXPECT_TRUE(interpolate(loaded, free, 0.75).nodal_force[1].isApprox(Vec3(0, 2, 0)));
  EXPECT_TRUE(interpolate(free, loaded, 0.75).nodal_force[0].isApprox(Vec3(3, 0, 0)));
  EXPECT_TRUE(interpolate(free, free, 0.5).nodal_force.empty());
}

TEST(InterpolatedControls, WeighBodiesApartFromTissue) {
  Controls heavy;
  heavy.body_gravity = {0, 0, -400};
  EXPECT_EQ(interpolate({}, heavy, 0.25).body_gravity, Vec3(0, 0, -100));
  EXPECT_EQ(interpolate({}, heavy, 0.25).gravity, Vec3::Zero());
}

TEST(InterpolatedControls, TakeNoExcitationsAsZero) {
  Controls excited;
  excited.excitation = {0.5, 1.0};
  EXPECT_EQ(interpolate({}, excited, 0.5).excitation, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(interpolate(excited, {}, 0.75).excitation, (std::vector<double>{0.125, 0.25}));
  EXPECT_EQ(interpolate(excited, excited, 1.0).excitation, excited.excitation);
}

TEST(InterpolatedControls, MustDriveTheSameMuscles) {
  const Controls none;
  Controls one;
  one.excitation = {0.5};
  Controls two;
  two.excitation = {0.5, 0.5};
  EXPECT_THROW((void)interpolate(one, two, 0.5), BugError);
  EXPECT_THROW((void)interpolate(none, controls(0.5, Vec3::Zero(), {}), 0.5), BugError);
}

TEST(Model, IsTheSumOfItsTerms) {
  Model model(2);
  model.add(std::make_unique<NodalForces>());
  model.add(std::make_unique<Gravity>(std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(model.n_dofs(), 6U);
  State state = model.initial_state();
  ASSERT_EQ(state.u.size(), 2U);
  EXPECT_EQ(state.u[1], Vec3::Zero());
  state.u[0] = {0, 0, 1};
  const Controls loaded = controls(0.0, {0, 0, -10}, {{0, 0, 5}, {1, 0, 0}});
  EXPECT_DOUBLE_EQ(model.energy(state, loaded), -5.0 + 20.0);
  std::vector<double> r(6, 99.0);  // what stood there before must not matter
  ASSERT_TRUE(model.residual(state, loaded, r));
  EXPECT_EQ(r, (std::vector<double>{0, 0, 15, -1, 0, 30}));
}

TEST(Model, RefusesAResidualOfTheWrongLength) {
  const Model model(2);
  std::vector<double> r(5);
  EXPECT_THROW((void)model.residual(model.initial_state(), {}, r), BugError);
}

}  // namespace
}  // namespace facies::mechanics
