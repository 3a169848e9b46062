// SPDX-License-Identifier: Apache-2.0
// A body that hangs on a muscle: it comes to rest under the point that holds it, as low as its weight stretches the muscle.
#include <cmath>
#include <numbers>

#include "support/bisection.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/hill_muscle.hpp"
#include "facies/mechanics/loads.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::Anchor;

constexpr double weight = 0.5 * 9800.0;  // [mN]
const mechanics::HillParameters muscle{20000.0, 40.0, 60.0, 0.25, 0.5, 0.0};

/// Half a kilogram that hangs by a point 10 mm above its centre, swung aside and turned by half a radian.
class HangingBody : public ::testing::Test {
 protected:
  /// Comes to rest under a place so high above the point when nothing has moved [mm]. A turn about the vertical, which nothing
  /// resists, is held.
  void settle(double height, double excitation) {
    held_at_ = top_.X + Vec3(0, 0, height);
    model_.add(std::make_unique<mechanics::Gravity>(std::vector<double>{}, model_.bodies()));
    muscles_ = &model_.add(std::make_unique<mechanics::HillMuscles>(
        model_,
        std::vector<mechanics::HillMuscle>{{"rope", Anchor::in_space(held_at_), top_, muscle}}));
    state_ = model_.initial_state();
    state_.bodies[0] = mechanics::moved({}, {5, -3, 0}, {0.3, 0.4, 0});
    controls_.body_gravity = {0, 0, -9800};
    controls_.excitation = {excitation};
    const NewtonReport report =
        solve_equilibrium(model_, state_, controls_, {{model_.body_dof(0, 5)}, {0.0}});
    ASSERT_TRUE(report.converged) << report.reason;
  }

  Anchor top_ = Anchor::on_body(0, {0, 0, 10});
  Vec3 held_at_ = Vec3::Zero();
  mechanics::Model model_{0, {{"bob", {0, 0, 0}, 0.5, Vec3(100, 100, 100).asDiagonal()}}};
  const mechanics::HillMuscles* muscles_ = nullptr;
  mechanics::State state_;
  mechanics::Controls controls_;
};

TEST_F(HangingBody, StretchesAPassiveMuscleInProportionToItsWeight) {
  settle(45.0, 0.0);
  const double expected = 40.0 + weight / (0.5 * 20000.0) * 20.0;
  EXPECT_NEAR(muscles_->length(state_, 0), expected, 1e-6);
  EXPECT_NEAR(muscles_->force(state_, controls_, 0), weight, 1e-4);
}

TEST_F(HangingBody, ComesToRestUnderThePointThatHoldsIt) {
  settle(45.0, 0.0);
  const Vec3 centre = state_.bodies[0].u;
  const Vec3 top = place_of(model_, state_, top_);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(centre(axis), held_at_(axis), 1e-6);
    EXPECT_NEAR(top(axis), held_at_(axis), 1e-6);
  }
  EXPECT_NEAR(top.z() - centre.z(), 10.0, 1e-9);
}

TEST_F(HangingBody, IsCarriedByAnExcitedMuscle) {
  // Below the optimal length the printed law has its active part alone.
  settle(33.0, 0.6);
  const double length = support::bisect(
      [](double l) {
        const double l_n = (l - 10.0) / 30.0;
        return 0.6 * 20000.0 * 0.5 * (1.0 + std::cos(2.0 * std::numbers::pi * l_n)) - weight;
      },
      25.0, 40.0);
  EXPECT_NEAR(muscles_->length(state_, 0), length, 1e-6);
}

}  // namespace
}  // namespace facies::solve
