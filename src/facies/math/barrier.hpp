// SPDX-License-Identifier: Apache-2.0
// The barrier of Incremental Potential Contact: nothing beyond a distance d_hat, infinite at contact.
#pragma once

namespace facies {

/// The barrier [mm^2] with its first [mm] and second [-] derivatives by the distance.
struct BarrierResponse {
  double b = 0.0;
  double db_dd = 0.0;
  double d2b_dd2 = 0.0;
};

/// b(d) = -(d - d_hat)^2 ln(d / d_hat) for 0 < d < d_hat and 0 beyond: li2020, Eq. 6. Twice continuously differentiable,
/// falling and convex; b and its derivatives are infinite for d <= 0. Distances in mm, d_hat > 0. The stiffness that
/// makes it an energy is the caller's.
[[nodiscard]] BarrierResponse barrier(double d, double d_hat);

}  // namespace facies
