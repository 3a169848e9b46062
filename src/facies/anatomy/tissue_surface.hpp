// SPDX-License-Identifier: Apache-2.0
// The closed surface of the soft tissue as triangles: is a point inside, and where is the surface nearest to it?
#pragma once

#include <array>
#include <vector>

#include "facies/mesh/mesh.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::anatomy {

/// All boundary faces of a mesh. A quadrilateral is cut into two triangles along the diagonal that the reference program
/// uses (it depends on the face's place in the element), so that points land where they land there.
class TissueSurface {
 public:
  explicit TissueSurface(const mesh::Mesh& mesh);

  [[nodiscard]] std::size_t n_triangles() const { return surface_.triangles.size(); }

  /// By the winding number (mesh::winding_number).
  [[nodiscard]] bool contains(const Vec3& p) const;

  /// The nearest point of the surface; of several, the one on the first triangle.
  [[nodiscard]] Vec3 nearest(const Vec3& p) const;

  /// p itself where the tissue contains it, else the nearest point of its surface.
  [[nodiscard]] Vec3 into_tissue(const Vec3& p) const { return contains(p) ? p : nearest(p); }

 private:
  mesh::TriangleSurface surface_;
};

/// The point of the triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
[[nodiscard]] Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

}  // namespace facies::anatomy
