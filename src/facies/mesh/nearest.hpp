// SPDX-License-Identifier: Apache-2.0
// Which triangles are near a point, on which side of a closed surface it lies, and where a segment passes through.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mesh {

/// The point of a surface nearest to a point.
struct NearestPoint {
  Index triangle = -1;  ///< of several, the one with the smallest number
  Vec3 point = Vec3::Zero();
  double distance = 0.0;  ///< [mm], never negative
  /// The point lies behind the surface. Means something for a closed surface whose normals point outwards, free of
  /// intersections and coincident vertices.
  bool is_inside = false;

  /// Negative inside [mm].
  [[nodiscard]] double signed_distance() const { return is_inside ? -distance : distance; }
};

/// A search tree over triangles in one configuration. Answers do not depend on how the tree came out: they are decided by
/// closest_on_triangle, in double precision. Queries may run on several threads at once.
class NearestTriangles {
 public:
  /// Vertex positions X [mm] and triangles on them, of any quality; copied. Throws BugError where a triangle names a
  /// vertex that does not exist or a coordinate is not below 1e15 mm.
  NearestTriangles(std::span<const Vec3> X, std::span<const std::array<Index, 3>> triangles);
  NearestTriangles(NearestTriangles&&) noexcept;
  NearestTriangles& operator=(NearestTriangles&&) noexcept;
  NearestTriangles(const NearestTriangles&) = delete;
  NearestTriangles& operator=(const NearestTriangles&) = delete;
  ~NearestTriangles();

  /// All triangles at most `radius` [mm] away from the point, ascending. Replaces what `triangles` held.
  void within(const Vec3& point, double radius, std::vector<Index>& triangles) const;

  /// The nearest point. The side is that of the angle-weighted pseudonormal of the nearest feature (baerentzen2005).
  /// Throws BugError where there is no triangle or the point is not finite.
  [[nodiscard]] NearestPoint nearest(const Vec3& point) const;

  /// Where the segment from p to q passes through triangles: 0 at p, 1 at q, ascending; the same place several times where
  /// it goes through a common edge (segment_through_triangle).
  [[nodiscard]] std::vector<double> passes(const Vec3& p, const Vec3& q) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace facies::mesh
