// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/LU>

#include "facies/mesh/columns.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

using NodePositions = Eigen::Matrix<double, 3, 8>;

/// Positions of the element's nodes as columns; zero beyond them.
NodePositions positions_of(const Mesh& mesh, Index e, std::span<const Vec3> x) {
  NodePositions positions = NodePositions::Zero();
  const std::span<const Index> nodes = mesh.element(e).connectivity();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    positions.col(Eigen::Index(i)) = x[at(nodes[i])];
  return positions;
}

double scaled_determinant(const Mat3& dX_dxi) {
  const double lengths = dX_dxi.col(0).norm() * dX_dxi.col(1).norm() * dX_dxi.col(2).norm();
  return lengths > 0.0 ? dX_dxi.determinant() / lengths : 0.0;
}

std::vector<Index> worst_elements(const std::vector<ElementQuality>& elements,
                                  std::size_t n_worst) {
  std::vector<Index> order(elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&](Index e) { return elements[at(e)].scaled_jacobian_gauss; });
  order.resize(std::min(n_worst, order.size()));
  return order;
}

ElementSetQuality set_quality(const Mesh& mesh, std::span<const Index> members,
                              const std::vector<Face>& outward, std::span<const Vec3> x,
                              const std::vector<ElementQuality>& elements) {
  ElementSetQuality set;
  set.n_elements = members.size();
  for (const Index e : members)
    set.volume += elements[at(e)].volume;
  const bool in_columns = !members.empty() && std::ranges::all_of(members, [&](Index e) {
    return outward[at(e)].element >= 0 && opposite_face(mesh, outward[at(e)]).element >= 0;
  });
  if (!in_columns) return set;
  double area = 0.0;
  for (const Index e : members)
    area += face_area(mesh, outward[at(e)], x);
  set.area = area;
  set.mean_thickness = set.volume / area;
  set.thickness = quantiles(element_thickness(mesh, members, outward, x));
  return set;
}

}  // namespace

double element_volume(const Mesh& mesh, Index e, std::span<const Vec3> x) {
  const NodePositions positions = positions_of(mesh, e, x);
  double volume = 0.0;
  for (const QuadraturePoint& point : quadrature(mesh.element(e).type)) {
    volume += point.weight * Mat3(positions * point.dN_dxi).determinant();
  }
  return volume;
}

ElementQuality element_quality(const Mesh& mesh, Index e, std::span<const Vec3> x) {
  const NodePositions positions = positions_of(mesh, e, x);
  const CellType type = mesh.element(e).type;
  constexpr double none = std::numeric_limits<double>::infinity();
  ElementQuality quality{0.0, none, none};
  for (const QuadraturePoint& point : quadrature(type)) {
    const Mat3 dX_dxi = positions * point.dN_dxi;
    quality.volume += point.weight * dX_dxi.determinant();
    quality.scaled_jacobian_gauss =
        std::min(quality.scaled_jacobian_gauss, scaled_determinant(dX_dxi));
  }
  for (std::size_t i = 0; i < n_nodes(type); ++i) {
    const Mat3 dX_dxi = positions * shape_gradients(type, node_xi(type, i));
    quality.scaled_jacobian_corner =
        std::min(quality.scaled_jacobian_corner, scaled_determinant(dX_dxi));
  }
  return quality;
}

double quantile(std::vector<double> values, double p) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const double position = p * double(values.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double part = position - double(below);
  return (1.0 - part) * values[below] + part * values[above];
}

Quantiles quantiles(const std::vector<double>& values) {
  return {quantile(values, 0.05), quantile(values, 0.25), quantile(values, 0.50),
          quantile(values, 0.75), quantile(values, 0.95)};
}

QualityReport quality(const Mesh& mesh, std::span<const Vec3> x, const QualityOptions& options) {
  QualityReport report;
  report.n_nodes = mesh.n_nodes();
  if (!x.empty()) report.lower = report.upper = x[0];
  for (const Vec3& point : x) {
    report.lower = report.lower.cwiseMin(point);
    report.upper = report.upper.cwiseMax(point);
  }
  for (std::size_t i = 0; i < mesh.n_elements(); ++i) {
    const Index e = to_index(i);
    const ElementQuality element = element_quality(mesh, e, x);
    ++(mesh.element(e).type == CellType::hex8 ? report.n_hex : report.n_wedge);
    report.volume += element.volume;
    if (!(element.scaled_jacobian_gauss > 0.0)) report.inverted.push_back(e);
    if (!(element.scaled_jacobian_corner > 0.0)) report.inverted_corners.push_back(e);
    report.elements.push_back(element);
  }
  report.worst = worst_elements(report.elements, options.n_worst);
  const std::vector<Face> outward = outward_faces(mesh, mesh.faces(options.outer));
  for (const auto& [name, members] : mesh.element_sets()) {
    report.sets[name] = set_quality(mesh, members, outward, x, report.elements);
  }
  return report;
}

}  // namespace facies::mesh
