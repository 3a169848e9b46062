// SPDX-License-Identifier: Apache-2.0
// A root that cannot fail to be found.
#pragma once

#include <functional>
#include <stdexcept>

namespace facies::support {

/// The root of a continuous f between `low` and `high`, where its signs differ, to the last bit.
inline double bisect(const std::function<double(double)>& f, double low, double high) {
  const bool negative_at_low = f(low) < 0.0;
  if (negative_at_low == (f(high) < 0.0)) throw std::logic_error("no change of sign");
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    ((f(middle) < 0.0) == negative_at_low ? low : high) = middle;
  }
}

}  // namespace facies::support
