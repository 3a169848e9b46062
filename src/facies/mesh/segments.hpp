// SPDX-License-Identifier: Apache-2.0
// Distance from a point to a segment and to a polyline.
#pragma once

#include <span>

#include "facies/math/tensor.hpp"

namespace facies::mesh {

struct ClosestPoint {
  double distance = 0.0;      ///< [mm]
  double parameter = 0.0;     ///< along the segment: 0 at its first end, 1 at its second
  Vec3 point = Vec3::Zero();  ///< [mm]
  std::size_t segment = 0;    ///< of a polyline: joins points[segment] with the next one
};

/// The point of segment a-b nearest to p. A segment without length is a point.
[[nodiscard]] ClosestPoint closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// The point of the polyline nearest to p; of several, the one on the first segment. `closed` joins the last point with
/// the first. Throws BugError where there is no point.
[[nodiscard]] ClosestPoint closest_on_polyline(const Vec3& p, std::span<const Vec3> points,
                                               bool closed = false);

}  // namespace facies::mesh
