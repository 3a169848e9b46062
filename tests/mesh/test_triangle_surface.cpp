// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "mesh/surfaces.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/triangle_surface.hpp"

namespace facies::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(CheckSurface, FindsNothingWrongWithABox) {
  TriangleSurface surface = box(Vec3(1.0, 2.0, 3.0));
  const Vec3 shift(100.0, -200.0, 300.0);
  for (Vec3& x : surface.X)
    x += shift;
  const SurfaceReport report = check_surface(surface);
  EXPECT_THAT(report.border_edges, IsEmpty());
  EXPECT_THAT(report.crowded_edges, IsEmpty());
  EXPECT_THAT(report.inconsistent_edges, IsEmpty());
  EXPECT_THAT(report.flat_triangles, IsEmpty());
  EXPECT_THAT(report.intersections, IsEmpty());
  EXPECT_NEAR(report.volume, 48.0, 1e-11);
  EXPECT_EQ(report.lower, shift - Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(report.upper, shift + Vec3(1.0, 2.0, 3.0));
  EXPECT_TRUE(report.is_closed());
}

TEST(CheckSurface, MeasuresTheVolumeOfASphereToSecondOrder) {
  const auto error = [](int cuts) {
    const double exact = 4.0 / 3.0 * std::numbers::pi * 1000.0;
    return std::abs(check_surface(sphere(10.0, cuts)).volume / exact - 1.0);
  };
  EXPECT_LT(error(4), 0.01);
  EXPECT_NEAR(error(3) / error(4), 4.0, 0.2);
}

TEST(CheckSurface, SeesASurfaceThatIsInsideOut) {
  TriangleSurface surface = box(Vec3::Ones());
  for (auto& t : surface.triangles)
    std::swap(t[1], t[2]);
  const SurfaceReport report = check_surface(surface);
  EXPECT_NEAR(report.volume, -8.0, 1e-13);
  EXPECT_THAT(report.inconsistent_edges, IsEmpty());
  EXPECT_TRUE(report.is_closed());
}

TEST(CheckSurface, ListsTheBorderOfAHole) {
  TriangleSurface surface = box(Vec3::Ones());
  surface.triangles.erase(surface.triangles.begin());  // 0 2 3
  const SurfaceReport report = check_surface(surface);
  EXPECT_THAT(report.border_edges,
              ElementsAre(VertexPair{0, 2}, VertexPair{0, 3}, VertexPair{2, 3}));
  EXPECT_THAT(report.crowded_edges, IsEmpty());
  EXPECT_FALSE(report.is_closed());
}

TEST(CheckSurface, ListsTheEdgesOfATriangleThatIsTurnedOver) {
  TriangleSurface surface = box(Vec3::Ones());
  std::swap(surface.triangles[0][1], surface.triangles[0][2]);
  const SurfaceReport report = check_surface(surface);
  EXPECT_THAT(report.inconsistent_edges,
              ElementsAre(VertexPair{0, 2}, VertexPair{0, 3}, VertexPair{2, 3}));
  EXPECT_THAT(report.border_edges, IsEmpty());
  EXPECT_FALSE(report.is_closed());
}

TEST(CheckSurface, ListsEdgesOfMoreThanTwoTriangles) {
  TriangleSurface surface = box(Vec3::Ones());
  surface.X.emplace_back(0.0, 0.0, -5.0);
  surface.triangles.push_back({0, 3, 8});
  const SurfaceReport report = check_surface(surface);
  EXPECT_THAT(report.crowded_edges, ElementsAre(VertexPair{0, 3}));
  EXPECT_THAT(report.border_edges, ElementsAre(VertexPair{0, 8}, VertexPair{3, 8}));
  EXPECT_FALSE(report.is_closed());
}

TEST(CheckSurface, ListsTrianglesWithoutArea) {
  TriangleSurface surface = box(Vec3::Ones());
  surface.X.emplace_back(1.0, 1.0, 0.0);  // on the edge from 3 to 7
  surface.triangles.push_back({3, 7, 8});
  surface.triangles.push_back({3, 3, 7});
  const SurfaceReport report = check_surface(surface);
  EXPECT_THAT(report.flat_triangles, ElementsAre(12, 13));
  EXPECT_THAT(report.intersections, IsEmpty());
}

TEST(CheckSurface, LooksThroughATriangleThatNamesAVertexTwice) {
  TriangleSurface surface = box(Vec3::Ones());
  surface.triangles.push_back({0, 0, 3});
  EXPECT_TRUE(check_surface(surface).is_closed());
}

TEST(CheckSurface, FindsTrianglesThatPierceEachOther) {
  // A thin bar through the top and the bottom of a box, off the diagonals of both.
  TriangleSurface bar = box(Vec3(0.1, 0.1, 2.0));
  const TriangleSurface pierced = together(box(Vec3::Ones()), bar, Vec3(0.5, -0.4, 0.0));
  const SurfaceReport report = check_surface(pierced);
  EXPECT_NEAR(report.volume, 8.0 + 0.16, 1e-12);
  // Each of the eight sides of the bar meets the box above and below.
  EXPECT_THAT(report.intersections, SizeIs(16));
  for (const auto& [first, second] : report.intersections) {
    EXPECT_LT(first, 4);
    EXPECT_GE(second, 16);
  }
  EXPECT_THAT(check_surface(together(box(Vec3::Ones()), bar, Vec3(1.2, 0.0, 0.0))).intersections,
              IsEmpty());
}

TEST(CheckSurface, FindsAPiercingExactlyThroughAnEdge) {
  // The only point in common is (1, 1, 0), on an edge of both.
  const TriangleSurface flag{{Vec3(0.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), Vec3(0.0, 2.0, 0.0),
                              Vec3(1.0, 1.0, -1.0), Vec3(1.0, 1.0, 1.0), Vec3(5.0, 5.0, 0.0)},
                             {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_THAT(check_surface(flag).intersections, ElementsAre(TrianglePair{0, 1}));
}

TEST(CheckSurface, TakesAVertexThatTouchesForNoIntersection) {
  const TriangleSurface block = box(Vec3::Ones());
  EXPECT_THAT(check_surface(together(block, block, Vec3(2.0, 0.0, 0.0))).intersections, IsEmpty());
  // The lowest vertex of an octahedron on the top of the box.
  const TriangleSurface octahedron = sphere(1.0, 0);
  EXPECT_THAT(check_surface(together(block, octahedron, Vec3(0.5, -0.25, 2.0))).intersections,
              IsEmpty());
  EXPECT_THAT(check_surface(together(block, octahedron, Vec3(0.5, -0.25, 1.999))).intersections,
              SizeIs(4));
}

TEST(CheckSurface, FindsIntersectionsOfSpheresInEveryPose) {
  support::Random random(1);
  const TriangleSurface one = sphere(10.0, 3);
  for (int i = 0; i < 10; ++i) {
    TriangleSurface both = together(one, one, 15.0 * random.unit_vector());
    const Mat3 R = random.rotation();
    for (Vec3& x : both.X)
      x = R * x + Vec3(100.0, 50.0, -20.0);
    // The circle on which they meet, 2 pi 6.6 mm long, crosses triangles of 1.5 mm on both.
    EXPECT_GT(check_surface(both).intersections.size(), 40U);
  }
  EXPECT_THAT(check_surface(together(one, one, Vec3(20.1, 0.0, 0.0))).intersections, IsEmpty());
  EXPECT_THAT(check_surface(together(one, sphere(9.0, 3), Vec3::Zero())).intersections, IsEmpty());
}

TEST(CheckSurface, SaysNothingOfNothing) {
  const SurfaceReport report = check_surface({});
  EXPECT_EQ(report.volume, 0.0);
  EXPECT_FALSE(report.is_closed());
}

TEST(CheckSurface, RefusesWhatIsNoSurface) {
  TriangleSurface bad = box(Vec3::Ones());
  bad.triangles[0][0] = 8;
  EXPECT_THROW((void)check_surface(bad), BugError);
  bad = box(Vec3::Ones());
  bad.X[0].x() = HUGE_VAL;
  EXPECT_THROW((void)check_surface(bad), BugError);
}

TEST(MergeCoincidentVertices, ClosesASurfaceOfSeparateTriangles) {
  const TriangleSurface closed = sphere(10.0, 2);
  TriangleSurface separate;
  for (const auto& t : closed.triangles) {
    const Index n = to_index(separate.X.size());
    for (const Index vertex : t)
      separate.X.push_back(closed.X[at(vertex)]);
    separate.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_THAT(check_surface(separate).border_edges, SizeIs(3 * closed.triangles.size()));
  EXPECT_THAT(check_surface(separate).intersections, IsEmpty());
  const TriangleSurface merged = merge_coincident_vertices(separate);
  EXPECT_EQ(merged.X.size(), closed.X.size());
  EXPECT_EQ(merged.triangles.size(), closed.triangles.size());
  EXPECT_TRUE(check_surface(merged).is_closed());
  for (std::size_t i = 0; i < merged.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(merged.X[at(merged.triangles[i][k])], closed.X[at(closed.triangles[i][k])]);
  }
}

TEST(MergeCoincidentVertices, KeepsTheFirstOfEachAndTheOrder) {
  const TriangleSurface surface{{Vec3(1.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), Vec3(1.0, -0.0, 0.0),
                                 Vec3(3.0, 1.0, 0.0), Vec3(1.0, 0.0, 1e-300)},
                                {{0, 1, 3}, {2, 1, 4}, {0, 2, 3}}};
  const TriangleSurface merged = merge_coincident_vertices(surface);
  EXPECT_THAT(merged.X, ElementsAre(surface.X[0], surface.X[1], surface.X[3], surface.X[4]));
  using Triangle = std::array<Index, 3>;
  EXPECT_THAT(merged.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 3}, Triangle{0, 0, 2}));
}

}  // namespace
}  // namespace facies::mesh
