// SPDX-License-Identifier: Apache-2.0
// Where a face's surface may touch something: bone whose surface is not given, and itself.
#pragma once

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// Adds two face sets to the mesh. "on_bone": inner faces that lie on bone of the skull, all of whose nodes are at least
/// `above` [mm] high (the floor of the nose on the reference face) and in none of the node sets "*_free", behind which
/// there is no bone. "mouth": faces of the boundary within `around` [mm] of the line between the mouth corners (landmarks
/// LMC and RMC) in the frontal view. A set without faces is not added.
void mark_contact_regions(FaceAnatomy& face, double above = 120.0, double around = 14.0);

}  // namespace facies::anatomy
