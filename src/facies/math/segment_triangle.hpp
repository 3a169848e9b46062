// SPDX-License-Identifier: Apache-2.0
// Where a segment passes through a triangle.
#pragma once

#include <optional>

#include "facies/math/tensor.hpp"

namespace facies {

/// Where the segment from p to q passes through the triangle a, b, c, its border included: 0 at p, 1 at q. Nothing where
/// both ends are on one side of the triangle's plane or an end lies in it, and for a triangle without area.
[[nodiscard]] std::optional<double> segment_through_triangle(const Vec3& p, const Vec3& q,
                                                             const Vec3& a, const Vec3& b,
                                                             const Vec3& c);

}  // namespace facies
