// SPDX-License-Identifier: Apache-2.0
// What turning from one rotation to another costs where resistance is an inertia tensor.
#pragma once

#include "facies/math/tensor.hpp"

namespace facies::mechanics {

/// E = -tr(R1 A R0^T), A = tr(I)/2 - I, and its first and second derivatives by a further rotation of R1 in space. For a
/// small turn w from R0 they are a constant + w.I w / 2, I w and I, with I turned into space. moment / h is the
/// momentum half-way of a turn in the time h, to second order, and exactly that of a free body in the discrete motion of Moser
/// and Veselov (1991).
struct TurnResponse {
  double energy = 0.0;
  Vec3 moment;
  Mat3 stiffness;
};
[[nodiscard]] TurnResponse turn_response(const Mat3& R0, const Mat3& R1, const Mat3& inertia);

}  // namespace facies::mechanics
