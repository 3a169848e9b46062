// SPDX-License-Identifier: Apache-2.0
// A small sheet of skin on hypodermis that has everything a face has: for examples, tests and first tries.
#pragma once

#include <string>

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// The options of a patch with their defaults, for messages and `facies list faces`.
[[nodiscard]] std::string patch_usage();

/// The patch that "key=value,key=value" describes ("" for the defaults of patch_usage()).
///
/// Its outer surface looks towards -x; layers skin, hypodermis_mid, hypodermis_inner (the fat in two halves); rim nodes
/// on its four sides through all layers; held_in_tension is inner and rim, so that a release leaves the inner nodes
/// free. Muscle STRIP runs up and down between the two halves of the fat, a quarter of the width from either side.
/// Landmarks CENTER, LEFT, RIGHT on the skin, LEFT and RIGHT in front of the muscles.
/// Throws UsageError with all unknown keys and impossible values.
[[nodiscard]] FaceAnatomy make_patch(const std::string& options);

}  // namespace facies::anatomy
