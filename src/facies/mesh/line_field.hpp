// SPDX-License-Identifier: Apache-2.0
// Smooth fields of lines (directions without a sign) on surfaces, between pieces of lines that are drawn on them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "facies/mesh/catmull_clark.hpp"

namespace facies::mesh {

/// A short piece of a drawn line, at a place between vertices of a net.
struct LinePiece {
  std::array<Index, 3> vertices{-1, -1, -1};
  Vec3 parts = Vec3::Zero();  ///< of the vertices; not negative, their sum is 1
  Vec3 along = Vec3::Zero();  ///< from its beginning to its end [mm]
};

/// A line at each vertex of a net.
struct LineField {
  std::vector<Vec3> directions;  ///< unit, in the surface; v and -v are the same line
  /// 1 where the drawn lines around agree, 0 at a singular point.
  std::vector<double> strength;
};

/// The field that is smoothest for how near it comes to the pieces (docs/theory/builtin-face.md, "Skin tension lines"; the connection
/// is that of knoppel2013): the least of
///   integral of |grad z|^2 over the surface + adherence * sum over pieces of length * sum over vertices of parts * |z - z_piece|^2
/// where z at a vertex is the complex number in its tangent plane whose angle is twice that of the line.
/// `X` [net.n_vertices] [mm], no quadrilateral with a flat corner, and a piece on every part that hangs together; `adherence` [1/mm],
/// positive: over about its inverse the field comes from its surroundings to a piece. Mirror images make mirror images, to rounding.
/// Throws BugError where lists do not fit each other and where there is no piece.
[[nodiscard]] LineField smooth_line_field(const QuadNet& net, std::span<const Vec3> X,
                                          std::span<const LinePiece> pieces, double adherence);

}  // namespace facies::mesh
