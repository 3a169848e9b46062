// SPDX-License-Identifier: Apache-2.0
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/math/radial_warp.hpp"

namespace facies {
namespace {

using support::Random;

std::vector<Vec3> random_points(Random& random, int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    points.push_back(random.vector(-50.0, 50.0));
  return points;
}

TEST(RadialWarp, TakesEveryPointToItsPlace) {
  Random random(1);
  const std::vector<Vec3> from = random_points(random, 60);
  std::vector<Vec3> to = from;
  for (Vec3& x : to)
    x += random.vector(-5.0, 5.0);
  const RadialWarp warp(from, to);
  for (std::size_t i = 0; i < from.size(); ++i)
    EXPECT_LT((warp(from[i]) - to[i]).norm(), 1e-9);
}

TEST(RadialWarp, IsAffineWhereThePointsAre) {
  Random random(2);
  const std::vector<Vec3> from = random_points(random, 20);
  Mat3 A;
  A << 1.1, 0.2, 0.0, -0.1, 0.9, 0.3, 0.0, 0.1, 1.2;
  const Vec3 b(3.0, -2.0, 7.0);
  std::vector<Vec3> to;
  for (const Vec3& x : from)
    to.emplace_back(A * x + b);
  const RadialWarp warp(from, to);
  for (int i = 0; i < 20; ++i) {
    const Vec3 x = random.vector(-200.0, 200.0);
    EXPECT_LT((warp(x) - (A * x + b)).norm(), 1e-8);
  }
}

TEST(RadialWarp, MovesWhatIsBetweenPointsWithThem) {
  std::vector<Vec3> from;
  for (int i = 0; i < 8; ++i)
    from.emplace_back((i & 1) != 0 ? 10.0 : -10.0, (i & 2) != 0 ? 10.0 : -10.0,
                      (i & 4) != 0 ? 10.0 : -10.0);
  from.emplace_back(0.0, 0.0, 0.0);
  std::vector<Vec3> to = from;
  to.back() = Vec3(0.0, 0.0, 2.0);
  const RadialWarp warp(from, to);
  double before = 2.0;
  for (const double x : {1.0, 3.0, 5.0, 7.0}) {
    const double moved = warp({x, 0.0, 0.0}).z();
    EXPECT_LT(moved, before);
    EXPECT_GT(moved, 0.0);
    before = moved;
  }
}

TEST(RadialWarp, HasNoKinkAtItsPointsWhereItIsRoundedOff) {
  Random random(3);
  const std::vector<Vec3> from = random_points(random, 30);
  std::vector<Vec3> to = from;
  for (Vec3& x : to)
    x += random.vector(-5.0, 5.0);
  const RadialWarp sharp(from, to);
  const RadialWarp rounded(from, to, 10.0);
  // How much the slope to the one side differs from that to the other, for smaller and smaller steps.
  const auto kink = [&](const RadialWarp& warp, double h) {
    const Vec3 step = h * Vec3::UnitX();
    return ((warp(from[0] + step) + warp(from[0] - step) - 2.0 * warp(from[0])) / h).norm();
  };
  EXPECT_NEAR(kink(sharp, 1e-4), kink(sharp, 1e-2), 1e-2 * kink(sharp, 1e-2));
  EXPECT_NEAR(kink(rounded, 1e-2), 1e-2 * kink(rounded, 1.0), 2e-3 * kink(rounded, 1.0));
  for (std::size_t i = 0; i < from.size(); ++i)
    EXPECT_LT((rounded(from[i]) - to[i]).norm(), 1e-8);
}

TEST(RadialWarp, RefusesPointsThatDetermineNoMap) {
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  EXPECT_THROW(RadialWarp(flat, flat), BugError);
  const std::vector<Vec3> twice{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  EXPECT_THROW(RadialWarp(twice, twice), BugError);
  EXPECT_THROW(RadialWarp(twice, flat), BugError);
}

}  // namespace
}  // namespace facies
