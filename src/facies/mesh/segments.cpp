// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/segments.hpp"

#include <algorithm>

#include "facies/base/error.hpp"

namespace facies::mesh {

ClosestPoint closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length_squared = along.squaredNorm();
  const double t =
      length_squared > 0.0 ? std::clamp((p - a).dot(along) / length_squared, 0.0, 1.0) : 0.0;
  ClosestPoint closest;
  closest.parameter = t;
  closest.point = t == 1.0 ? b : Vec3(a + t * along);
  closest.distance = (p - closest.point).norm();
  return closest;
}

ClosestPoint closest_on_polyline(const Vec3& p, std::span<const Vec3> points, bool closed) {
  require(!points.empty(), "a polyline without points has no closest point");
  ClosestPoint closest = closest_on_segment(p, points[0], points[0]);
  const std::size_t n_segments = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < n_segments; ++i) {
    ClosestPoint candidate = closest_on_segment(p, points[i], points[(i + 1) % points.size()]);
    candidate.segment = i;
    if (candidate.distance < closest.distance) closest = candidate;
  }
  return closest;
}

}  // namespace facies::mesh
