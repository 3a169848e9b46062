// SPDX-License-Identifier: Apache-2.0
// The whole boundary of a mesh as a surface to look at: skin, rim, and the inner side with the backs of the lips.
#pragma once

#include <span>

#include "facies/mesh/mesh.hpp"
#include "facies/results/render.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// Whether the holes of a face are closed: eyes, nostrils and mouth. Behind an open mouth hangs a dark curtain, far enough
/// back for teeth to stand before it.
enum class Lids : std::uint8_t { all, open_mouth, none };

/// Prepared once per mesh, posed for every state. The face set "outer" is drawn smooth all over, what else bounds the
/// mesh has an edge where faces meet at more than 50 degrees in the mesh configuration; skin and other sides differ in
/// colour. A face has holes for eyes, mouth and nostrils: every border of the face set "inner" but the longest (its outer
/// rim) is closed by a dark, hollow lid, so that one does not look through the face.
class Shell {
 public:
  /// Holes in front of `eyes` are left open.
  explicit Shell(const mesh::Mesh& mesh, std::span<const EyeShape> eyes = {});

  /// The boundary at X + u. `node_values` [n_nodes] are what a colour scale shows; empty: natural colours.
  [[nodiscard]] Surface pose(std::span<const Vec3> u, std::span<const double> node_values = {},
                             Lids lids = Lids::all) const;

 private:
  /// A node as seen by those of its faces that are smooth together.
  struct Vertex {
    Index node = -1;
    std::vector<std::size_t> faces;  ///< their mean normal is the vertex's
    Colour colour;
    bool round = false;
  };

  /// A dark fan around a middle `depth` behind that of the hole; its border is that of the hole, or, for a curtain, a
  /// wide circle as far behind.
  static void add_lid(std::span<const Index> hole, std::span<const Vec3> x, bool is_curtain,
                      Surface& surface);
  void add_face(std::size_t face, std::span<const std::vector<std::size_t>> faces_at_node,
                std::span<const Vec3> normals, std::span<const int> kinds,
                std::vector<std::vector<std::uint32_t>>& vertices_at_node);

  const mesh::Mesh* mesh_;
  std::vector<mesh::Face> faces_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::vector<Index>>
      holes_;              ///< nodes around each lid, in order, the first one again at the end
  std::size_t mouth_ = 0;  ///< of the holes; their number where none is the mouth
};

}  // namespace facies::results
