// SPDX-License-Identifier: Apache-2.0
#include "facies/math/segment_triangle.hpp"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace facies {

std::optional<double> segment_through_triangle(const Vec3& p, const Vec3& q, const Vec3& a,
                                               const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double side_p = normal.dot(p - a);
  const double side_q = normal.dot(q - a);
  if (!((side_p > 0.0 && side_q < 0.0) || (side_p < 0.0 && side_q > 0.0))) return std::nullopt;
  // On which side of the segment the triangle's edges pass: all on the same where it goes through.
  const Vec3 way = q - p;
  const std::array<double, 3> turn{way.dot((a - p).cross(b - p)), way.dot((b - p).cross(c - p)),
                                   way.dot((c - p).cross(a - p))};
  const bool through = std::ranges::all_of(turn, [](double t) { return t >= 0.0; }) ||
                       std::ranges::all_of(turn, [](double t) { return t <= 0.0; });
  if (!through) return std::nullopt;
  return side_p / (side_p - side_q);
}

}  // namespace facies
