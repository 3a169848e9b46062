// SPDX-License-Identifier: Apache-2.0
// Faces as surfaces: which faces bound a mesh, their areas and normals for any node positions, their triangles.
//
// `x` is a position for every node of the mesh [n_nodes] [mm]: mesh.X() or the deformed positions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// The node numbers of a face in ascending order, -1 in front for a triangle: equal for the same face seen from both
/// of its elements.
using FaceKey = std::array<Index, 4>;
[[nodiscard]] FaceKey face_key(const Mesh& mesh, Face face);

/// Faces that belong to exactly one element, by element, then by local number.
[[nodiscard]] std::vector<Face> boundary_faces(const Mesh& mesh);

/// The same for the part of the mesh made of these elements only.
[[nodiscard]] std::vector<Face> boundary_faces(const Mesh& mesh, std::span<const Index> elements);

/// The nodes of the faces, ascending, without repetitions.
[[nodiscard]] std::vector<Index> face_set_nodes(const Mesh& mesh, std::span<const Face> faces);

/// Triangles on the mesh's node numbers, counter-clockwise seen from outside.
struct FaceTriangles {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> face;  ///< of each triangle: position in the list of faces it was made from
};

/// Cuts each quadrilateral along the diagonal that starts at its smallest node number, so that both sides of a face
/// get the same triangles.
[[nodiscard]] FaceTriangles triangulate(const Mesh& mesh, std::span<const Face> faces);

/// The same triangles on positions in a list of the nodes that they have.
struct NumberedTriangles {
  std::vector<Index> nodes;  ///< ascending
  std::vector<std::array<Index, 3>> triangles;
};
[[nodiscard]] NumberedTriangles triangulate_alone(const Mesh& mesh, std::span<const Face> faces);

/// The integral of the outward unit normal over the face [mm^2]; half the cross product of a quadrilateral's diagonals,
/// exact for the bilinear face.
[[nodiscard]] Vec3 area_vector(const Mesh& mesh, Face face, std::span<const Vec3> x);

/// The face's area [mm^2]; of a warped quadrilateral that of its bilinear surface, by 2x2 Gauss points.
[[nodiscard]] double face_area(const Mesh& mesh, Face face, std::span<const Vec3> x);

/// The sum of the faces' areas [mm^2].
[[nodiscard]] double surface_area(const Mesh& mesh, std::span<const Face> faces,
                                  std::span<const Vec3> x);

/// What each node has of the faces around it: every face goes in equal parts to its nodes [n_nodes] [mm^2].
[[nodiscard]] std::vector<double> node_areas(const Mesh& mesh, std::span<const Face> faces,
                                             std::span<const Vec3> x);

/// Outward unit normals, one per face; zero for a face without area.
[[nodiscard]] std::vector<Vec3> face_normals(const Mesh& mesh, std::span<const Face> faces,
                                             std::span<const Vec3> x);

/// Outward unit normals [n_nodes]: the area-weighted mean of the faces around each node; zero where there is none.
[[nodiscard]] std::vector<Vec3> vertex_normals(const Mesh& mesh, std::span<const Face> faces,
                                               std::span<const Vec3> x);

}  // namespace facies::mesh
