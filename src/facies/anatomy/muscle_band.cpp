// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/muscle_band.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "facies/mesh/segments.hpp"

namespace facies::anatomy {
namespace {

constexpr int n_cuts = 4;  // of each local coordinate

/// The middles of 4 x 4 equal parts of the square [-1, 1]^2.
std::vector<Eigen::Vector2d> parts_of_square() {
  std::vector<Eigen::Vector2d> parts;
  for (int i = 0; i < n_cuts; ++i) {
    for (int j = 0; j < n_cuts; ++j)
      parts.emplace_back((2.0 * i + 1.0) / n_cuts - 1.0, (2.0 * j + 1.0) / n_cuts - 1.0);
  }
  return parts;
}

/// The middles of the 16 triangles that lines parallel to its sides cut the unit triangle into.
std::vector<Eigen::Vector2d> parts_of_triangle() {
  std::vector<Eigen::Vector2d> parts;
  for (int i = 0; i < n_cuts; ++i) {
    for (int j = 0; i + j < n_cuts; ++j) {
      parts.emplace_back((i + 1.0 / 3.0) / n_cuts, (j + 1.0 / 3.0) / n_cuts);
      if (i + j + 1 < n_cuts)
        parts.emplace_back((i + 2.0 / 3.0) / n_cuts, (j + 2.0 / 3.0) / n_cuts);
    }
  }
  return parts;
}

/// Middles of the parts of an element in its local coordinates.
std::vector<Vec3> local_parts(mesh::CellType type) {
  std::vector<Vec3> parts;
  for (const Eigen::Vector2d& part :
       type == mesh::CellType::hex8 ? parts_of_square() : parts_of_triangle()) {
    for (int k = 0; k < n_cuts; ++k)
      parts.emplace_back(part.x(), part.y(), (2.0 * k + 1.0) / n_cuts - 1.0);
  }
  return parts;
}

/// Nodes of a face in an order that does not depend on the element.
std::vector<Index> sorted_nodes(const mesh::Mesh& mesh, mesh::Face face) {
  std::vector<Index> nodes = mesh.face_nodes(face);
  std::ranges::sort(nodes);
  return nodes;
}

}  // namespace

bool is_in_band(const Vec3& x, const BandSegment& segment, const BandSize& size) {
  const mesh::ClosestPoint closest = mesh::closest_on_segment(x, segment.a, segment.b);
  const Vec3 along = (segment.b - segment.a).normalized();
  const Vec3 offset = x - closest.point;
  constexpr double rounding = 1e-9;  // [mm]
  const bool is_beyond =
      (segment.begins && closest.parameter == 0.0) || (segment.ends && closest.parameter == 1.0);
  if (is_beyond && std::abs(offset.dot(along)) > rounding) return false;
  const Vec3 outward = segment.normal_a + closest.parameter * (segment.normal_b - segment.normal_a);
  const Vec3 normal = (outward - outward.dot(along) * along).normalized();
  const double depth = std::abs(offset.dot(normal));
  // Around a bend of the fibre the band is round.
  const double sideways = std::sqrt(std::max(0.0, offset.squaredNorm() - depth * depth));
  return depth <= 0.5 * size.thickness && sideways <= 0.5 * size.width;
}

std::vector<ElementPart> parts_of(const mesh::Mesh& mesh, Index e) {
  static const std::array<std::vector<Vec3>, 2> local{local_parts(mesh::CellType::hex8),
                                                      local_parts(mesh::CellType::wedge6)};
  const mesh::Element& element = mesh.element(e);
  const std::span<const Index> nodes = element.connectivity();
  const bool is_hexahedron = element.type == mesh::CellType::hex8;
  const double local_volume = (is_hexahedron ? 8.0 : 1.0) / (n_cuts * n_cuts * n_cuts);
  std::vector<ElementPart> parts;
  for (const Vec3& xi : local[is_hexahedron ? 0 : 1]) {
    const mesh::ShapeValues N = mesh::shape_values(element.type, xi);
    const mesh::ShapeGradients dN = mesh::shape_gradients(element.type, xi);
    ElementPart part;
    Mat3 dX_dxi = Mat3::Zero();
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const auto row = static_cast<Eigen::Index>(a);
      const Vec3& X = mesh.X()[at(nodes[a])];
      part.middle += N(row) * X;
      dX_dxi += X * dN.row(row);
    }
    part.volume = dX_dxi.determinant() * local_volume;
    parts.push_back(part);
  }
  return parts;
}

std::vector<Index> without_lone_elements(const mesh::Mesh& mesh,
                                         const std::vector<Index>& elements) {
  std::map<std::vector<Index>, Index> first_with;
  std::set<Index> in_company;
  for (const Index e : elements) {
    const auto n_faces = static_cast<std::uint8_t>(mesh::faces(mesh.element(e).type).size());
    for (std::uint8_t local = 0; local < n_faces; ++local) {
      const auto [found, is_new] = first_with.try_emplace(sorted_nodes(mesh, {e, local}), e);
      if (!is_new) in_company.insert({e, found->second});
    }
  }
  return {in_company.begin(), in_company.end()};
}

}  // namespace facies::anatomy
