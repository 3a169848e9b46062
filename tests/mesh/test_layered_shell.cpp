// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "facies/mesh/columns.hpp"
#include "facies/mesh/layered_shell.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/shell_corners.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

/// A sheet of n x n squares of 1 mm, `thick` deep below z = 0, with node layers at these parts of the way.
Shell sheet(Index n, double thick, const std::vector<double>& parts) {
  Shell shell;
  shell.net.n_vertices = (n + 1) * (n + 1);
  const auto number = [n](Index i, Index j) { return i * (n + 1) + j; };
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      shell.outer.emplace_back(i, j, 0.0);
      shell.inner.emplace_back(i, j, -thick);
      if (i == n || j == n) continue;
      shell.net.quads.push_back(
          {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  for (const double part : parts)
    shell.parts.emplace_back(shell.outer.size(), part);
  return shell;
}

TEST(LayeredShell, HasTheVolumeBetweenItsSurfaces) {
  Shell shell = sheet(4, 3.0, {0.0, 0.2, 0.6, 1.0});
  const Mesh flat = make_layered_shell(shell, {{"skin", 1}, {"fat", 2}});
  const QualityReport report = quality(flat, flat.X());
  EXPECT_NEAR(report.volume, 16.0 * 3.0, 1e-12);
  EXPECT_NEAR(report.sets.at("skin").volume, 16.0 * 0.6, 1e-12);
  EXPECT_NEAR(report.sets.at("fat").volume, 16.0 * 2.4, 1e-12);
  // A slope in the inner surface: the mean depth counts.
  for (Vec3& x : shell.inner)
    x.z() -= 0.5 * x.x();
  const Mesh sloping = make_layered_shell(shell, {{"skin", 1}, {"fat", 2}});
  EXPECT_NEAR(quality(sloping, sloping.X()).volume, 16.0 * 4.0, 1e-12);
}

TEST(LayeredShell, PutsEveryNodeOnItsColumn) {
  const Shell shell = sheet(3, 2.0, {0.0, 0.3, 1.0});
  const Mesh mesh = make_layered_shell(shell, {{"all", 2}});
  for (Index v = 0; v < shell.net.n_vertices; ++v) {
    for (int depth = 0; depth < 3; ++depth) {
      const double z = -2.0 * shell.parts[static_cast<std::size_t>(depth)][at(v)];
      const Vec3 expected(shell.outer[at(v)].x(), shell.outer[at(v)].y(), z);
      EXPECT_LT((mesh.X()[at(shell_node(shell.net, v, depth))] - expected).norm(), 1e-15);
    }
  }
}

TEST(LayeredShell, HasFacesThatLookOutAndSetsThatAreTheWholeBoundary) {
  const Shell shell = sheet(3, 2.0, {0.0, 0.5, 1.0});
  const Mesh mesh = make_layered_shell(shell, {{"skin", 1}, {"fat", 1}});
  for (const auto& [name, z] : {std::pair{"outer", 1.0}, {"inner", -1.0}}) {
    ASSERT_EQ(mesh.faces(name).size(), 9U);
    for (const Vec3& normal : face_normals(mesh, mesh.faces(name), mesh.X()))
      EXPECT_LT((normal - Vec3(0.0, 0.0, z)).norm(), 1e-12) << name;
    std::vector<Index> nodes = face_set_nodes(mesh, mesh.faces(name));
    EXPECT_TRUE(std::ranges::equal(nodes, mesh.nodes(name))) << name;
  }
  std::vector<Face> named;
  for (const char* name : {"outer", "inner", "border"})
    named.insert(named.end(), mesh.faces(name).begin(), mesh.faces(name).end());
  std::ranges::sort(named);
  std::vector<Face> boundary = boundary_faces(mesh);
  std::ranges::sort(boundary);
  EXPECT_EQ(named, boundary);
  EXPECT_EQ(mesh.nodes("border").size(), 3U * 12U);
}

TEST(LayeredShell, OrdersItsLayersFromTheOutsideIn) {
  const Mesh mesh =
      make_layered_shell(sheet(2, 3.0, {0.0, 0.1, 0.5, 1.0}), {{"a", 1}, {"b", 1}, {"c", 1}});
  const std::vector<Face> outward = outward_faces(mesh, mesh.faces("outer"));
  for (const auto& [name, thick] : {std::pair{"a", 0.3}, {"b", 1.2}, {"c", 1.5}}) {
    for (const double t : element_thickness(mesh, mesh.elements(name), outward, mesh.X()))
      EXPECT_NEAR(t, thick, 1e-12) << name;
  }
}

TEST(LayeredShell, RefusesListsThatDoNotFit) {
  const Shell good = sheet(2, 1.0, {0.0, 1.0});
  EXPECT_NO_THROW((void)make_layered_shell(good, {{"all", 1}}));
  EXPECT_THROW((void)make_layered_shell(good, {{"all", 2}}), BugError);
  EXPECT_THROW((void)make_layered_shell(good, {{"all", 1}, {"none", 0}}), BugError);
  Shell shell = good;
  shell.inner.pop_back();
  EXPECT_THROW((void)make_layered_shell(shell, {{"all", 1}}), BugError);
  shell = good;
  shell.parts.back().pop_back();
  EXPECT_THROW((void)make_layered_shell(shell, {{"all", 1}}), BugError);
  shell = good;
  shell.net.quads[0][0] = 99;
  EXPECT_THROW((void)make_layered_shell(shell, {{"all", 1}}), BugError);
}

TEST(WorstCorner, IsTheSmallestScaledJacobianOfTheMesh) {
  Shell shell = sheet(3, 2.0, {0.0, 0.4, 1.0});
  EXPECT_NEAR(worst_corner(shell).scaled_jacobian, 1.0, 1e-15);
  shell.inner[5] += Vec3(1.3, -0.4, 0.9);
  shell.outer[10] += Vec3(-0.2, 0.3, 0.1);
  const WorstCorner worst = worst_corner(shell);
  const Mesh mesh = make_layered_shell(shell, {{"all", 2}});
  double smallest = 1.0;
  for (const ElementQuality& element : quality(mesh, mesh.X()).elements)
    smallest = std::min(smallest, element.scaled_jacobian_corner);
  EXPECT_NEAR(worst.scaled_jacobian, smallest, 1e-14);
  const Index element = worst.layer * 9 + worst.quad;
  EXPECT_NEAR(element_quality(mesh, element, mesh.X()).scaled_jacobian_corner, smallest, 1e-14);
}

// Edges of lengths 1, 2 and 3 from a corner, the third 60 degrees off the normal of the other two.
TEST(ScaledJacobian, IsTheSineOfTheAngleToAFaceWithRightAngles) {
  ShellCorner corner;
  corner.to_next = Vec3(1.0, 0.0, 0.0);
  corner.to_previous = Vec3(0.0, 2.0, 0.0);
  corner.outwards = 3.0 * Vec3(std::sqrt(0.75), 0.0, 0.5);
  EXPECT_NEAR(scaled_jacobian(corner), 0.5, 1e-15);
  corner.outwards = -corner.outwards;
  EXPECT_NEAR(scaled_jacobian(corner), -0.5, 1e-15);
  corner.outwards = Vec3::Zero();
  EXPECT_EQ(scaled_jacobian(corner), 0.0);
}

}  // namespace
}  // namespace facies::mesh
