// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/turn.hpp"

namespace facies::mechanics {

TurnResponse turn_response(const Mat3& R0, const Mat3& R1, const Mat3& inertia) {
  const Mat3 A = 0.5 * inertia.trace() * Mat3::Identity() - inertia;
  const Mat3 B = R1 * A * R0.transpose();
  return {-B.trace(),
          {B(2, 1) - B(1, 2), B(0, 2) - B(2, 0), B(1, 0) - B(0, 1)},
          B.trace() * Mat3::Identity() - 0.5 * (B + B.transpose())};
}

}  // namespace facies::mechanics
