// SPDX-License-Identifier: Apache-2.0
// A number that changes in time: straight lines between points.
#pragma once

#include <vector>

namespace facies::scenario {

struct CurvePoint {
  double time = 0.0;  ///< [s]
  double value = 0.0;

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Points in the order of their times, no two at the same. Before the first the value of the first, after the last that
/// of the last; a curve of one point is a constant, without any it is 0.
struct Curve {
  std::vector<CurvePoint> points;

  [[nodiscard]] double at(double time) const;

  friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace facies::scenario
