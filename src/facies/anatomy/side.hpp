// SPDX-License-Identifier: Apache-2.0
// Sides of a face: the subject's own.
#pragma once

namespace facies::anatomy {

enum class Side { left, right, middle };

}  // namespace facies::anatomy
