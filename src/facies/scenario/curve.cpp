// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/curve.hpp"

#include <algorithm>

namespace facies::scenario {

double Curve::at(double time) const {
  if (points.empty()) return 0.0;
  const auto after =
      std::upper_bound(points.begin(), points.end(), time,
                       [](double t, const CurvePoint& point) { return t < point.time; });
  if (after == points.begin()) return points.front().value;
  if (after == points.end()) return points.back().value;
  const CurvePoint& a = *(after - 1);
  const double s = (time - a.time) / (after->time - a.time);
  return (1.0 - s) * a.value + s * after->value;
}

}  // namespace facies::scenario
