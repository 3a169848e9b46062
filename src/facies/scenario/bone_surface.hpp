// SPDX-License-Identifier: Apache-2.0
// The surface of a bone, read from its file and looked over before tissue may lean on it.
#pragma once

#include "facies/anatomy/jaw.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::scenario {

/// The surface of the file, in mm, coincident vertices merged. A problem for each of: a file that cannot be read; a size
/// that no bone of a face has (a wrong unit); triangles that disagree about which side is outside, or more than two at an
/// edge; a border where the surface should be closed; one that is closed and inside out; one that runs through itself
/// (more than one triangle in a hundred: the few pairs that scanned bones have do no harm here).
[[nodiscard]] mesh::TriangleSurface read_bone_surface(const anatomy::BoneSurface& bone,
                                                      Problems& problems);

}  // namespace facies::scenario
