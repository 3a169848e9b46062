// SPDX-License-Identifier: Apache-2.0
// Columns of a layered mesh: from a face of the outer surface through the elements below it, one after the other.
#pragma once

#include <span>
#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// The face of `element` that shares no node with `face` and has as many; element -1 where there is none (the
/// quadrilaterals of a wedge).
[[nodiscard]] Face opposite_face(const Mesh& mesh, Face face);

/// For every element the face through which the column of `outer` faces enters it: its outward face. [n_elements];
/// element -1 where no column comes through.
[[nodiscard]] std::vector<Face> outward_faces(const Mesh& mesh, std::span<const Face> outer);

/// The nodes below each node of the `outer` faces, itself first, down to the last element of its columns. In the order
/// of face_set_nodes(mesh, outer).
[[nodiscard]] std::vector<std::vector<Index>> node_columns(const Mesh& mesh,
                                                           std::span<const Face> outer);

/// Thickness of elements [mm]: volume by the mean area of the outward face and its opposite, with `outward` from
/// outward_faces. NaN where an element has no outward face or that has no opposite.
[[nodiscard]] std::vector<double> element_thickness(const Mesh& mesh,
                                                    std::span<const Index> elements,
                                                    std::span<const Face> outward,
                                                    std::span<const Vec3> x);

}  // namespace facies::mesh
