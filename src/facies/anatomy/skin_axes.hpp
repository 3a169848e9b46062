// SPDX-License-Identifier: Apache-2.0
// The material axes of the skin (paper, "Soft Tissue Constitutive Equations").
#pragma once

#include <span>

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

struct SkinAxes {
  Mat3 axes = Mat3::Identity();  ///< columns a1, a2, a3: orthonormal, right-handed
  bool is_fallback = false;
};

/// a1: `direction` projected on the plane that `normal` (unit, outward) stands on; a2 = normal; a3 = a1 x a2.
/// A direction within 5 degrees of the normal says nothing about the plane; a1 is then horizontal (perpendicular to z),
/// or along y where the plane itself is horizontal.
[[nodiscard]] SkinAxes skin_axes(const Vec3& direction, const Vec3& normal);

/// Fills face.axes: skin_axes on the outward face of each element of the layer "skin", identity elsewhere.
/// `directions` [n_elements], unit. Needs the element set "skin" and the face set "outer"; every skin element must lie
/// in a column below an outer face (BugError). Returns the number of elements where the direction was no use.
std::size_t set_skin_axes(FaceAnatomy& face, std::span<const Vec3> directions);

}  // namespace facies::anatomy
