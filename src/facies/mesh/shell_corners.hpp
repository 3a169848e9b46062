// SPDX-License-Identifier: Apache-2.0
// The corners of a shell's elements, for measures of their shape.
#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "facies/mesh/layered_shell.hpp"

namespace facies::mesh {

/// One corner of one element: a right-handed set of edges from it where the element is not inside out.
struct ShellCorner {
  Index quad = -1;  ///< of the net
  int layer = -1;   ///< from the outside
  /// Vertices of the corner and of its two neighbours in the net, and depths of the corner's node layer and of the other one.
  Index vertex = -1, next = -1, previous = -1;
  int depth = 0, other_depth = 0;
  Vec3 to_next = Vec3::Zero(), to_previous = Vec3::Zero(), outwards = Vec3::Zero();  ///< [mm]
};

/// 1 for edges at right angles, 0 for edges in a plane, negative inside out (quality.hpp); 0 where an edge has no length.
[[nodiscard]] inline double scaled_jacobian(const ShellCorner& corner) {
  const double lengths = corner.to_next.norm() * corner.to_previous.norm() * corner.outwards.norm();
  return corner.to_next.cross(corner.to_previous).dot(corner.outwards) / std::max(lengths, 1e-30);
}

/// Calls look(corner) for all eight corners of every element, layer by layer from the outside in.
template <class Look>
void for_each_corner(const Shell& shell, const Look& look) {
  const auto x = [&](Index v, int depth) -> Vec3 {
    const double part = shell.parts[static_cast<std::size_t>(depth)][at(v)];
    return shell.outer[at(v)] + part * (shell.inner[at(v)] - shell.outer[at(v)]);
  };
  const int n_layers = static_cast<int>(shell.parts.size()) - 1;
  for (int layer = 0; layer < n_layers; ++layer) {
    for (std::size_t q = 0; q < shell.net.quads.size(); ++q) {
      const auto& quad = shell.net.quads[q];
      for (std::size_t k = 0; k < 4; ++k) {
        ShellCorner corner;
        corner.quad = to_index(q);
        corner.layer = layer;
        corner.vertex = quad[k];
        corner.next = quad[(k + 1) % 4];
        corner.previous = quad[(k + 3) % 4];
        const Vec3 column = x(corner.vertex, layer) - x(corner.vertex, layer + 1);
        for (const int depth : {layer, layer + 1}) {
          corner.depth = depth;
          corner.other_depth = 2 * layer + 1 - depth;
          const Vec3 own = x(corner.vertex, depth);
          corner.to_next = x(corner.next, depth) - own;
          corner.to_previous = x(corner.previous, depth) - own;
          corner.outwards = column;
          look(corner);
        }
      }
    }
  }
}

}  // namespace facies::mesh
