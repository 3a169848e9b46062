// SPDX-License-Identifier: Apache-2.0
// Inside, outside and nearest points of simple bodies.
#include <gtest/gtest.h>

#include "facies/anatomy/tissue_surface.hpp"
#include "facies/mesh/layered_sheet.hpp"

namespace facies::anatomy {
namespace {

/// The box x in [0, 11.5], y and z in [-20, 20], of hexahedra and wedges.
mesh::Mesh box() {
  mesh::SheetOptions options;
  options.cells = mesh::SheetCells::checkerboard;
  return mesh::make_layered_sheet(options);
}

TEST(TissueSurface, CutsEveryQuadrilateralOfTheBoundaryInTwo) {
  // 8 x 8 columns on the two large sides, 8 x 3 on the four small ones.
  EXPECT_EQ(TissueSurface(box()).n_triangles(), 2U * (2 * 64 + 4 * 24));
}

TEST(TissueSurface, ContainsWhatLiesInTheBox) {
  const TissueSurface surface(box());
  EXPECT_TRUE(surface.contains({5, 0, 0}));
  EXPECT_TRUE(surface.contains({0.01, 19.99, -19.99}));
  EXPECT_FALSE(surface.contains({-0.01, 0, 0}));
  EXPECT_FALSE(surface.contains({11.51, 3, 3}));
  EXPECT_FALSE(surface.contains({5, 21, 0}));
  EXPECT_FALSE(surface.contains({1e6, 1e6, 1e6}));
}

TEST(TissueSurface, FindsTheNearestPointOfABox) {
  const TissueSurface surface(box());
  // In front of a face, an edge and a corner; and from inside.
  EXPECT_LT((surface.nearest({-3, 1.3, 2.7}) - Vec3(0, 1.3, 2.7)).norm(), 1e-12);
  EXPECT_LT((surface.nearest({-3, 24, 2.7}) - Vec3(0, 20, 2.7)).norm(), 1e-12);
  EXPECT_LT((surface.nearest({14, 24, -22}) - Vec3(11.5, 20, -20)).norm(), 1e-12);
  EXPECT_LT((surface.nearest({1, 1.3, 2.7}) - Vec3(0, 1.3, 2.7)).norm(), 1e-12);
}

TEST(TissueSurface, LeavesPointsInTheTissueWhereTheyAre) {
  const TissueSurface surface(box());
  const Vec3 p(4.0, 1.0, 2.0);
  EXPECT_EQ(surface.into_tissue(p), p);
  EXPECT_LT((surface.into_tissue({-4.0, 1.0, 2.0}) - Vec3(0.0, 1.0, 2.0)).norm(), 1e-12);
}

TEST(TissueSurface, FindsTheNearestPointOfATriangleInEachOfItsSevenRegions) {
  const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const std::array<std::pair<Vec3, Vec3>, 7> cases{{{{1, 1, 5}, {1, 1, 0}},
                                                    {{-1, -1, 2}, {0, 0, 0}},
                                                    {{6, -1, 2}, {4, 0, 0}},
                                                    {{-1, 7, 2}, {0, 4, 0}},
                                                    {{2, -3, 1}, {2, 0, 0}},
                                                    {{-3, 2, 1}, {0, 2, 0}},
                                                    {{3, 3, 1}, {2, 2, 0}}}};
  for (const auto& [p, nearest] : cases)
    EXPECT_LT((closest_on_triangle(p, triangle) - nearest).norm(), 1e-12) << p.transpose();
}

}  // namespace
}  // namespace facies::anatomy
