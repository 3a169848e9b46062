// SPDX-License-Identifier: Apache-2.0
// How good a mesh is: volumes, scaled Jacobians, thickness of layers; and what makes it unusable.
//
// Scaled Jacobian: det(dX/dxi) by the product of the lengths of its columns. 1 for a box; at most 0.87 for a wedge over
// an equilateral triangle; not above 0 for an element that is flat or inside out. `x` as in surface.hpp.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// Volume by full quadrature [mm^3], negative inside out.
[[nodiscard]] double element_volume(const Mesh& mesh, Index e, std::span<const Vec3> x);

struct ElementQuality {
  double volume = 0.0;                  ///< [mm^3]
  double scaled_jacobian_gauss = 0.0;   ///< smallest at the quadrature points
  double scaled_jacobian_corner = 0.0;  ///< smallest at the nodes
};

[[nodiscard]] ElementQuality element_quality(const Mesh& mesh, Index e, std::span<const Vec3> x);

/// The value below which the fraction p of the values lies, linear between neighbours; NaN for no values.
[[nodiscard]] double quantile(std::vector<double> values, double p);

struct Quantiles {
  double p05 = 0.0, p25 = 0.0, p50 = 0.0, p75 = 0.0, p95 = 0.0;
};
[[nodiscard]] Quantiles quantiles(const std::vector<double>& values);

/// A set of elements. Area and thickness are there where every element of the set lies in a column of the outer faces
/// (columns.hpp).
struct ElementSetQuality {
  std::size_t n_elements = 0;
  double volume = 0.0;                   ///< [mm^3]
  std::optional<double> area;            ///< of the outward faces [mm^2]
  std::optional<double> mean_thickness;  ///< volume by area [mm]
  std::optional<Quantiles> thickness;    ///< of element_thickness over the elements [mm]
};

struct QualityReport {
  std::size_t n_nodes = 0;
  std::size_t n_hex = 0;
  std::size_t n_wedge = 0;
  Vec3 lower = Vec3::Zero();  ///< of the bounding box [mm]
  Vec3 upper = Vec3::Zero();
  double volume = 0.0;                   ///< [mm^3]
  std::vector<ElementQuality> elements;  ///< [n_elements]
  std::vector<Index> inverted;           ///< scaled Jacobian <= 0 at a quadrature point
  std::vector<Index> inverted_corners;   ///< scaled Jacobian <= 0 at a node
  std::vector<Index> worst;              ///< smallest scaled Jacobian at quadrature points first
  std::map<std::string, ElementSetQuality> sets;
};

struct QualityOptions {
  std::string outer = "outer";  ///< face set on which the columns begin
  std::size_t n_worst = 10;
};

[[nodiscard]] QualityReport quality(const Mesh& mesh, std::span<const Vec3> x,
                                    const QualityOptions& options = {});

/// How the source of a mesh calls its nodes and elements, for messages: "face.node:301".
struct SourceNames {
  std::function<std::string(Index)> node;     ///< empty: "mesh node 300"
  std::function<std::string(Index)> element;  ///< empty: "mesh element 300"
};

/// Everything that makes the mesh unusable: no element at all, coordinates that are not finite, elements that are
/// inverted or flat at a quadrature point, nodes without an element. At most 20 problems of each kind one by one, the
/// rest as a count.
[[nodiscard]] std::vector<Problem> check_geometry(const Mesh& mesh, const SourceNames& names = {});

/// A problem where the longest side of the bounding box is not between `smallest` and `largest` [mm]; its hint names
/// the unit that would fit. Coordinates that are not finite are left to check_geometry.
[[nodiscard]] std::vector<Problem> check_size(const Mesh& mesh, double smallest, double largest);

}  // namespace facies::mesh
