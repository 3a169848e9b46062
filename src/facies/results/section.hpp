// SPDX-License-Identifier: Apache-2.0
// Tissue and bones as surfaces to be cut: what a triangle separates is known, so that a cut shows layers, bone and teeth.
#pragma once

#include <span>

#include "facies/results/render.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// The colour of a layer in a cut; `layer` is its position in Subject::layers. Colours repeat after the fourth.
[[nodiscard]] Colour layer_colour(std::size_t layer);

/// The boundary of the tissue and the faces between its layers, drawn as flat as the elements are. Prepared once per
/// subject, posed for every state.
class LayeredTissue {
 public:
  explicit LayeredTissue(const Subject& subject);

  /// At X + u [n_nodes].
  [[nodiscard]] Surface pose(std::span<const Vec3> u) const;

 private:
  /// A node as a corner of faces of one kind: skin, inner side, rim, between layers.
  struct Vertex {
    Index node = -1;
    Colour colour;
  };

  const mesh::Mesh* mesh_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Sides> sides_;
  std::vector<Colour> fills_;
};

/// A bone where it is while its body has not moved.
[[nodiscard]] Surface surface_of(const BoneShape& bone);

/// A bone where it is in a state, to be looked at with other things; nothing of it is to be cut.
[[nodiscard]] Surface surface_of(const BoneShape& bone, const Subject& subject,
                                 const mechanics::State& state);

/// How a bone has moved in a state: x = R X + t.
[[nodiscard]] Actor carried(const Scene& scene, const BoneShape& bone, const Subject& subject,
                            const mechanics::State& state);

}  // namespace facies::results
