// SPDX-License-Identifier: Apache-2.0
// Symmetric blocks with their negative eigenvalues taken away.
#pragma once

#include <span>

namespace facies::mechanics {

/// Makes the negative eigenvalues of a symmetric block [n, n] smaller by the part `positivity`: 1 leaves none. Only
/// its lower triangle is read (column-major); all of it is written. A block without eigenvalues that are negative by more than
/// 1e-12 of its largest diagonal entry stays as it is, bit by bit.
void reduce_negative(std::span<double> block, double positivity);

}  // namespace facies::mechanics
