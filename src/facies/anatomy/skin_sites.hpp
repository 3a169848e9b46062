// SPDX-License-Identifier: Apache-2.0
// Places on a face, told by where they are in the frontal view of its drawing: they go along when the face changes.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "facies/anatomy/cage.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::anatomy {

/// A place in a triangle of the net that SkinSites refines the drawing to.
struct SkinSite {
  std::array<Index, 3> vertices{-1, -1, -1};
  Vec3 parts = Vec3::Zero();  ///< of the vertices; their sum is 1

  /// The place on a surface given at the vertices of the net [mm].
  [[nodiscard]] Vec3 on(std::span<const Vec3> surface) const {
    return parts.x() * surface[at(vertices[0])] + parts.y() * surface[at(vertices[1])] +
           parts.z() * surface[at(vertices[2])];
  }
};

class SkinSites {
 public:
  /// Throws BugError where no smooth surface passes through the points of the drawing.
  explicit SkinSites(const Cage& skin);

  /// The foremost place of the drawn skin that the view from the front shows at (lateral, up) [mm]; nothing beside the face, in an eye, a
  /// nostril or between the lips.
  [[nodiscard]] std::optional<SkinSite> find(double lateral, double up) const;

  /// The net that places refer to, and its smooth surface from control points of the drawing's net.
  [[nodiscard]] const mesh::LimitMesh& refined() const { return refined_; }

 private:
  mesh::LimitMesh refined_;
  std::vector<Vec3> X_;
  double front_ = 0.0, back_ = 0.0;  ///< where the face begins and ends, along x [mm]
  std::vector<std::array<Index, 3>> triangles_;
  std::unique_ptr<mesh::NearestTriangles> tree_;
};

}  // namespace facies::anatomy
