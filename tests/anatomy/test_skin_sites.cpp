// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "facies/anatomy/skin_sites.hpp"

namespace facies::anatomy {
namespace {

/// A sheet of 10 x 10 squares of 5 mm from (-25, -25) to (25, 25) in the frontal view, with a hole of four squares around
/// (10, 10); `x` gives its depth.
template <class Depth>
Cage sheet(const Depth& x) {
  constexpr Index n = 10;
  Cage cage;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      const double y = 5.0 * i - 25.0;
      const double z = 5.0 * j - 25.0;
      cage.points.emplace_back(x(y, z), y, z);
    }
  }
  const auto is_hole = [](Index k) { return k == 6 || k == 7; };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      if (is_hole(i) && is_hole(j)) continue;
      const Index v = i * (n + 1) + j;
      cage.net.quads.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  }
  // The middle of the hole belongs to nothing: its number goes to the last point.
  const Index gone = 7 * (n + 1) + 7;
  cage.points[at(gone)] = cage.points.back();
  const Index last = to_index(cage.points.size()) - 1;
  cage.points.pop_back();
  for (auto& quad : cage.net.quads)
    std::ranges::replace(quad, last, gone);
  cage.net.n_vertices = to_index(cage.points.size());
  return cage;
}

double slope(double y, double z) {
  return 3.0 + 0.2 * y - 0.1 * z;
}

TEST(SkinSites, FindThePlaceThatTheFrontalViewShows) {
  const Cage cage = sheet(slope);
  const SkinSites sites(cage);
  const std::vector<Vec3> X =
      mesh::weighted(sites.refined().limit, mesh::control_points_through(cage.net, cage.points));
  for (const double y : {-24.0, -13.3, 0.0, 4.7, 21.1}) {
    for (const double z : {-23.0, -2.5, 0.0, 22.2}) {
      const auto site = sites.find(y, z);
      ASSERT_TRUE(site.has_value()) << y << " " << z;
      EXPECT_NEAR(site->parts.sum(), 1.0, 1e-12);
      EXPECT_LT((site->on(X) - Vec3(slope(y, z), y, z)).norm(), 1e-6);
    }
  }
}

TEST(SkinSites, GoAlongWhenTheFaceChanges) {
  const Cage cage = sheet(slope);
  const SkinSites sites(cage);
  // Stretched to twice its width: an affine change takes every place to where it takes the surface.
  std::vector<Vec3> wide = cage.points;
  for (Vec3& x : wide)
    x.y() *= 2.0;
  const std::vector<Vec3> X =
      mesh::weighted(sites.refined().limit, mesh::control_points_through(cage.net, wide));
  const auto site = sites.find(-7.0, 3.0);
  ASSERT_TRUE(site.has_value());
  EXPECT_LT((site->on(X) - Vec3(slope(-7.0, 3.0), -14.0, 3.0)).norm(), 1e-6);
}

TEST(SkinSites, AreNowhereBesideTheFaceOrInAHole) {
  const SkinSites sites(sheet(slope));
  EXPECT_FALSE(sites.find(26.0, 0.0).has_value());
  EXPECT_FALSE(sites.find(0.0, -300.0).has_value());
  EXPECT_FALSE(sites.find(10.0, 10.0).has_value());
  EXPECT_TRUE(sites.find(-10.0, 10.0).has_value());
}

// A surface that folds back under itself: a sheet bent to an S has three places behind one point of the view.
TEST(SkinSites, AreOnTheForemostOfSeveralPlaces) {
  Cage cage;
  constexpr Index n = 12;
  for (Index i = 0; i <= n; ++i) {
    const double turn = 3.14159265358979 * i / 6.0;  // twice half a turn
    for (const double z : {-10.0, 0.0, 10.0})
      cage.points.emplace_back(-10.0 * i, 20.0 * std::cos(turn), z);
  }
  for (Index i = 0; i < n; ++i) {
    for (const Index j : {0, 1}) {
      const Index v = 3 * i + j;
      cage.net.quads.push_back({v, v + 1, v + 4, v + 3});
    }
  }
  cage.net.n_vertices = to_index(cage.points.size());
  const SkinSites sites(cage);
  const std::vector<Vec3> X =
      mesh::weighted(sites.refined().limit, mesh::control_points_through(cage.net, cage.points));
  const auto site = sites.find(0.0, 1.0);
  ASSERT_TRUE(site.has_value());
  // Places with cos = 0 are i = 3 and 9; the front is at -x.
  EXPECT_NEAR(site->on(X).x(), -90.0, 1.0);
}

}  // namespace
}  // namespace facies::anatomy
