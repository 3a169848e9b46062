// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/math/continuous_collision.hpp"
#include "facies/math/point_triangle.hpp"

namespace facies {
namespace {

using support::Random;

/// A triangle in the plane z = 0 about the origin, and a point `height` above it.
PointAndTriangle above(double height) {
  return {Vec3(0.0, 0.0, height), Vec3(-2.0, -1.0, 0.0), Vec3(2.0, -1.0, 0.0), Vec3(0.0, 2.0, 0.0)};
}

PointAndTriangle point_moves(const Vec3& by) {
  return {by, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

double distance_at(const PointAndTriangle& x, const PointAndTriangle& v, double t) {
  return std::sqrt(closest_on_triangle(x.p + t * v.p, x.a + t * v.a, x.b + t * v.b, x.c + t * v.c)
                       .distance_squared);
}

TEST(SafeTime, OfAHeadOnPointEndsAtTheFraction) {
  // At 10 % of the height: after 90 % of it, which is 0.9 h / (h + 1) of the way to 1 below the plane.
  for (const double h : {1e-6, 1e-3, 1.0, 50.0}) {
    const PointAndTriangle down = point_moves(Vec3(0.0, 0.0, -(h + 1.0)));
    const double exact = 0.9 * h / (h + 1.0);
    EXPECT_LE(safe_time(above(h), down), exact * (1.0 + 1e-9));
    EXPECT_GE(safe_time(above(h), down), exact * (1.0 - 2e-4));
    EXPECT_NEAR(safe_time(above(h), down, 0.5), 0.5 * h / (h + 1.0), 1e-3 * h);
  }
}

TEST(SafeTime, DoesNotCareWhoMoves) {
  const Vec3 up(0.1, -0.2, 3.0);
  const PointAndTriangle triangle_moves{Vec3::Zero(), up, up, up};
  const PointAndTriangle both_move{-0.5 * up, 0.5 * up, 0.5 * up, 0.5 * up};
  const double t = safe_time(above(1.0), point_moves(-up));
  EXPECT_NEAR(t, 0.3, 1e-3);
  EXPECT_NEAR(safe_time(above(1.0), triangle_moves), t, 1e-12);
  EXPECT_NEAR(safe_time(above(1.0), both_move), t, 1e-12);
}

TEST(SafeTime, OfAPointThatHitsAnEdgeOrAVertexEndsAtTheFraction) {
  // In the plane of the triangle, straight at the middle of the edge ab and at the vertex c, from a distance of 2.
  PointAndTriangle x = above(0.0);
  x.p = Vec3(0.0, -3.0, 0.0);
  EXPECT_NEAR(safe_time(x, point_moves(Vec3(0.0, 4.0, 0.0))), 0.45, 1e-4);
  x.p = Vec3(0.0, 4.0, 0.0);
  EXPECT_NEAR(safe_time(x, point_moves(Vec3(0.0, -4.0, 0.0))), 0.45, 1e-4);
}

TEST(SafeTime, IsOneWithoutMotionAndForACommonOne) {
  for (const double h : {0.0, 1e-14, 1e-6, 1.0}) {
    EXPECT_EQ(safe_time(above(h), {}), 1.0);
    const Vec3 common(3.0, -40.0, 100.0);
    EXPECT_EQ(safe_time(above(h), {common, common, common, common}), 1.0);
  }
}

TEST(SafeTime, IsOneForPointsThatLeaveOrSlide) {
  EXPECT_EQ(safe_time(above(1e-6), point_moves(Vec3(1.0, 1.0, 100.0))), 1.0);
  EXPECT_EQ(safe_time(above(1e-6), point_moves(Vec3(100.0, 1.0, 0.0))), 1.0);
  EXPECT_EQ(safe_time(above(1.0), point_moves(Vec3(0.0, 0.0, -0.89))), 1.0);
}

TEST(SafeTime, LetsAPointPassThatOnlyGrazes) {
  // Past the vertex c at 11 % and at 9 % of the distance at the start.
  PointAndTriangle x = above(0.0);
  const double d0 = 3.0;
  const double fall = std::sqrt(d0 * d0 - 0.11 * 0.11 * d0 * d0);
  x.p = x.c + Vec3(0.0, 0.11 * d0, fall);
  EXPECT_EQ(safe_time(x, point_moves(Vec3(0.0, 0.0, -100.0))), 1.0);
  const double farther = std::sqrt(d0 * d0 - 0.09 * 0.09 * d0 * d0);
  x.p = x.c + Vec3(0.0, 0.09 * d0, farther);
  const double exact = (farther - d0 * std::sqrt(0.1 * 0.1 - 0.09 * 0.09)) / 100.0;
  const double t = safe_time(x, point_moves(Vec3(0.0, 0.0, -100.0)));
  EXPECT_LE(t, exact);
  EXPECT_GE(t, exact - 1e-4);
}

TEST(SafeTime, OfATriangleThatTurnsIntoThePointStopsBefore) {
  // The vertex c swings up through the point's height while a and b rest.
  const PointAndTriangle x = above(0.5);
  const PointAndTriangle v{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3(0.0, 0.0, 6.0)};
  const double t = safe_time(x, v);
  // Contact when the height at the origin, a third of the way from the edge to c, reaches 0.5.
  EXPECT_GT(t, 0.2);
  EXPECT_LT(t, 0.25);
  EXPECT_NEAR(distance_at(x, v, t), 0.05, 1e-4);
}

TEST(SafeTime, NeverLetsTheDistanceFallBelowTheFraction) {
  Random random(1);
  int stopped = 0;
  for (int i = 0; i < 3000; ++i) {
    const double size = std::pow(10.0, random.uniform(-1.0, 1.0));
    const double travel = std::pow(10.0, random.uniform(-1.0, 2.0));
    const PointAndTriangle x{random.vector(-size, size), random.vector(-size, size),
                             random.vector(-size, size), random.vector(-size, size)};
    PointAndTriangle v{random.vector(-travel, travel), random.vector(-travel, travel),
                       random.vector(-travel, travel), random.vector(-travel, travel)};
    if (i % 2 == 0) v.b = v.c = v.a;
    if (i % 3 == 0) v.p = random.uniform(0.5, 3.0) * (x.a + 0.3 * (x.b - x.a) - x.p) + v.a;
    const double t = safe_time(x, v);
    ASSERT_GE(t, 0.0);
    ASSERT_LE(t, 1.0);
    const double smallest = 0.1 * distance_at(x, v, 0.0);
    double reached = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k)
      reached = std::min(reached, distance_at(x, v, t * k / 2000.0));
    ASSERT_GE(reached, smallest * (1.0 - 1e-9));
    if (t == 1.0) continue;
    ++stopped;
    ASSERT_LE(distance_at(x, v, t), smallest * 1.00101);
  }
  EXPECT_GT(stopped, 500);
}

TEST(SafeTime, KeepsTinyDistancesThroughLargeMotions) {
  Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const double gap = std::pow(10.0, random.uniform(-9.0, -3.0));
    const double size = i % 2 == 0 ? 3.0 : 30.0;
    PointAndTriangle x{Vec3::Zero(), random.vector(-size, size), random.vector(-size, size),
                       random.vector(-size, size)};
    Vec3 w = random.vector(0.0, 1.0);
    if (i % 3 == 1) w.x() = 0.0;
    if (i % 3 == 2) w = Vec3::UnitX();
    x.p = (w.x() * x.a + w.y() * x.b + w.z() * x.c) / w.sum() + gap * random.unit_vector();
    PointAndTriangle v{random.vector(-100.0, 100.0), random.vector(-100.0, 100.0),
                       random.vector(-100.0, 100.0), random.vector(-100.0, 100.0)};
    if (i % 4 < 2) {
      v.b = v.a + 0.01 * v.b;
      v.c = v.a + 0.01 * v.c;
    }
    const double t = safe_time(x, v);
    const double d0 = distance_at(x, v, 0.0);
    for (int k = 1; k <= 200; ++k)
      ASSERT_GE(distance_at(x, v, t * k / 200.0), 0.1 * d0 - 1e-12);
  }
}

TEST(SafeTime, IsZeroWhereTheStartIsLostInRounding) {
  EXPECT_EQ(safe_time(above(0.0), point_moves(Vec3(0.0, 0.0, 1.0))), 0.0);
  EXPECT_EQ(safe_time(above(1e-15), point_moves(Vec3(0.0, 0.0, -100.0))), 0.0);
  EXPECT_GT(safe_time(above(1e-9), point_moves(Vec3(0.0, 0.0, -100.0))), 0.0);
}

TEST(SafeTime, IsZeroWhereANumberIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    EXPECT_EQ(safe_time(above(1.0), point_moves(Vec3(0.0, 0.0, bad))), 0.0);
    EXPECT_EQ(safe_time(above(bad), point_moves(Vec3(0.0, 0.0, 1.0))), 0.0);
    PointAndTriangle v;
    v.c.x() = bad;
    EXPECT_EQ(safe_time(above(1.0), v), 0.0);
  }
}

TEST(SafeTime, StopsBeforeATriangleWithoutArea) {
  PointAndTriangle x = above(1.0);
  x.a = Vec3(-2.0, 0.0, 0.0);
  x.b = Vec3(2.0, 0.0, 0.0);
  x.c = Vec3(1.0, 0.0, 0.0);
  EXPECT_NEAR(safe_time(x, point_moves(Vec3(0.0, 0.0, -2.0))), 0.45, 1e-4);
}

TEST(SafeTime, RefusesAFractionThatIsNone) {
  EXPECT_THROW((void)safe_time(above(1.0), {}, 0.0), BugError);
  EXPECT_THROW((void)safe_time(above(1.0), {}, 1.0), BugError);
}

}  // namespace
}  // namespace facies
