// SPDX-License-Identifier: Apache-2.0
// The change from the drawing to a face with other measures.
#pragma once

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/math/radial_warp.hpp"

namespace facies::anatomy {

/// The warp that takes the landmarks of the drawing to where the values put them, on both sides alike. Throws as place_landmarks.
[[nodiscard]] RadialWarp shape_warp(const Drawings& drawings, const MeasureValues& values);

}  // namespace facies::anatomy
