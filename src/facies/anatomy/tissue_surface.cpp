// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/tissue_surface.hpp"

#include <limits>

#include <Eigen/Geometry>

#include "facies/mesh/surface.hpp"
#include "facies/mesh/winding_number.hpp"

namespace facies::anatomy {
namespace {

/// Where the cutting diagonal of each face of a hexahedron begins, as a position in mesh::faces(hex8). With right-handed
/// nodes the diagonals are 0-2, 5-7, 1-4, 1-6, 3-6, 0-7.
constexpr std::array<std::size_t, 6> hex_diagonal{0, 1, 1, 0, 1, 1};

}  // namespace

TissueSurface::TissueSurface(const mesh::Mesh& mesh) {
  surface_.X.assign(mesh.X().begin(), mesh.X().end());
  for (const mesh::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<Index> n = mesh.face_nodes(face);
    const bool is_hex = mesh.element(face.element).type == mesh::CellType::hex8;
    const std::size_t first = is_hex ? hex_diagonal[face.local] : 0;
    const auto corner = [&](std::size_t i) { return n[(first + i) % n.size()]; };
    surface_.triangles.push_back({corner(0), corner(1), corner(2)});
    if (n.size() == 4) surface_.triangles.push_back({corner(0), corner(2), corner(3)});
  }
}

bool TissueSurface::contains(const Vec3& p) const {
  return mesh::winding_number(surface_.X, surface_.triangles, p) > 0.5;
}

Vec3 TissueSurface::nearest(const Vec3& p) const {
  double smallest = std::numeric_limits<double>::infinity();
  Vec3 nearest = p;
  for (const auto& [i, j, k] : surface_.triangles) {
    const Vec3 candidate =
        closest_on_triangle(p, {surface_.X[at(i)], surface_.X[at(j)], surface_.X[at(k)]});
    const double distance = (candidate - p).squaredNorm();
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = candidate;
  }
  return nearest;
}

Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

}  // namespace facies::anatomy
