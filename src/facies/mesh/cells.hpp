// SPDX-License-Identifier: Apache-2.0
// The two element types: topology, shape functions, quadrature.
//
// Hexahedron: nodes 0-3 counter-clockwise at zeta = -1 seen from +zeta, 4-7 above them (VTK_HEXAHEDRON).
// Wedge: triangle 0-2 at zeta = -1, triangle 3-5 above it. Positive Jacobian means: seen from +zeta, 0 1 2 counter-clockwise
// (the triangle's normal points into the element). VTK_WEDGE counts its triangles the other way; only writers know that.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mesh {

enum class CellType : std::uint8_t { hex8, wedge6 };

/// The largest number of nodes of an element.
inline constexpr std::size_t max_nodes = 8;
/// Shape function values of an element's nodes; rows beyond n_nodes(type) are zero.
using ShapeValues = Eigen::Matrix<double, 8, 1>;
/// Gradients, one row per node; rows beyond n_nodes(type) are zero.
using ShapeGradients = Eigen::Matrix<double, 8, 3>;

[[nodiscard]] constexpr std::size_t n_nodes(CellType type) {
  return type == CellType::hex8 ? 8 : 6;
}
[[nodiscard]] std::string_view name(CellType type);

/// The element's faces as local node numbers, each counter-clockwise seen from outside.
/// Order: the face at zeta = -1, the face at zeta = +1, then the quadrilaterals around them.
[[nodiscard]] std::span<const std::vector<std::uint8_t>> faces(CellType type);

/// The element's edges as pairs of local node numbers.
[[nodiscard]] std::span<const std::array<std::uint8_t, 2>> edges(CellType type);

/// Local coordinates of node `local`.
[[nodiscard]] Vec3 node_xi(CellType type, std::size_t local);

/// N at xi. Hex: xi in [-1,1]^3; wedge: (r, s) in the unit triangle, zeta in [-1,1].
[[nodiscard]] ShapeValues shape_values(CellType type, const Vec3& xi);

/// dN/dxi at xi, one row per node.
[[nodiscard]] ShapeGradients shape_gradients(CellType type, const Vec3& xi);

struct QuadraturePoint {
  Vec3 xi;
  double weight = 0.0;
  ShapeValues N;
  ShapeGradients dN_dxi;
};

/// Full quadrature: 2x2x2 Gauss points for the hexahedron, 3x2 for the wedge.
[[nodiscard]] std::span<const QuadraturePoint> quadrature(CellType type);

}  // namespace facies::mesh
