// SPDX-License-Identifier: Apache-2.0
// What holds the built-in face: its rim and where it is tied to bone.
#pragma once

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_tissue.hpp"

namespace facies::anatomy {

/// Sets the node sets that models rely on (face_anatomy.hpp): "rim" along the border around the face, "held_in_tension", and the drawn
/// regions on the inner surface. No node is in two of rim and regions.
void set_supports(const Drawings& drawings, BuiltinTissue& tissue);

}  // namespace facies::anatomy
