// SPDX-License-Identifier: Apache-2.0
// Layers of hexahedra between an outer and an inner surface over one net of quadrilaterals.
#pragma once

#include <string>
#include <vector>

#include "facies/mesh/catmull_clark.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// Where the node layers of a shell lie between its surfaces: parts of the way from the outer vertex to the inner one,
/// ascending from 0 to 1. [n_layers + 1][n_vertices]
using ShellParts = std::vector<std::vector<double>>;

struct Shell {
  QuadNet net;
  std::vector<Vec3> outer, inner;  ///< [n_vertices] [mm]
  ShellParts parts;
};

/// A layer of a shell by name, with its number of elements over the thickness.
struct ShellLayer {
  std::string name;
  int n_elements = 1;
};

/// The node of a shell's mesh at a vertex of its net, `depth` node layers below the outer surface.
[[nodiscard]] inline Index shell_node(const QuadNet& net, Index vertex, int depth) {
  return depth * net.n_vertices + vertex;
}

/// The mesh: nodes layer by layer from the outside in, elements likewise, each with its zeta direction outwards (local face 1 looks out, 0
/// in). Sets: elements by layer, outermost first; faces and nodes outer, inner; faces and nodes border (all faces at the net's borders).
/// Throws BugError where lists do not fit each other or the net (check_net).
[[nodiscard]] Mesh make_layered_shell(const Shell& shell, const std::vector<ShellLayer>& layers);

/// The corner of the elements with the smallest scaled Jacobian.
struct WorstCorner {
  double scaled_jacobian = 1.0;
  Index quad = -1;  ///< of the net
  int layer = -1;   ///< from the outside
};
[[nodiscard]] WorstCorner worst_corner(const Shell& shell);

}  // namespace facies::mesh
