// SPDX-License-Identifier: Apache-2.0
// Muscles of a face as what one can look at: their elements, each muscle in its colour.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "facies/results/callouts.hpp"
#include "facies/results/render.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// Muscles of one name: "ZYG" is ZYG_L and ZYG_R.
struct MuscleGroup {
  std::string name, meaning;
  Colour colour;
  std::vector<const NamedMuscle*> parts;
};

/// The muscles of a subject, which must outlive them, in their order.
[[nodiscard]] std::vector<MuscleGroup> muscle_groups(const Subject& subject);

/// Whether a camera sees a point [mm].
using SightTest = std::function<bool(const Vec3& point)>;

/// The elements of a muscle group, as their faces in the configuration of the mesh.
class MuscleShape {
 public:
  /// What a camera sees of a part: how many faces, and of their middles the one that is nearest to all others.
  struct Seen {
    std::size_t n_faces = 0;
    Dot place;
  };

  /// `elements` are those of each of the group's parts that are to be shown.
  MuscleShape(const MuscleGroup& group, const mesh::Mesh& mesh,
              const std::vector<std::vector<Index>>& elements);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// Of each part that more is seen of than a corner.
  [[nodiscard]] std::vector<Seen> seen_in(const Camera& camera, const SightTest& sees) const;

 private:
  std::string name_;
  Surface surface_;
  std::vector<std::vector<Vec3>> middles_;  ///< of the faces, by part
};

/// The groups one by one with all their elements (`each_alone`), or as they are beside each other, where each element belongs to the
/// smallest of its groups.
[[nodiscard]] std::vector<MuscleShape> muscle_shapes(const std::vector<MuscleGroup>& groups,
                                                     const mesh::Mesh& mesh, bool each_alone);

/// Names of muscles for a picture that shows all shapes. Of a muscle with two sides the one is named that more is seen of; where both are
/// seen alike, in turn the one on the left and the one on the right of the picture.
[[nodiscard]] std::vector<Dot> muscle_names(const std::vector<MuscleShape>& shapes,
                                            const Camera& camera, const SightTest& sees);

}  // namespace facies::results
