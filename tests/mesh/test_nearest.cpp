// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include "mesh/surfaces.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/base/parallel.hpp"
#include "facies/math/point_triangle.hpp"
#include "facies/math/segment_triangle.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::mesh {
namespace {

using support::Random;
using testing::ElementsAre;
using testing::IsEmpty;

NearestTriangles tree_of(const TriangleSurface& surface) {
  return {surface.X, surface.triangles};
}

double distance_to(const TriangleSurface& surface, Index triangle, const Vec3& point) {
  const auto& t = surface.triangles[at(triangle)];
  return std::sqrt(
      closest_on_triangle(point, surface.X[at(t[0])], surface.X[at(t[1])], surface.X[at(t[2])])
          .distance_squared);
}

/// Triangles of all sizes and shapes, some flat, some twice, far from the origin.
TriangleSurface random_soup(std::uint64_t seed) {
  Random random(seed);
  TriangleSurface soup;
  for (Index i = 0; i < 600; i += 3) {
    const Vec3 middle = Vec3(150.0, -80.0, 90.0) + random.vector(-20.0, 20.0);
    const double size = std::pow(10.0, random.uniform(-2.0, 1.0));
    for (int k = 0; k < 3; ++k)
      soup.X.emplace_back(middle + size * random.vector(-1.0, 1.0));
    soup.triangles.push_back({i, i + 1, i + 2});
    if (i % 10 == 0) soup.triangles.push_back({i, i + 1, i + 1});
    if (i % 20 == 0) soup.triangles.push_back({i, i + 1, i + 2});
  }
  return soup;
}

TEST(NearestTriangles, TellsWhereASegmentPassesThroughTrianglesAsBruteForceDoes) {
  const TriangleSurface soup = random_soup(5);
  const NearestTriangles tree = tree_of(soup);
  Random random(6);
  std::size_t total = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = Vec3(150.0, -80.0, 90.0) + random.vector(-20.0, 20.0);
    const Vec3 q = p + random.vector(-40.0, 40.0);
    std::vector<double> expected;
    for (const auto& [a, b, c] : soup.triangles) {
      const auto place =
          segment_through_triangle(p, q, soup.X[at(a)], soup.X[at(b)], soup.X[at(c)]);
      if (place) expected.push_back(*place);
    }
    std::ranges::sort(expected);
    EXPECT_EQ(tree.passes(p, q), expected);
    total += expected.size();
  }
  EXPECT_GT(total, 100U) << "the case does not test what it should";
}

TEST(NearestTriangles, AreEnteredAndLeftByASegmentThroughABox) {
  const TriangleSurface surface = box({1.0, 2.0, 3.0});
  EXPECT_THAT(tree_of(surface).passes({-2.0, 0.3, 0.4}, {2.0, 0.3, 0.4}), ElementsAre(0.25, 0.75));
  EXPECT_THAT(tree_of(surface).passes({-2.0, 0.3, 0.4}, {0.0, 0.3, 0.4}), ElementsAre(0.5));
  EXPECT_THAT(tree_of(surface).passes({-2.0, 0.3, 0.4}, {-1.5, 0.3, 0.4}), IsEmpty());
}

TEST(NearestTriangles, FindsAllTrianglesWithinARadiusAsBruteForceDoes) {
  const TriangleSurface soup = random_soup(1);
  const NearestTriangles tree = tree_of(soup);
  Random random(2);
  std::vector<Index> found{77};
  std::size_t total = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = Vec3(150.0, -80.0, 90.0) + random.vector(-30.0, 30.0);
    const double radius = std::pow(10.0, random.uniform(-2.0, 1.5));
    std::vector<Index> expected;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      if (distance_to(soup, to_index(t), point) <= radius) expected.push_back(to_index(t));
    }
    tree.within(point, radius, found);
    ASSERT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, 1000U);
}

TEST(NearestTriangles, DecidesInDoublePrecision) {
  // At 290 mm, neighbours in single precision are 3e-5 mm apart. Above the highest vertex, which has four triangles.
  TriangleSurface surface = sphere(40.0, 3);
  for (Vec3& x : surface.X)
    x += Vec3::Constant(250.0);
  const Vec3 top(250.0, 250.0, 290.0);
  const NearestTriangles tree = tree_of(surface);
  std::vector<Index> found;
  for (const double height : {1e-9, 1e-6, 1.6e-5, 2e-5, 1e-4}) {
    const Vec3 above(0.0, 0.0, height);
    tree.within(top + above, 0.9 * height, found);
    EXPECT_THAT(found, IsEmpty()) << height;
    tree.within(top + above, 1.1 * height, found);
    EXPECT_THAT(found, testing::SizeIs(4)) << height;
    EXPECT_NEAR(tree.nearest(top + above).signed_distance(), height, 1e-13);
    EXPECT_LT(tree.nearest(top - above).signed_distance(), -0.9 * height);
  }
}

TEST(NearestTriangles, IncludesTrianglesExactlyAtTheRadius) {
  const NearestTriangles tree = tree_of(box(Vec3::Ones()));
  std::vector<Index> found;
  tree.within(Vec3(0.25, 0.5, 3.0), 2.0, found);
  EXPECT_THAT(found, ElementsAre(3));
  tree.within(Vec3(1.0, 1.0, 1.0), 0.0, found);
  EXPECT_THAT(found, ElementsAre(2, 3, 6, 7, 10, 11));
  tree.within(Vec3::Zero(), -1.0, found);
  EXPECT_THAT(found, IsEmpty());
  tree.within(Vec3::Zero(), std::numeric_limits<double>::infinity(), found);
  EXPECT_THAT(found, testing::SizeIs(12));
}

TEST(NearestTriangles, FindsTheNearestAsBruteForceDoes) {
  const TriangleSurface soup = random_soup(3);
  const NearestTriangles tree = tree_of(soup);
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = Vec3(150.0, -80.0, 90.0) + random.vector(-40.0, 40.0);
    Index expected = 0;
    for (std::size_t t = 1; t < soup.triangles.size(); ++t) {
      if (distance_to(soup, to_index(t), point) < distance_to(soup, expected, point))
        expected = to_index(t);
    }
    const NearestPoint nearest = tree.nearest(point);
    ASSERT_EQ(nearest.triangle, expected);
    ASSERT_EQ(nearest.distance, distance_to(soup, expected, point));
    ASSERT_NEAR((nearest.point - point).norm(), nearest.distance, 1e-12);
  }
}

/// The signed distance of a box about the origin.
double box_distance(const Vec3& half, const Vec3& point) {
  const Vec3 q = point.cwiseAbs() - half;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

TEST(NearestTriangles, KnowsTheSidesOfABox) {
  const Vec3 half(3.0, 1.0, 2.0);
  const NearestTriangles tree = tree_of(box(half));
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 point = random.vector(-5.0, 5.0);
    const NearestPoint nearest = tree.nearest(point);
    ASSERT_NEAR(nearest.signed_distance(), box_distance(half, point), 1e-13);
    ASSERT_GE(nearest.distance, 0.0);
  }
  EXPECT_TRUE(tree.nearest(Vec3::Zero()).is_inside);
  EXPECT_FALSE(tree.nearest(Vec3(3.0, 1.0, 2.0)).is_inside);
}

/// A slender pyramid, its tip the vertex 4. The side over the edge from 0 to 1 is cut into `n` triangles.
TriangleSurface spike(Index n) {
  TriangleSurface surface{{Vec3(-1.0, -1.0, 0.0), Vec3(1.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0),
                           Vec3(-1.0, 1.0, 0.0), Vec3(0.0, 0.0, 10.0)},
                          {{3, 2, 1}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  Index from = 0;
  for (Index i = 1; i <= n; ++i) {
    const Index to = i == n ? 1 : to_index(surface.X.size());
    if (i < n) surface.X.emplace_back(-1.0 + 2.0 * i / n, -1.0, 0.0);
    surface.triangles.push_back({from, to, 4});
    surface.triangles.push_back({3, to, from});
    from = to;
  }
  return surface;
}

TEST(NearestTriangles, KnowsTheSideAtATipHoweverItsTrianglesAreCut) {
  // Beyond the tip, one side or the other always faces away; the plain mean of many normals faces away from the rest.
  const TriangleSurface surface = spike(50);
  ASSERT_TRUE(check_surface(surface).is_closed());
  const NearestTriangles tree = tree_of(surface);
  const Vec3& tip = surface.X[4];
  Random random(6);
  int n_at_tip = 0;
  for (int i = 0; i < 5000; ++i) {
    const NearestPoint nearest = tree.nearest(tip + random.vector(-1.0, 1.0));
    if (nearest.point != tip) continue;
    ++n_at_tip;
    ASSERT_FALSE(nearest.is_inside);
  }
  EXPECT_GT(n_at_tip, 1000);
  EXPECT_TRUE(tree.nearest(0.99 * tip).is_inside);
}

TEST(NearestTriangles, KnowsTheDistanceFromASphereWithinTheDepthOfItsFacets) {
  // The polyhedron contains the ball of radius R - sag and is contained in that of radius R.
  const double R = 40.0;
  const TriangleSurface surface = sphere(R, 4);
  double sag = 0.0;
  for (const auto& t : surface.triangles) {
    const Vec3& a = surface.X[at(t[0])];
    const Vec3 normal = (surface.X[at(t[1])] - a).cross(surface.X[at(t[2])] - a).normalized();
    sag = std::max(sag, R - normal.dot(a));
  }
  ASSERT_LT(sag, 0.2);
  const NearestTriangles tree = tree_of(surface);
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double r = random.uniform(1.0, 80.0);
    const double distance = tree.nearest(r * random.unit_vector()).signed_distance();
    ASSERT_GT(distance, r - R - 1e-12);
    ASSERT_LT(distance, r - R + sag + 1e-12);
  }
}

TEST(NearestTriangles, AnswersTheSameOnSeveralThreads) {
  const NearestTriangles tree = tree_of(sphere(40.0, 4));
  std::vector<Vec3> points(4000);
  Random random(8);
  for (Vec3& point : points)
    point = random.vector(-60.0, 60.0);
  const auto ask = [&](int threads) {
    std::vector<std::vector<Index>> answers(points.size());
    parallel_for(points.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        tree.within(points[i], 5.0, answers[i]);
        answers[i].push_back(tree.nearest(points[i]).triangle);
      }
    });
    return answers;
  };
  EXPECT_EQ(ask(1), ask(4));
}

TEST(NearestTriangles, NamesTheSmallestNumberOfEquals) {
  const TriangleSurface surface = sphere(40.0, 3);
  const NearestTriangles tree = tree_of(surface);
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    const auto first = std::ranges::find_if(surface.triangles, [&](const auto& t) {
      return std::ranges::find(t, to_index(v)) != t.end();
    });
    EXPECT_EQ(tree.nearest(2.0 * surface.X[v]).triangle,
              to_index(std::size_t(first - surface.triangles.begin())));
  }
}

TEST(NearestTriangles, RefusesWhatIsNoSurface) {
  const TriangleSurface good = box(Vec3::Ones());
  TriangleSurface bad = good;
  bad.triangles[3][1] = 8;
  EXPECT_THROW(tree_of(bad), BugError);
  bad = good;
  bad.triangles[3][1] = -1;
  EXPECT_THROW(tree_of(bad), BugError);
  for (const double coordinate : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e16}) {
    bad = good;
    bad.X[2].y() = coordinate;
    EXPECT_THROW(tree_of(bad), BugError);
  }
  EXPECT_THROW((void)tree_of(good).nearest(Vec3(HUGE_VAL, 0.0, 0.0)), BugError);
}

TEST(NearestTriangles, OfNoTrianglesFindsNone) {
  const NearestTriangles tree = tree_of({});
  std::vector<Index> found;
  tree.within(Vec3::Zero(), 1e3, found);
  EXPECT_THAT(found, IsEmpty());
  EXPECT_THROW((void)tree.nearest(Vec3::Zero()), BugError);
}

}  // namespace
}  // namespace facies::mesh
