// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include "support/random.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mesh/catmull_clark.hpp"

namespace facies::mesh {
namespace {

using support::Random;

/// n x n squares; vertex (i, j) is i * (n + 1) + j.
QuadNet grid(Index n) {
  QuadNet net{(n + 1) * (n + 1), {}};
  const auto number = [n](Index i, Index j) { return i * (n + 1) + j; };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j)
      net.quads.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
  }
  return net;
}

/// The surface of a cube, each side one square: three quadrilaterals around every vertex.
QuadNet cube() {
  return {8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
}

/// `n` quadrilaterals around vertex 0, in a plane.
QuadNet fan(Index n) {
  QuadNet net{2 * n + 1, {}};
  for (Index k = 0; k < n; ++k)
    net.quads.push_back({0, 1 + 2 * k, 2 + 2 * k, 1 + 2 * ((k + 1) % n)});
  return net;
}

std::vector<Vec3> grid_points(Index n, const std::function<Vec3(double, double)>& x) {
  std::vector<Vec3> points;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j)
      points.push_back(x(static_cast<double>(i), static_cast<double>(j)));
  }
  return points;
}

TEST(CatmullClark, LeavesWhatIsEquallySpacedInAPlaneWhereItIs) {
  const auto flat = [](double i, double j) { return Vec3(2.0 * i, 3.0 * j, 1.0 + i - 2.0 * j); };
  const std::vector<Vec3> X = grid_points(4, flat);
  const LimitMesh fine = limit_mesh(grid(4), 2);
  const std::vector<Vec3> x = weighted(fine.limit, X);
  ASSERT_EQ(to_index(x.size()), fine.net.n_vertices);
  ASSERT_EQ(fine.net.quads.size(), 256U);
  for (std::size_t v = 0; v < X.size(); ++v)
    EXPECT_LT((x[v] - X[v]).norm(), 1e-12);
  for (const Vec3& p : x)
    EXPECT_NEAR(p.z(), 1.0 + p.x() / 2.0 - 2.0 * p.y() / 3.0, 1e-12);
}

// The surface over a regular net is a uniform bicubic B-spline: control values i^2 and i^3 give s^2 + 1/3 and s^3 + s.
TEST(CatmullClark, IsABicubicSplineWhereTheNetIsRegular) {
  const Index n = 8;
  const auto curved = [](double i, double j) { return Vec3(i * i, i * i * i, j); };
  const LimitMesh fine = limit_mesh(grid(n), 2);
  const std::vector<Vec3> x = weighted(fine.limit, grid_points(n, curved));
  int n_inner = 0;
  for (const Vec3& p : x) {
    const double s = std::sqrt(std::max(0.0, p.x() - 1.0 / 3.0));
    if (p.x() < 4.0 || s > 6.0 || p.z() < 2.0 || p.z() > 6.0) continue;
    ++n_inner;
    EXPECT_NEAR(4.0 * s, std::round(4.0 * s), 1e-9) << "a quarter of a control distance";
    EXPECT_NEAR(p.y(), s * s * s + s, 1e-9);
  }
  EXPECT_GT(n_inner, 100);
}

TEST(CatmullClark, HasTheSameSurfaceAtAVertexHoweverOftenTheNetIsRefined) {
  Random random(1);
  for (const QuadNet& net : {cube(), fan(5), fan(3), grid(3)}) {
    std::vector<Vec3> X;
    for (Index v = 0; v < net.n_vertices; ++v)
      X.push_back(random.vector(-1.0, 1.0));
    const std::vector<Vec3> before = weighted(limit_mesh(net, 0).limit, X);
    const std::vector<Vec3> after = weighted(limit_mesh(net, 3).limit, X);
    for (std::size_t v = 0; v < X.size(); ++v)
      EXPECT_LT((before[v] - after[v]).norm(), 1e-12);
  }
}

TEST(CatmullClark, GoesThroughThePointsThatItIsToldTo) {
  Random random(2);
  for (const QuadNet& net : {fan(5), fan(3), grid(4)}) {
    std::vector<Vec3> points;
    for (Index v = 0; v < net.n_vertices; ++v)
      points.push_back(random.vector(-1.0, 1.0));
    const std::vector<Vec3> x =
        weighted(limit_mesh(net, 2).limit, control_points_through(net, points));
    for (std::size_t v = 0; v < points.size(); ++v)
      EXPECT_LT((x[v] - points[v]).norm(), 1e-12);
  }
}

TEST(CatmullClark, HasBordersThatDependOnTheBorderAlone) {
  std::vector<Vec3> X = grid_points(4, [](double i, double j) { return Vec3(i, j, 0.0); });
  const LimitMesh fine = limit_mesh(grid(4), 3);
  const std::vector<Vec3> flat = weighted(fine.limit, X);
  X[12].z() = 5.0;  // the middle one
  const std::vector<Vec3> x = weighted(fine.limit, X);
  int n_border = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3& p = flat[v];
    if (std::min({p.x(), p.y(), 4.0 - p.x(), 4.0 - p.y()}) > 1e-12) continue;
    ++n_border;
    EXPECT_EQ(x[v].z(), 0.0);
  }
  EXPECT_EQ(n_border, 4 * 32);
}

TEST(CatmullClark, MakesACubeRound) {
  std::vector<Vec3> X;
  for (int i = 0; i < 8; ++i)
    X.emplace_back((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
  const LimitMesh fine = limit_mesh(cube(), 3);
  check_net(fine.net);
  double smallest = 10.0;
  double largest = 0.0;
  for (const Vec3& p : weighted(fine.limit, X)) {
    smallest = std::min(smallest, p.norm());
    largest = std::max(largest, p.norm());
  }
  EXPECT_GT(smallest, 0.9 * largest);
  X[0] *= 1.5;
  EXPECT_THROW((void)control_points_through(cube(), X), BugError);
}

TEST(FindFault, SaysWhereANetIsNoSurface) {
  EXPECT_FALSE(find_fault(cube()).has_value());
  const auto vertices = [](const QuadNet& net) { return find_fault(net).value().vertices; };
  EXPECT_EQ(vertices({4, {{0, 1, 2, 4}}}), std::vector<Index>{4});
  EXPECT_EQ(vertices({4, {{0, 1, 0, 3}}}), std::vector<Index>{0});
  EXPECT_EQ(vertices({5, {{0, 1, 2, 3}}}), std::vector<Index>{4});
  EXPECT_EQ(vertices({6, {{0, 1, 2, 3}, {0, 1, 4, 5}}}), (std::vector<Index>{0, 1}));
  // Two quadrilaterals that touch in one vertex.
  EXPECT_EQ(vertices({7, {{0, 1, 2, 3}, {2, 4, 5, 6}}}), std::vector<Index>{2});
}

TEST(CutIntoTriangles, KeepsTheAreaAndItsSide) {
  const std::vector<Vec3> X = grid_points(3, [](double i, double j) { return Vec3(i, j, 0.0); });
  Vec3 area = Vec3::Zero();
  for (const auto& [a, b, c] : cut_into_triangles(grid(3)))
    area += 0.5 * (X[at(b)] - X[at(a)]).cross(X[at(c)] - X[at(a)]);
  EXPECT_LT((area - Vec3(0.0, 0.0, 9.0)).norm(), 1e-12);
}

TEST(CheckNet, RefusesNetsThatAreNoSurface) {
  EXPECT_NO_THROW(check_net(cube()));
  EXPECT_NO_THROW(check_net(grid(2)));
  QuadNet turned = grid(2);
  std::ranges::reverse(turned.quads[1]);
  EXPECT_THROW(check_net(turned), BugError);
  QuadNet lonely = grid(1);
  ++lonely.n_vertices;
  EXPECT_THROW(check_net(lonely), BugError);
  QuadNet twice = grid(1);
  twice.quads.push_back(twice.quads[0]);
  twice.quads.push_back(twice.quads[0]);
  EXPECT_THROW(check_net(twice), BugError);
}

}  // namespace
}  // namespace facies::mesh
