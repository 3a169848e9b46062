// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/tissue_surface.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "facies/mesh/surface.hpp"

namespace facies::anatomy {
namespace {

/// Where the cutting diagonal of each face of a hexahedron begins, as a position in mesh::faces(hex8). With right-handed
/// nodes the diagonals are 0-2, 5-7, 1-4, 1-6, 3-6, 0-7.
constexpr std::array<std::size_t, 6> hex_diagonal{0, 1, 1, 0, 1, 1};

double solid_angle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  const Vec3 a = triangle[0] - p;
  const Vec3 b = triangle[1] - p;
  const Vec3 c = triangle[2] - p;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

TissueSurface::TissueSurface(const mesh::Mesh& mesh) {
  for (const mesh::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<Index> n = mesh.face_nodes(face);
    const bool is_hex = mesh.element(face.element).type == mesh::CellType::hex8;
    const std::size_t first = is_hex ? hex_diagonal[face.local] : 0;
    const auto corner = [&](std::size_t i) { return mesh.X()[at(n[(first + i) % n.size()])]; };
    triangles_.push_back({corner(0), corner(1), corner(2)});
    if (n.size() == 4) triangles_.push_back({corner(0), corner(2), corner(3)});
  }
}

bool TissueSurface::contains(const Vec3& p) const {
  double sum = 0.0;
  for (const std::array<Vec3, 3>& triangle : triangles_)
    sum += solid_angle(p, triangle);
  return sum > 2.0 * std::numbers::pi;
}

Vec3 TissueSurface::nearest(const Vec3& p) const {
  double smallest = std::numeric_limits<double>::infinity();
  Vec3 nearest = p;
  for (const std::array<Vec3, 3>& triangle : triangles_) {
    const Vec3 candidate = closest_on_triangle(p, triangle);
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
