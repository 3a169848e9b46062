// SPDX-License-Identifier: Apache-2.0
// How often surfaces go round points: solid angles that are known, and blades whose walls run through each other.
#include <algorithm>
#include <cmath>

#include "mesh/surfaces.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/nearest.hpp"
#include "facies/mesh/winding_number.hpp"

namespace facies::mesh {
namespace {

double winding(const TriangleSurface& surface, const Vec3& p) {
  return winding_number(surface.X, surface.triangles, p);
}

TEST(WindingNumber, IsThePartOfAllDirectionsThatATriangleCovers) {
  const TriangleSurface octant{{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2}}};
  EXPECT_NEAR(winding(octant, Vec3::Zero()), 1.0 / 8.0, 1e-15);
}

TEST(WindingNumber, IsOneInABoxAndZeroOutside) {
  const TriangleSurface surface = box({1.0, 2.0, 3.0});
  EXPECT_NEAR(winding(surface, {0.999, -1.999, 2.999}), 1.0, 1e-12);
  EXPECT_NEAR(winding(surface, {1.001, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(winding(surface, {50.0, 60.0, 70.0}), 0.0, 1e-12);
}

TEST(WindingNumber, OfASurfaceInsideOutIsMinusOne) {
  TriangleSurface surface = sphere(2.0, 2);
  for (auto& triangle : surface.triangles)
    std::swap(triangle[0], triangle[1]);
  EXPECT_NEAR(winding(surface, {0.3, 0.2, 0.1}), -1.0, 1e-12);
}

TEST(WindingNumber, CountsSurfacesThatOverlap) {
  const TriangleSurface two = together(sphere(2.0, 2), sphere(2.0, 2), {2.0, 0.1, 0.2});
  EXPECT_NEAR(winding(two, {1.0, 0.0, 0.1}), 2.0, 1e-12);
  EXPECT_NEAR(winding(two, {-1.0, 0.0, 0.1}), 1.0, 1e-12);
}

TEST(WindingNumber, OfAnOpenBoxIsTheShareOfItsSides) {
  TriangleSurface surface = box({1.0, 1.0, 1.0});
  surface.triangles.erase(surface.triangles.begin(), surface.triangles.begin() + 2);
  EXPECT_NEAR(winding(surface, Vec3::Zero()), 5.0 / 6.0, 1e-14);
}

TEST(WindingNumber, BehindASheetIsAHalfAndAtItsBorderAQuarter) {
  const TriangleSurface sheet{
      {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}},
      {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_NEAR(winding(sheet, {0.2, 0.1, -1e-6}), 0.5, 1e-6);
  EXPECT_NEAR(winding(sheet, {0.2, 0.1, 1e-6}), -0.5, 1e-6);
  EXPECT_NEAR(winding(sheet, {1.0, 0.1, -1e-6}), 0.25, 1e-6);
  EXPECT_NEAR(winding(sheet, {1.1, 0.1, -1e-6}), 0.0, 1e-5);
}

// The walls run through each other by up to 0.4 mm, so that whatever is farther than that and half the thickness from the
// blade's middle is outside. The nearest triangle is often one of the wall that looks the other way.
TEST(WindingNumber, IsRightBesideABladeWhereTheNearestTriangleLooksTheWrongWay) {
  const double twist = 0.04;
  const TriangleSurface surface = blade(10.0, 4, twist, 0.1);
  const SurfaceReport report = check_surface(surface);
  ASSERT_TRUE(report.is_closed());
  ASSERT_FALSE(report.intersections.empty());
  const NearestTriangles tree(surface.X, surface.triangles);
  support::Random random(1);
  int n_wrong_by_normal = 0;
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(-9.0, 9.0);
    const double y = random.uniform(-9.0, 9.0);
    const double off = (i % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.6, 3.0);
    const Vec3 p(x, y, twist * x * y + off);
    if (tree.nearest(p).is_inside) ++n_wrong_by_normal;
    ASSERT_NEAR(winding(surface, p), 0.0, 1e-12);
  }
  EXPECT_GT(n_wrong_by_normal, 20);
}

TEST(WindingNumber, IsOneWithinABladeWhereItsWallsAreApart) {
  const TriangleSurface surface = blade(10.0, 4, 0.04, 0.1);
  for (const double x : {-5.0, 0.0, 5.0}) {
    for (const double y : {-5.0, 0.0, 5.0})
      EXPECT_NEAR(winding(surface, {x, y, 0.04 * x * y}), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace facies::mesh
