// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "facies/results/streamlines.hpp"

namespace facies::results {
namespace {

/// A net of n x n squares, each two triangles; `place` takes parts of its sides, 0 to 1, to points, `axis` a point to the axis there.
template <class Place, class Axis>
AxisField make_field(Index n, const Place& place, const Axis& axis) {
  AxisField field;
  for (Index j = 0; j <= n; ++j) {
    for (Index i = 0; i <= n; ++i)
      field.X.push_back(place(static_cast<double>(i) / n, static_cast<double>(j) / n));
  }
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      field.triangles.push_back({a, a + 1, a + n + 2});
      field.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  double sign = 1.0;
  for (const auto& [a, b, c] : field.triangles) {
    const Vec3 middle = (field.X[at(a)] + field.X[at(b)] + field.X[at(c)]) / 3.0;
    field.axes.push_back(sign * Vec3(axis(middle)));
    sign = -sign;  // an axis has no sign
  }
  return field;
}

Vec3 on_square(double u, double v) {
  return {40.0 * u, 40.0 * v, 0.0};
}

double distance(const Streamline& a, const Streamline& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& x : a.points) {
    for (const Vec3& y : b.points)
      least = std::min(least, (x - y).norm());
  }
  return least;
}

TEST(Streamlines, OfAConstantFieldAreStraightAndEvenlySpaced) {
  const Vec3 along = Vec3(2.0, 1.0, 0.0).normalized();
  const AxisField field = make_field(10, on_square, [&](const Vec3&) { return along; });
  const std::vector<Streamline> lines = even_streamlines(field, 4.0, 0.5);
  for (const Streamline& line : lines) {
    const Vec3 way = line.points.back() - line.points.front();
    EXPECT_GE(way.norm(), 4.0 - 1e-6);
    // At a border the last point slides along it, by less than a step.
    EXPECT_GT(std::abs(way.normalized().dot(along)), 1.0 - 1e-5);
    for (const Vec3& normal : line.normals)
      EXPECT_LT((normal - Vec3::UnitZ()).norm(), 1e-9);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Streamline& other : lines) {
      if (&other != &line) nearest = std::min(nearest, distance(line, other));
    }
    EXPECT_GE(nearest, 2.0 - 1e-6);
    EXPECT_LE(nearest, 6.0);
  }
  // 40 mm of lines 4 mm apart, over the whole square: (|along x| + |along y|) 40 mm wide across them.
  EXPECT_NEAR(static_cast<double>(lines.size()), 40.0 * (2.0 + 1.0) / std::sqrt(5.0) / 4.0, 3.0);
}

TEST(Streamlines, LeaveNoPartOfTheSurfaceEmpty) {
  const AxisField field = make_field(10, on_square, [](const Vec3&) { return Vec3::UnitX(); });
  const std::vector<Streamline> lines = even_streamlines(field, 4.0, 0.5);
  for (double y = 3.0; y < 38.0; y += 1.0) {
    const Streamline here{{{20.0, y, 0.0}}, {}};
    EXPECT_TRUE(std::ranges::any_of(lines, [&](const Streamline& line) {
      return distance(line, here) < 4.0;
    })) << y;
  }
}

TEST(Streamlines, CloseAroundACylinder) {
  constexpr double radius = 12.0;
  const AxisField field = make_field(
      40,
      [](double u, double v) {
        const double phi = 2.0 * std::numbers::pi * u;
        return Vec3(radius * std::cos(phi), radius * std::sin(phi), 30.0 * v);
      },
      [](const Vec3& x) { return Vec3(-x.y(), x.x(), 0.0).normalized(); });
  for (const Streamline& line : even_streamlines(field, 5.0, 0.5)) {
    const double length = 0.5 * static_cast<double>(line.points.size());
    EXPECT_NEAR(length, 2.0 * std::numbers::pi * radius, 2.0);
    for (const Vec3& x : line.points)
      EXPECT_NEAR(x.z(), line.points.front().z(), 0.05);
  }
}

TEST(Streamlines, EndWhereThereIsNoDirection) {
  // Two halves whose axes are at right angles: between them a line has nothing to follow.
  const AxisField field = make_field(
      10, on_square, [](const Vec3& x) { return x.x() < 20.0 ? Vec3::UnitX() : Vec3::UnitY(); });
  for (const Streamline& line : even_streamlines(field, 4.0, 0.5)) {
    const auto in_left = [](const Vec3& x) { return x.x() < 16.0; };
    const auto in_right = [](const Vec3& x) { return x.x() > 24.0; };
    EXPECT_FALSE(std::ranges::any_of(line.points, in_left) &&
                 std::ranges::any_of(line.points, in_right));
  }
}

TEST(Streamlines, OfNothingAreNone) {
  EXPECT_TRUE(even_streamlines({}, 4.0, 0.5).empty());
}

}  // namespace
}  // namespace facies::results
