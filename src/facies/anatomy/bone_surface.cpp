// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/bone_surface.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace facies::anatomy {

namespace {

/// Diagonals of the bounding box that the bones of a face have [mm].
constexpr double smallest_bone = 10.0;
constexpr double largest_bone = 500.0;

/// Pairs of triangles through each other, by triangle, that scanned bones may have.
constexpr double most_intersections = 0.002;

/// Pairs of triangles that a message names.
constexpr std::size_t pairs_named = 3;

std::string describe_place(const Vec3& x) {
  return fmt::format("near ({:.1f}, {:.1f}, {:.1f}) mm", x.x(), x.y(), x.z());
}

void check_size(const BoneSurface& bone, const mesh::SurfaceReport& report, Problems& problems) {
  const double size = (report.upper - report.lower).norm();
  if (size >= smallest_bone && size <= largest_bone) return;
  problems.add(
      {bone.file.string(),
       fmt::format("a bone of {:.4g} mm, {:.4g} in the file's unit", size, size / bone.scale),
       fmt::format("{:g} to {:g} mm", smallest_bone, largest_bone),
       fmt::format("the column 'scale' of jaw-surfaces.csv, now {:g}, takes the file's "
                   "unit to mm: 1000 for metres, 10 for centimetres, 1 for millimetres",
                   bone.scale)});
}

void check_sides(const std::string& where, const mesh::TriangleSurface& surface,
                 const mesh::SurfaceReport& report, bool closed, Problems& problems) {
  const auto place = [&](const mesh::VertexPair& edge) {
    return describe_place(surface.X[at(edge[0])]);
  };
  if (!report.crowded_edges.empty()) {
    problems.add({where,
                  fmt::format("{} edges with more than two triangles, the first {}",
                              report.crowded_edges.size(), place(report.crowded_edges[0])),
                  "at most two", "make the surface a manifold"});
  }
  if (!report.inconsistent_edges.empty()) {
    problems.add(
        {where,
         fmt::format("{} edges whose two triangles disagree about the outside, the first {}",
                     report.inconsistent_edges.size(), place(report.inconsistent_edges[0])),
         "triangles counter-clockwise seen from outside", "orient the surface"});
  }
  if (closed && !report.border_edges.empty()) {
    problems.add({where,
                  fmt::format("a border of {} edges, the first {}", report.border_edges.size(),
                              place(report.border_edges[0])),
                  "a closed surface", "close it, or say 0 under 'closed' in jaw-surfaces.csv"});
  }
  if (report.is_closed() && report.volume < 0.0) {
    problems.add({where, "a surface that is inside out", "triangles counter-clockwise from outside",
                  "turn every triangle"});
  }
}

void check_intersections(const std::string& where, const mesh::TriangleSurface& surface,
                         const mesh::SurfaceReport& report, Problems& problems) {
  const double share = static_cast<double>(report.intersections.size()) /
                       static_cast<double>(surface.triangles.size());
  if (share <= most_intersections) return;
  std::string pairs;
  for (std::size_t i = 0; i < std::min(pairs_named, report.intersections.size()); ++i) {
    const auto& [one, other] = report.intersections[i];
    pairs += fmt::format("{}{} and {} {}", pairs.empty() ? "" : ", ", one + 1, other + 1,
                         describe_place(surface.X[at(surface.triangles[at(one)][0])]));
  }
  problems.add(
      {where,
       fmt::format("{} pair{} of triangles through each other, counted from 1: {}{}",
                   report.intersections.size(), report.intersections.size() == 1 ? "" : "s", pairs,
                   report.intersections.size() > pairs_named ? ", ..." : ""),
       "a surface that does not run through itself", "mend it, or leave out the part"});
}

}  // namespace

mesh::TriangleSurface read_bone_surface(const BoneSurface& bone, Problems& problems) {
  mesh::TriangleSurface read = mesh::read_obj(bone.file, bone.scale, problems);
  if (read.triangles.empty()) return read;  // said by the reader
  mesh::TriangleSurface surface = mesh::merge_coincident_vertices(read);
  const mesh::SurfaceReport report = mesh::check_surface(surface);
  const std::string where = bone.file.string();
  check_size(bone, report, problems);
  check_sides(where, surface, report, bone.closed, problems);
  check_intersections(where, surface, report, problems);
  return surface;
}

}  // namespace facies::anatomy
