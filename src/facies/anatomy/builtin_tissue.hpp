// SPDX-License-Identifier: Apache-2.0
// From drawn surfaces to the layered mesh of the built-in face.
#pragma once

#include "facies/anatomy/builtin_options.hpp"
#include "facies/anatomy/cage.hpp"
#include "facies/mesh/layered_shell.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::anatomy {

/// The tissue between two drawn surfaces.
struct BuiltinTissue {
  mesh::Mesh mesh;  ///< sets of make_layered_shell; layers as layer_names()
  mesh::LimitMesh
      limit;       ///< its net from the drawing's; node of a drawn point and depth: shell_node
  int n_deep = 0;  ///< element layers
  std::vector<Vec3> outer_control, inner_control;  ///< control points on the drawing's net
};

/// The mesh between the surfaces through `outer` and `inner`, points on the skin's net, the inner one evened out and, where a column
/// meets one of the bones, `gap` [mm] in front of it. Symmetric where both surfaces are. The skin follows `thickness` [mm], values at the
/// net's vertices, smoothly, and is at most 0.3 of a column, the rest of which two layers of fat share equally.
/// Throws DataError where elements remain with a scaled Jacobian below 0.05 at a corner.
[[nodiscard]] BuiltinTissue make_tissue(const Cage& skin, const std::vector<Vec3>& outer,
                                        const std::vector<Vec3>& inner,
                                        const std::vector<double>& thickness,
                                        const std::vector<mesh::TriangleSurface>& bones, double gap,
                                        FaceSize size);

}  // namespace facies::anatomy
