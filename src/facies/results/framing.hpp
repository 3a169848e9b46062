// SPDX-License-Identifier: Apache-2.0
// Where cameras stand: the same views, in one frame and at one scale, for all pictures of a run.
#pragma once

#include <string>
#include <vector>

#include "facies/mesh/mesh.hpp"
#include "facies/results/render.hpp"

namespace facies::results {

struct View {
  std::string name;
  Camera camera;
};

/// Displacements of all nodes in each of several states.
using States = std::span<const std::vector<Vec3>* const>;

/// Front, three-quarter and profile (the subject's right side), each `height` pixels high. They show the mesh as read with some
/// room around it, and every state.
[[nodiscard]] std::vector<View> standard_views(const mesh::Mesh& mesh, States states, int height);

/// The midsagittal plane y = 0 and the left half behind it, in the frame of the profile; then, where the mesh has the face set
/// "mouth", the surroundings of the mouth enlarged.
[[nodiscard]] std::vector<View> section_views(const mesh::Mesh& mesh, States states, int height);

/// A horizontal plane seen from below, the front of the face at the top and its right side on the left: at the height of the middle of the face set "mouth", without it half-way up the mesh.
[[nodiscard]] View transverse_view(const mesh::Mesh& mesh, States states, int height);

}  // namespace facies::results
