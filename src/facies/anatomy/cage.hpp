// SPDX-License-Identifier: Apache-2.0
// Smooth surfaces as people draw them: named points in rows, and how rows hang together (docs/theory/builtin-face.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facies/base/error.hpp"
#include "facies/mesh/catmull_clark.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::anatomy {

/// A net of quadrilaterals with names. The smooth surface over it passes through the points.
struct Cage {
  std::vector<std::string> names;      ///< "lip0.6"; of the left half "lip0.6-left"
  std::map<std::string, Index> index;  ///< of a name
  std::vector<Vec3> points;            ///< [mm] in the axes of a face
  std::vector<Index> mirrored;         ///< the same point of the other half; itself in the midline
  mesh::QuadNet net;                   ///< counter-clockwise seen from outside
};

/// Reads a drawing: JSON with these keys and no others
///   "about": "..."                       for people
///   "unit": "mm"
///   "rows": {"lip0": [[lateral, up, forward], ...], ...}   points lip0.0, lip0.1, ...; null where a row has none
///   "sheets": [["f0", "f1"], ...]        quadrilaterals between rows that follow each other, where all four points are
///   "without": ["k3.1"]                  but these, told by their first corner
///   "rings", "strips": [[list, list, ...], ...]   between lists of as many points, closed and open; a list is "lip0.0:6"
///                                        (":" for a range, also backwards) or several of these
///   "quads": [["a.0", "a.1", "b.1", "b.0"]]
///   "mirrored": true                     points with lateral 0 are in the midline, everything else gets a twin on the left
/// Points are in the axes of a drawing: lateral (the subject's right), up, forward. The outer side is the one that looks away
/// from the mean of all points, taken over the whole surface.
/// Every point belongs to a quadrilateral, and all together are a surface (mesh::find_fault).
/// Adds everything that is wrong to `problems` and then answers an empty cage.
[[nodiscard]] Cage read_cage(const std::filesystem::path& path, Problems& problems);

/// The smooth surface through `points` at the vertices of the cage's net, each quadrilateral refined twice and cut into triangles. Its
/// first vertices are the points, in their order.
[[nodiscard]] mesh::TriangleSurface smooth_surface(const Cage& cage,
                                                   const std::vector<Vec3>& points);

/// The points that "lip0.0:6" or "lip0.6" names. Adds a problem at `where` for a text that is no range and for each point that the cage does
/// not have.
[[nodiscard]] std::vector<Index> points_of_range(const Cage& cage, const std::string& range,
                                                 const std::string& where, Problems& problems);

}  // namespace facies::anatomy
