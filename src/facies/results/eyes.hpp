// SPDX-License-Identifier: Apache-2.0
// Eyeballs to look at.
#pragma once

#include "facies/results/render.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// An eyeball that looks straight ahead (-x): sclera, iris and pupil, each in its colour.
[[nodiscard]] Surface surface_of(const EyeShape& eye);

}  // namespace facies::results
