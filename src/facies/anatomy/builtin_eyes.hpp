// SPDX-License-Identifier: Apache-2.0
// The eyeballs of the built-in face.
#pragma once

#include <vector>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_tissue.hpp"
#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// An eyeball behind the drawn lids of the right eye, as far forward as they let it, and its mirror image.
[[nodiscard]] std::vector<Eye> place_eyes(const Drawings& drawings, const BuiltinTissue& tissue);

}  // namespace facies::anatomy
