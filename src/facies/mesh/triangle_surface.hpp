// SPDX-License-Identifier: Apache-2.0
// Surfaces of triangles on vertices of their own: bones. Read from OBJ files and looked over before use.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "facies/base/error.hpp"
#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mesh {

/// Triangles are counter-clockwise seen from outside.
struct TriangleSurface {
  std::vector<Vec3> X;  ///< [mm]
  std::vector<std::array<Index, 3>> triangles;
};

/// The surface in a Wavefront OBJ file, its coordinates times `scale` (> 0; 1000 for a file in metres). Lines `v` and
/// `f` are read, in any of the forms 1, 1/2, 1//3, 1/2/3 and with negative (relative) numbers; polygons are cut into a
/// fan around their first vertex; normals, textures, groups, materials, lines and points are passed over. Everything
/// wrong is added to `problems` with file, line and column, and then the surface is empty.
[[nodiscard]] TriangleSurface read_obj(const std::filesystem::path& path, double scale,
                                       Problems& problems);

/// The same surface with one vertex in the place of several at exactly the same position, in the order in which they
/// first come. Triangles stay, even those that now name a vertex twice. Throws BugError as check_surface does.
[[nodiscard]] TriangleSurface merge_coincident_vertices(const TriangleSurface& surface);

using VertexPair = std::array<Index, 2>;    ///< an edge, the smaller number first
using TrianglePair = std::array<Index, 2>;  ///< the smaller number first

/// What a surface is like. Lists are ascending. A triangle that names a vertex twice has no edges.
struct SurfaceReport {
  std::vector<VertexPair> border_edges;        ///< of one triangle: the surface is open
  std::vector<VertexPair> crowded_edges;       ///< of more than two triangles
  std::vector<VertexPair> inconsistent_edges;  ///< whose two triangles run along it the same way
  std::vector<Index> flat_triangles;           ///< without area (is_flat)
  /// Pairs in which an edge of one triangle goes from one side of the other to its other side, through its inside or its
  /// border. Flat triangles and pairs with a vertex at the same position do not count, nor does overlap within one plane.
  std::vector<TrianglePair> intersections;
  double volume = 0.0;  ///< enclosed [mm^3], negative inside out; means nothing for an open surface
  Vec3 lower = Vec3::Zero();  ///< of the bounding box of the vertices [mm]
  Vec3 upper = Vec3::Zero();

  /// Encloses a volume: every edge has two triangles that agree, and there is one at all.
  [[nodiscard]] bool is_closed() const {
    return volume != 0.0 && border_edges.empty() && crowded_edges.empty() &&
           inconsistent_edges.empty();
  }
};

/// Looks a surface over. Merge coincident vertices first: edges are told by vertex numbers. Throws BugError where a
/// triangle names a vertex that does not exist or a coordinate is not finite.
[[nodiscard]] SurfaceReport check_surface(const TriangleSurface& surface);

}  // namespace facies::mesh
