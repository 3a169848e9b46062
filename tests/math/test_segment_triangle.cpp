// SPDX-License-Identifier: Apache-2.0
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/math/segment_triangle.hpp"

namespace facies {
namespace {

using support::Random;

const Vec3 a(0.0, 0.0, 0.0);
const Vec3 b(4.0, 0.0, 0.0);
const Vec3 c(0.0, 4.0, 0.0);

TEST(ASegment, PassesThroughATriangleWhereItsPointAndTheTrianglesAreTheSame) {
  Random random(1);
  int n_through = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 A = random.vector(-3.0, 3.0);
    const Vec3 B = random.vector(-3.0, 3.0);
    const Vec3 C = random.vector(-3.0, 3.0);
    // Through a point of the triangle's plane that is known to be inside of it or outside.
    const double s = random.uniform(-0.5, 1.5);
    const double t = random.uniform(-0.5, 1.5);
    const Vec3 on_plane = A + s * (B - A) + t * (C - A);
    const Vec3 p = on_plane + random.vector(-2.0, 2.0);
    const double place = random.uniform(0.1, 0.9);
    const Vec3 q = p + (on_plane - p) / place;
    const bool is_inside = s > 0.0 && t > 0.0 && s + t < 1.0;
    const auto found = segment_through_triangle(p, q, A, B, C);
    ASSERT_EQ(found.has_value(), is_inside);
    if (!found) continue;
    EXPECT_NEAR(*found, place, 1e-7);
    ++n_through;
  }
  EXPECT_GT(n_through, 50);
}

TEST(ASegment, DoesNotPassThroughATriangleThatItOnlyReaches) {
  EXPECT_FALSE(segment_through_triangle({1.0, 1.0, 2.0}, {1.0, 1.0, 1.0}, a, b, c).has_value());
  EXPECT_FALSE(segment_through_triangle({1.0, 1.0, 2.0}, {1.0, 1.0, 0.0}, a, b, c).has_value());
  EXPECT_FALSE(segment_through_triangle({-1.0, 1.0, 0.0}, {5.0, 1.0, 0.0}, a, b, c).has_value());
}

TEST(ASegment, PassesThroughTheBorderOfATriangleButNotThroughOneWithoutArea) {
  EXPECT_EQ(segment_through_triangle({2.0, 0.0, 1.0}, {2.0, 0.0, -3.0}, a, b, c), 0.25);
  EXPECT_EQ(segment_through_triangle({0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, a, b, c), 0.5);
  EXPECT_FALSE(
      segment_through_triangle({2.0, 0.0, 1.0}, {2.0, 0.0, -3.0}, a, b, 0.5 * b).has_value());
}

}  // namespace
}  // namespace facies
