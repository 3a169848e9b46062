// SPDX-License-Identifier: Apache-2.0
// Lines that follow a field of axes over a surface, evenly spaced: what skin tension lines are drawn as.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::results {

/// A surface with an axis on each triangle.
struct AxisField {
  std::vector<Vec3> X;                          ///< vertices [mm]
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<Vec3> axes;  ///< [n_triangles] unit, in the plane of each; both signs mean the same
};

/// A polyline on the surface with the surface's outward unit normals.
struct Streamline {
  std::vector<Vec3> points, normals;
};

/// Lines of points `step` apart that are about `spacing` from each other and never nearer than half of it [mm]
/// (jobard1997). Between triangles the axis changes smoothly; a line ends at a border, where it comes too near to another one or to
/// itself, and where there is no one direction to follow. None is shorter than `spacing`.
[[nodiscard]] std::vector<Streamline> even_streamlines(const AxisField& field, double spacing,
                                                       double step);

}  // namespace facies::results
