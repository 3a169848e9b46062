// SPDX-License-Identifier: Apache-2.0
// Symmetric blocks with their negative eigenvalues taken away.
#pragma once

#include <span>

namespace facies::mechanics {

/// Makes the negative eigenvalues of a symmetric block [n, n] smaller by the part `positivity`: 1 leaves none. Only
/// its lower triangle is read (column-major); all of it is written, unless no eigenvalue is negative.
void reduce_negative(std::span<double> block, double positivity);

}  // namespace facies::mechanics
