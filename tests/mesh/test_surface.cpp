// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <numbers>

#include "mesh/shapes.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

double volume_by_quadrature(const Mesh& mesh) {
  double volume = 0.0;
  for (Index e = 0; at(e) < mesh.n_elements(); ++e)
    volume += element_volume(mesh, e, mesh.X());
  return volume;
}

/// Divergence theorem for the triangles: a sixth of the sum of the triple products.
double enclosed_volume(const FaceTriangles& surface, std::span<const Vec3> x) {
  double volume = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    volume += x[at(a)].dot(x[at(b)].cross(x[at(c)])) / 6.0;
  }
  return volume;
}

TEST(Surface, OfAMixedMeshIsClosedAndLooksOutward) {
  const Mesh mesh = shaken_checkerboard(0.15);
  const std::vector<Face> boundary = boundary_faces(mesh);
  Vec3 sum = Vec3::Zero();
  for (const Face& face : boundary) {
    sum += area_vector(mesh, face, mesh.X());
  }
  EXPECT_LT(sum.norm(), 1e-13);

  std::map<std::pair<Index, Index>, int> directed_edges;
  for (const auto& t : triangulate(mesh, boundary).triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      ++directed_edges[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : directed_edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed_edges.count({edge.second, edge.first}), 1U);
  }
}

TEST(Surface, EnclosesTheVolumeThatQuadratureFinds) {
  // Plane faces: triangles and bilinear faces bound the same body.
  const Mesh straight = shaken_checkerboard(0.0);
  EXPECT_NEAR(volume_by_quadrature(straight), 4.0 * 3.0 * 2.0, 1e-12);
  EXPECT_NEAR(enclosed_volume(triangulate(straight, boundary_faces(straight)), straight.X()), 24.0,
              1e-12);

  // Warped faces: each triangle pair misses the bilinear face, to one side or the other; both
  // diagonals together give it exactly.
  const Mesh warped = shaken_checkerboard(0.15);
  double volume = 0.0;
  for (const Face& face : boundary_faces(warped)) {
    std::vector<Index> n = warped.face_nodes(face);
    FaceTriangles one{{{n[0], n[1], n[2]}}, {}};
    FaceTriangles other = one;
    if (n.size() == 4) {
      one.triangles = {{n[0], n[1], n[2]}, {n[0], n[2], n[3]}};
      other.triangles = {{n[1], n[2], n[3]}, {n[1], n[3], n[0]}};
    }
    volume += 0.5 * (enclosed_volume(one, warped.X()) + enclosed_volume(other, warped.X()));
  }
  EXPECT_NEAR(volume_by_quadrature(warped), volume, 1e-12);
}

TEST(Surface, OfSomeElementsIncludesTheirCommonBorderWithTheRest) {
  const Mesh mesh = make_layered_sheet({});
  const auto skin = boundary_faces(mesh, mesh.elements("skin"));
  EXPECT_EQ(skin.size(), 2U * 64U + 4U * 8U);
  const auto both = boundary_faces(mesh);
  EXPECT_EQ(both.size(), 2U * 64U + 3U * 4U * 8U);
}

TEST(Surface, CutsAFaceAlikeFromBothSides) {
  const Mesh mesh = make_layered_sheet({});
  const std::vector<Index> below_elements = {to_index(mesh.elements("skin").size())};
  const Face above{0, 0};
  const Face below{below_elements[0], 1};
  ASSERT_EQ(face_key(mesh, above), face_key(mesh, below));
  const auto sorted_triangles = [&](Face face) {
    auto triangles = triangulate(mesh, std::vector<Face>{face}).triangles;
    for (auto& t : triangles)
      std::ranges::sort(t);
    std::ranges::sort(triangles);
    return triangles;
  };
  EXPECT_EQ(sorted_triangles(above), sorted_triangles(below));
}

TEST(Surface, KnowsWhichFaceATriangleCameFrom) {
  const Mesh mesh = single_element(CellType::wedge6);
  const FaceTriangles surface = triangulate(mesh, boundary_faces(mesh));
  EXPECT_THAT(surface.face, ::testing::ElementsAre(0, 1, 2, 2, 3, 3, 4, 4));
}

TEST(Surface, HasTheAreaAndNormalsOfASphere) {
  SheetOptions options;
  options.shape = SheetShape::sphere;
  options.radius = 50.0;
  options.size_y = options.size_z = 50.0 * std::numbers::pi / 2.0;  // a whole face of the cube
  const auto area_error = [&](int n) {
    options.n_y = options.n_z = n;
    const Mesh mesh = make_layered_sheet(options);
    const double exact = 4.0 * std::numbers::pi * 50.0 * 50.0 / 6.0;
    return std::abs(surface_area(mesh, mesh.faces("outer"), mesh.X()) / exact - 1.0);
  };
  EXPECT_NEAR(area_error(8) / area_error(16), 4.0, 0.2);

  const Mesh mesh = make_layered_sheet(options);
  const std::vector<Vec3> normals = vertex_normals(mesh, mesh.faces("outer"), mesh.X());
  const Vec3 centre(50.0, 0.0, 0.0);
  for (const Index n : mesh.nodes("outer")) {
    EXPECT_GT(normals[at(n)].dot((mesh.X()[at(n)] - centre).normalized()), 0.995);
  }
  EXPECT_EQ(normals[at(mesh.nodes("inner")[0])], Vec3::Zero().eval());
  for (const Vec3& normal : face_normals(mesh, mesh.faces("inner"), mesh.X())) {
    EXPECT_GT(normal.x(), 0.0);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
  }
}

TEST(Surface, TurnsItsNormalsWithTheNodes) {
  const Mesh mesh = make_layered_sheet({});
  const Mat3 R = support::Random(3).rotation();
  std::vector<Vec3> x;
  for (const Vec3& X : mesh.X())
    x.emplace_back(2.0 * R * X);
  const auto outer = mesh.faces("outer");
  EXPECT_TRUE(face_normals(mesh, outer, x)[5].isApprox(-R.col(0), 1e-14));
  EXPECT_NEAR(surface_area(mesh, outer, x), 4.0 * 1600.0, 1e-9);
}

TEST(FaceArea, OfAWarpedFaceIsThatOfItsBilinearSurface) {
  // z = h x y on [-1,1]^2: area by a fine midpoint rule.
  const double h = 0.5;
  std::vector<Vec3> X;
  for (std::size_t i = 0; i < 8; ++i) {
    Vec3 p = node_xi(CellType::hex8, i);
    if (i >= 4) p(2) = 2.0 + h * p(0) * p(1);
    X.push_back(p);
  }
  const Mesh mesh(X, {{CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7}}});
  double exact = 0.0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = -1.0 + (2.0 * i + 1.0) / n;
      const double y = -1.0 + (2.0 * j + 1.0) / n;
      exact += std::sqrt(1.0 + h * h * (x * x + y * y)) * 4.0 / (n * n);
    }
  }
  EXPECT_NEAR(face_area(mesh, {0, 1}, mesh.X()), exact, 0.002 * exact);
  EXPECT_TRUE(area_vector(mesh, {0, 1}, mesh.X()).isApprox(Vec3(0.0, 0.0, 4.0)));
  EXPECT_DOUBLE_EQ(face_area(mesh, {0, 0}, mesh.X()), 4.0);
}

}  // namespace
}  // namespace facies::mesh
