// SPDX-License-Identifier: Apache-2.0
// The surface of a bone, read from its file and looked over before tissue may lean on it.
#pragma once

#include "facies/anatomy/jaw.hpp"
#include "facies/base/error.hpp"

namespace facies::anatomy {

/// The surface of the file, in mm, coincident vertices merged. A problem for each of: a file that cannot be read; a size
/// that no bone of a face has (a wrong unit); triangles that disagree about which side is outside, or more than two at an
/// edge; a border where the surface should be closed; one that is closed and inside out; one that runs through itself
/// (more than two pairs in a thousand triangles: the few that scanned bones have do no harm, see mesh::winding_number).
[[nodiscard]] mesh::TriangleSurface read_bone_surface(const BoneSurface& bone, Problems& problems);

}  // namespace facies::anatomy
