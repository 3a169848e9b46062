// SPDX-License-Identifier: Apache-2.0
#include "facies/math/barrier.hpp"

#include <cmath>

namespace facies {

BarrierResponse barrier(double d, double d_hat) {
  if (d >= d_hat) return {};
  if (d <= 0.0) return {HUGE_VAL, -HUGE_VAL, HUGE_VAL};
  const double gap = d - d_hat;
  const double log_ratio = std::log(d / d_hat);
  const double gap_by_d = gap / d;
  return {-gap * gap * log_ratio, -gap * (2.0 * log_ratio + gap_by_d),
          -2.0 * log_ratio - 4.0 * gap_by_d + gap_by_d * gap_by_d};
}

}  // namespace facies
