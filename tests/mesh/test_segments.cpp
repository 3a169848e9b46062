// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mesh/segments.hpp"

namespace facies::mesh {
namespace {

TEST(ClosestOnSegment, IsTheFootOfThePerpendicularOrAnEnd) {
  const Vec3 a(0.0, 0.0, 0.0);
  const Vec3 b(4.0, 0.0, 0.0);
  const ClosestPoint middle = closest_on_segment({1.0, 3.0, 4.0}, a, b);
  EXPECT_DOUBLE_EQ(middle.distance, 5.0);
  EXPECT_DOUBLE_EQ(middle.parameter, 0.25);
  EXPECT_EQ(middle.point, Vec3(1.0, 0.0, 0.0));
  const ClosestPoint before = closest_on_segment({-3.0, 4.0, 0.0}, a, b);
  EXPECT_DOUBLE_EQ(before.distance, 5.0);
  EXPECT_EQ(before.parameter, 0.0);
  const ClosestPoint after = closest_on_segment({7.0, 0.0, 4.0}, a, b);
  EXPECT_DOUBLE_EQ(after.distance, 5.0);
  EXPECT_EQ(after.point, b);
}

TEST(ClosestOnSegment, OfASegmentWithoutLengthIsItsPoint) {
  const Vec3 a(1.0, 2.0, 3.0);
  const ClosestPoint closest = closest_on_segment({1.0, 2.0, 5.0}, a, a);
  EXPECT_DOUBLE_EQ(closest.distance, 2.0);
  EXPECT_EQ(closest.point, a);
}

TEST(ClosestOnPolyline, IsNearerThanEverySampledPoint) {
  support::Random random(5);
  std::vector<Vec3> line;
  for (int i = 0; i < 6; ++i)
    line.push_back(random.vector(-10.0, 10.0));
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 p = random.vector(-12.0, 12.0);
    double sampled = 1e9;
    for (std::size_t s = 0; s < line.size(); ++s) {
      for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0;
        sampled = std::min(sampled, (p - (1.0 - t) * line[s] - t * line[(s + 1) % 6]).norm());
      }
    }
    const ClosestPoint closest = closest_on_polyline(p, line, true);
    EXPECT_LE(closest.distance, sampled + 1e-12);
    EXPECT_NEAR(closest.distance, sampled, 0.02);
    const Vec3& a = line[closest.segment];
    const Vec3& b = line[(closest.segment + 1) % 6];
    EXPECT_LT((a + closest.parameter * (b - a) - closest.point).norm(), 1e-12);
    EXPECT_LE(closest.distance, closest_on_polyline(p, line, false).distance);
  }
}

TEST(ClosestOnPolyline, JoinsTheLastPointWithTheFirstOnlyWhereClosed) {
  const std::vector<Vec3> corner{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 2.0, 0.0}};
  const Vec3 p(1.0, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(closest_on_polyline(p, corner, true).distance, 1.0);
  EXPECT_EQ(closest_on_polyline(p, corner, true).segment, 2U);
  EXPECT_DOUBLE_EQ(closest_on_polyline(p, corner).distance, std::sqrt(2.0));
  EXPECT_EQ(closest_on_polyline(p, corner).segment, 0U);
}

TEST(ClosestOnPolyline, AcceptsOnePointAndRefusesNone) {
  const std::vector<Vec3> one{{0.0, 3.0, 4.0}};
  EXPECT_DOUBLE_EQ(closest_on_polyline(Vec3::Zero(), one).distance, 5.0);
  EXPECT_DOUBLE_EQ(closest_on_polyline(Vec3::Zero(), one, true).distance, 5.0);
  EXPECT_THROW((void)closest_on_polyline(Vec3::Zero(), {}), BugError);
}

}  // namespace
}  // namespace facies::mesh
