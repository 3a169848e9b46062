// SPDX-License-Identifier: Apache-2.0
// The distance of a point to a triangle, and how it changes when any of the four points moves.
#pragma once

#include <cstdint>

#include "facies/math/tensor.hpp"

namespace facies {

/// The part of a triangle a, b, c that is nearest to a point: its inside, an edge (0: ab, 1: bc, 2: ca) or a vertex
/// (0: a, 1: b, 2: c).
enum class TriangleFeature : std::uint8_t { face, edge0, edge1, edge2, vertex0, vertex1, vertex2 };

struct ClosestOnTriangle {
  double distance_squared = 0.0;  ///< [mm^2]
  TriangleFeature feature = TriangleFeature::face;
  Vec3 barycentric =
      Vec3::Zero();  ///< weights of a, b, c at the closest point; 0..1, their sum is 1
  Vec3 offset =
      Vec3::Zero();  ///< from the closest point to p [mm]; of a face exactly along its normal
};

/// True where the height of the triangle over its longest edge is below 1e-8 of that edge: no normal can be told.
[[nodiscard]] bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c);

/// The point of the triangle nearest to p. A flat triangle is its three edges, an edge without length a point.
/// Distances are right to 1e-8 of the longest edge for needles, to rounding for everything else.
[[nodiscard]] ClosestOnTriangle closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                                    const Vec3& c);

/// The distance d [mm] with its first [-] and second [1/mm] derivatives by the coordinates of p, a, b, c in this order.
struct DistanceResponse {
  double d = 0.0;
  Eigen::Matrix<double, 12, 1> gradient;
  Eigen::Matrix<double, 12, 12> hessian;
};

/// The distance of p to the triangle for d > 0 (else BugError). d and the gradient are continuous; the Hessian is that
/// of the nearest feature and jumps where another one becomes the nearest.
[[nodiscard]] DistanceResponse distance_response(const Vec3& p, const Vec3& a, const Vec3& b,
                                                 const Vec3& c);

}  // namespace facies
