// SPDX-License-Identifier: Apache-2.0
// The skin tension lines of the built-in face: a smooth field between curves that are drawn on its skin (borges1984;
// docs/theory/builtin-face.md, "Skin tension lines").
#pragma once

#include <vector>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/mesh/line_field.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::anatomy {

/// The drawn curves, straight between their points in the frontal view, and their mirror images as short pieces on an outer surface,
/// given at the vertices that sites refer to [mm]. Adds a problem for each stretch between two points, or for its first point, that
/// leaves the face.
[[nodiscard]] std::vector<mesh::LinePiece> place_lines(const Drawings& drawings,
                                                       const SkinSites& sites,
                                                       const std::vector<Vec3>& outer,
                                                       Problems& problems);

/// The lines at the vertices that sites refer to, the same for every size of the mesh.
[[nodiscard]] mesh::LineField tension_lines(const SkinSites& sites, const std::vector<Vec3>& outer,
                                            const std::vector<mesh::LinePiece>& pieces);

/// The line of each skin element, unit; elsewhere y. [n_elements] An element that covers several quadrilaterals of the net that sites
/// refer to has the mean of their lines (as axes, without sign, weighted by their strength); one that is a part of one has its line.
/// `mesh` is one that make_layered_shell made over a refinement of the drawing's net.
[[nodiscard]] std::vector<Vec3> line_directions(const mesh::Mesh& mesh, const SkinSites& sites,
                                                const mesh::LineField& lines);

}  // namespace facies::anatomy
