// SPDX-License-Identifier: Apache-2.0
// Distance from the path of a condyle, and the rounded corner of what sets in at a threshold.
#include "support/random.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/math/smooth_ramp.hpp"
#include "facies/math/swept_curve.hpp"

namespace facies {
namespace {

using support::remainder_slope;

/// The path of the reference face's condyles: 12 mm forward, 5 mm down.
SweptCurve condyle_path() {
  return swept_curve(137.443078, 132.346035, 12.0, 5.0, -0.6981317007977318, -0.17453292519943295);
}

Vec3 on_path(double s, double y) {
  const SweptCurve c = condyle_path();
  const double inside = std::clamp(s, 0.0, c.travel);
  const double slope = c.a1 + 2.0 * c.a2 * inside + 3.0 * c.a3 * inside * inside;
  const double z = inside * (c.a1 + inside * (c.a2 + inside * c.a3)) + (s - inside) * slope;
  return {c.x0 - s, y, c.z0 + z};
}

TEST(SweptCurve, HasTheCoefficientsAndPointsOfTheReferenceJaw) {
  const SweptCurve c = condyle_path();
  EXPECT_NEAR(c.a3, -0.00027313397683216274, 1e-15);
  EXPECT_NEAR(c.a2, 0.026733027232908046, 1e-14);
  EXPECT_NEAR(c.a1, -0.6981317007977318, 1e-14);
  for (const auto& [s, z] :
       {std::pair{0.6, -0.40931}, {3.0, -1.86117}, {6.0, -3.2854}, {9.0, -4.31692}, {12.0, -5.0}}) {
    EXPECT_LE(std::abs(view(c, {c.x0 - s, 7.0, c.z0 + z}).distance), 1e-5) << s;
  }
}

TEST(SweptCurve, IsAsFarAwayAsItsNearestPoint) {
  const SweptCurve c = condyle_path();
  support::Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 x(random.uniform(115.0, 145.0), random.uniform(-60.0, 60.0),
                 random.uniform(118.0, 140.0));
    double nearest = 1e9;
    for (double s = -40.0; s <= 50.0; s += 0.001)
      nearest = std::min(nearest, (on_path(s, x.y()) - x).norm());
    const SurfaceView seen = view(c, x);
    EXPECT_GE(nearest, std::abs(seen.distance) - 1e-12);
    EXPECT_LE(nearest, std::hypot(seen.distance, 0.0007));  // half a step along the path
    EXPECT_NEAR((x - on_path(seen.travel, x.y()) - seen.distance * seen.normal).norm(), 0.0, 1e-11);
  }
}

TEST(SweptCurve, LiesBelowWhatHasAPositiveDistance) {
  const SweptCurve c = condyle_path();
  EXPECT_GT(view(c, {130.0, 0.0, 140.0}).distance, 0.0);
  EXPECT_LT(view(c, {130.0, 0.0, 120.0}).distance, 0.0);
}

TEST(SweptCurve, HasTheDerivativesOfItsDistance) {
  const SweptCurve c = condyle_path();
  support::Random random(8);
  for (const double s : {-6.0, 1.0, 5.0, 11.0, 20.0}) {
    for (const double away : {-6.0, 0.01, 2.3}) {
      const SurfaceView on = view(c, on_path(s, 0.0));
      const Vec3 x = on_path(s, -48.0) + away * on.normal;
      const SurfaceView seen = view(c, x);
      ASSERT_NEAR(seen.travel, s, 1e-9);
      const Vec3 d = random.unit_vector();
      const auto distance = [&](double h) { return view(c, x + h * d).distance; };
      EXPECT_GE(remainder_slope(distance, seen.normal.dot(d)), 1.9) << s << " " << away;
      const auto normal = [&](double h) { return Eigen::VectorXd(view(c, x + h * d).normal); };
      EXPECT_GE(remainder_slope(normal, Eigen::VectorXd(seen.second * d)), 1.9) << s << " " << away;
    }
  }
}

TEST(SweptCurve, ContinuesStraightWithoutAKink) {
  const SweptCurve c = condyle_path();
  for (const double end : {0.0, 12.0}) {
    for (const double away : {-2.0, 2.0}) {
      const Vec3 at_end = on_path(end, 0.0) + away * view(c, on_path(end, 0.0)).normal;
      const Vec3 step(1e-9, 0.0, 0.0);
      const SurfaceView before = view(c, at_end - step);
      const SurfaceView after = view(c, at_end + step);
      EXPECT_NEAR(before.distance, after.distance, 3e-9);
      EXPECT_LE((before.normal - after.normal).norm(), 1e-9);
    }
  }
}

TEST(SweptCurve, AnswersEverywhere) {
  const SweptCurve c = condyle_path();
  support::Random random(21);
  for (int i = 0; i < 1000; ++i) {
    const SurfaceView seen = view(c, random.vector(-1e4, 1e4));
    EXPECT_TRUE(std::isfinite(seen.distance) && seen.second.allFinite());
  }
}

TEST(SweptCurve, IsMetWhereItPasses) {
  // s^2 / 20: points whose coordinates, and with them their distance, are exact.
  const SweptCurve valley = swept_curve(0.0, 0.0, 20.0, -20.0, 0.0, 2.0);
  for (const double s : {0.0, 2.5, 5.0, 10.0, 20.0}) {
    const SurfaceView seen =
        view(valley, {-s, 7.0, s * (valley.a1 + s * (valley.a2 + s * valley.a3))});
    EXPECT_NEAR(seen.distance, 0.0, 1e-12) << "at " << s;
    EXPECT_NEAR(seen.travel, s, 1e-9);
  }
}

TEST(SmoothRamp, IsTheRampOutsideOfItsCornerAndNearItInside) {
  const double h = 0.3;
  for (double x = -2.0; x <= 2.0; x += 0.01) {
    const double exact = std::max(x, 0.0);
    EXPECT_LE(std::abs(smooth_ramp(x, h).value - exact), std::abs(x) >= h ? 1e-16 : h / 4.0 + 1e-12)
        << x;
  }
}

TEST(SmoothRamp, IsTheDerivativeOfItsIntegralAndHasItsSlope) {
  const double h = 0.3;
  for (const double x : {-1.0, -0.2, 0.1, 0.25, 0.9}) {
    const Ramp ramp = smooth_ramp(x, h);
    EXPECT_GE(remainder_slope([&](double t) { return smooth_ramp(x + t, h).integral; }, ramp.value),
              1.9);
    EXPECT_GE(remainder_slope([&](double t) { return smooth_ramp(x + t, h).value; }, ramp.slope),
              1.9);
  }
}

TEST(SmoothRamp, HasNoJumpsWhereItsPiecesMeet) {
  const double h = 0.3;
  for (const double x : {-h, h}) {
    const Ramp below = smooth_ramp(x - 1e-12, h);
    const Ramp above = smooth_ramp(x + 1e-12, h);
    EXPECT_NEAR(below.integral, above.integral, 1e-11);
    EXPECT_NEAR(below.value, above.value, 1e-11);
    EXPECT_NEAR(below.slope, above.slope, 1e-10);
  }
}

}  // namespace
}  // namespace facies
