// SPDX-License-Identifier: Apache-2.0
// The built-in face measured as people are: what it was made to have beside what it has.
#pragma once

#include <vector>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// All measures of the drawings, `wanted` with the value that the face was to have, then the depths of soft tissue, `depths` among them
/// likewise. `face` has its mesh and its jaw.
[[nodiscard]] std::vector<FaceLength> lengths_of(const Drawings& drawings,
                                                 const MeasureValues& wanted,
                                                 const MeasureValues& depths,
                                                 const FaceAnatomy& face);

}  // namespace facies::anatomy
