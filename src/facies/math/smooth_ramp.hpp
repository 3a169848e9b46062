// SPDX-License-Identifier: Apache-2.0
// max(x, 0) with its corner rounded: what sets in at a threshold keeps a continuous stiffness.
#pragma once

namespace facies {

struct Ramp {
  double integral = 0.0;  ///< from -infinity to x
  double value = 0.0;
  double slope = 0.0;
};

/// 0 below -h, x above h, a parabola in between (h > 0): value and slope are continuous, and the value is nowhere more than h/4
/// away from max(x, 0).
[[nodiscard]] constexpr Ramp smooth_ramp(double x, double h) {
  if (x <= -h) return {};
  if (x >= h) return {0.5 * x * x + h * h / 6.0, x, 1.0};
  const double y = x + h;
  return {y * y * y / (12.0 * h), y * y / (4.0 * h), y / (2.0 * h)};
}

}  // namespace facies
