// SPDX-License-Identifier: Apache-2.0
// Where rays hit a surface. The same surface gives the same answers every time.
#pragma once

#include <memory>
#include <optional>

#include "facies/results/render.hpp"

namespace facies::results {

struct Ray {
  Vec3f origin;
  Vec3f direction;                ///< unit
  float near = 0.0F, far = 0.0F;  ///< the part of it that counts [mm]
};

struct RayHit {
  std::uint32_t triangle = 0;  ///< of the surface
  Vec3f weights;               ///< of its vertices; sum 1
  float distance = 0.0F;       ///< from the ray's origin [mm]
  bool from_inside = false;    ///< the ray left what the triangle bounds
};

/// The triangles of a surface, round ones cut into smaller ones that follow the rounding, in a search tree.
class RayTree {
 public:
  /// Throws std::runtime_error where Embree fails.
  explicit RayTree(const Surface& surface);
  RayTree(const RayTree&) = delete;
  RayTree& operator=(const RayTree&) = delete;
  RayTree(RayTree&&) noexcept;
  RayTree& operator=(RayTree&&) noexcept;
  ~RayTree();

  [[nodiscard]] std::optional<RayHit> first_hit(const Ray& ray) const;
  [[nodiscard]] bool blocks(const Ray& ray) const;
  /// The corners of a box around everything [mm].
  [[nodiscard]] std::array<Vec3, 8> corners() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace facies::results
