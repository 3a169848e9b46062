// SPDX-License-Identifier: Apache-2.0
// Trilinear hexahedron and linear wedge, e.g. T. Hughes, The Finite Element Method (2000), chapter 3.
#include "facies/mesh/cells.hpp"

#include <cmath>

namespace facies::mesh {
namespace {

using FaceList = std::vector<std::vector<std::uint8_t>>;
using Edge = std::array<std::uint8_t, 2>;

constexpr std::array<std::array<double, 3>, 8> hex_xi{{{-1, -1, -1},
                                                       {1, -1, -1},
                                                       {1, 1, -1},
                                                       {-1, 1, -1},
                                                       {-1, -1, 1},
                                                       {1, -1, 1},
                                                       {1, 1, 1},
                                                       {-1, 1, 1}}};
constexpr std::array<std::array<double, 3>, 6> wedge_xi{
    {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};

constexpr std::array<Edge, 12> hex_edges{{{0, 1},
                                          {1, 2},
                                          {2, 3},
                                          {3, 0},
                                          {4, 5},
                                          {5, 6},
                                          {6, 7},
                                          {7, 4},
                                          {0, 4},
                                          {1, 5},
                                          {2, 6},
                                          {3, 7}}};
constexpr std::array<Edge, 9> wedge_edges{
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

/// Triangle coordinates 1-r-s, r, s of the wedge and their (constant) derivatives by r and s.
Vec3 triangle_values(const Vec3& xi) {
  return {1.0 - xi(0) - xi(1), xi(0), xi(1)};
}
const std::array<std::array<double, 2>, 3> triangle_gradients{{{-1, -1}, {1, 0}, {0, 1}}};

QuadraturePoint make_point(CellType type, const Vec3& xi, double weight) {
  return {xi, weight, shape_values(type, xi), shape_gradients(type, xi)};
}

/// 2x2x2 Gauss points at +-1/sqrt(3), the first coordinate running fastest. Exact to degree 3 in each coordinate.
std::vector<QuadraturePoint> make_hex_quadrature() {
  const double g = 1.0 / std::sqrt(3.0);
  std::vector<QuadraturePoint> points;
  for (const double zeta : {-g, g}) {
    for (const double eta : {-g, g}) {
      for (const double xi : {-g, g}) {
        points.push_back(make_point(CellType::hex8, {xi, eta, zeta}, 1.0));
      }
    }
  }
  return points;
}

/// Three interior points in the triangle (exact to degree 2) times two Gauss points along zeta (exact to degree 3).
std::vector<QuadraturePoint> make_wedge_quadrature() {
  const double g = 1.0 / std::sqrt(3.0);
  const double a = 1.0 / 6.0;
  const double b = 2.0 / 3.0;
  std::vector<QuadraturePoint> points;
  for (const double zeta : {-g, g}) {
    points.push_back(make_point(CellType::wedge6, {a, a, zeta}, a));
    points.push_back(make_point(CellType::wedge6, {b, a, zeta}, a));
    points.push_back(make_point(CellType::wedge6, {a, b, zeta}, a));
  }
  return points;
}

}  // namespace

std::string_view name(CellType type) {
  return type == CellType::hex8 ? "hex8" : "wedge6";
}

std::span<const std::vector<std::uint8_t>> faces(CellType type) {
  static const FaceList hex{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  static const FaceList wedge{{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return type == CellType::hex8 ? hex : wedge;
}

std::span<const std::array<std::uint8_t, 2>> edges(CellType type) {
  if (type == CellType::hex8) return hex_edges;
  return wedge_edges;
}

Vec3 node_xi(CellType type, std::size_t local) {
  const std::array<double, 3>& xi = type == CellType::hex8 ? hex_xi.at(local) : wedge_xi.at(local);
  return {xi[0], xi[1], xi[2]};
}

ShapeValues shape_values(CellType type, const Vec3& xi) {
  ShapeValues N = ShapeValues::Zero();
  if (type == CellType::hex8) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& [x, y, z] = hex_xi[i];
      N(Eigen::Index(i)) = 0.125 * (1.0 + x * xi(0)) * (1.0 + y * xi(1)) * (1.0 + z * xi(2));
    }
  } else {
    const Vec3 L = triangle_values(xi);
    N.segment<3>(0) = 0.5 * (1.0 - xi(2)) * L;
    N.segment<3>(3) = 0.5 * (1.0 + xi(2)) * L;
  }
  return N;
}

ShapeGradients shape_gradients(CellType type, const Vec3& xi) {
  ShapeGradients dN = ShapeGradients::Zero();
  if (type == CellType::hex8) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& [x, y, z] = hex_xi[i];
      const double fx = 1.0 + x * xi(0);
      const double fy = 1.0 + y * xi(1);
      const double fz = 1.0 + z * xi(2);
      dN.row(Eigen::Index(i)) << 0.125 * x * fy * fz, 0.125 * fx * y * fz, 0.125 * fx * fy * z;
    }
  } else {
    const Vec3 L = triangle_values(xi);
    const double below = 0.5 * (1.0 - xi(2));
    const double above = 0.5 * (1.0 + xi(2));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [dr, ds] = triangle_gradients[i];
      dN.row(Eigen::Index(i)) << below * dr, below * ds, -0.5 * L(Eigen::Index(i));
      dN.row(Eigen::Index(i + 3)) << above * dr, above * ds, 0.5 * L(Eigen::Index(i));
    }
  }
  return dN;
}

std::span<const QuadraturePoint> quadrature(CellType type) {
  static const std::vector<QuadraturePoint> hex = make_hex_quadrature();
  static const std::vector<QuadraturePoint> wedge = make_wedge_quadrature();
  return type == CellType::hex8 ? hex : wedge;
}

}  // namespace facies::mesh
