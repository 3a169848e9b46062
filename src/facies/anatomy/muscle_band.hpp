// SPDX-License-Identifier: Apache-2.0
// Muscles as flat bands along their fibres (docs/theory/anatomy.md).
#pragma once

#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::anatomy {

/// A piece of a fibre with the band's short axis at its ends.
struct BandSegment {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  ///< different [mm]
  Vec3 normal_a = Vec3::Zero(), normal_b = Vec3::Zero();
  bool begins = false, ends = false;  ///< the fibre ends at a, at b
};

/// Across a fibre, in the plane of the skin and along the normal [mm].
struct BandSize {
  double width = 0.0, thickness = 0.0;
};

/// Whether a point lies in the band along the segment, told by where it lies beside the segment's nearest point. Nothing beyond an
/// end of the fibre does.
[[nodiscard]] bool is_in_band(const Vec3& x, const BandSegment& segment, const BandSize& size);

/// A part of an element: its middle and its volume [mm^3].
struct ElementPart {
  Vec3 middle = Vec3::Zero();
  double volume = 0.0;
};

/// The 64 parts that an element falls into where each of its local coordinates is cut in four.
[[nodiscard]] std::vector<ElementPart> parts_of(const mesh::Mesh& mesh, Index e);

/// The elements that share a face with another one of them, in their order. `elements` is sorted.
[[nodiscard]] std::vector<Index> without_lone_elements(const mesh::Mesh& mesh,
                                                       const std::vector<Index>& elements);

}  // namespace facies::anatomy
