// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_depths.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"
#include "facies/math/radial_warp.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

/// No soft tissue of a face is thicker [mm].
constexpr double thickest = 60.0;

const std::array<std::pair<const char*, DepthDirection>, 3> directions{
    {{"normal", DepthDirection::normal},
     {"forward", DepthDirection::forward},
     {"down", DepthDirection::down}}};

std::optional<double> length_or_none(const Table& table, std::size_t row, const char* column,
                                     Problems& problems) {
  if (table.text(row, column).empty()) return std::nullopt;
  return table.number(row, column, problems);
}

/// The drawings that the table names, by name.
const Cage& drawing_of(const fs::path& path, std::map<std::string, Cage>& read,
                       Problems& problems) {
  const auto [entry, is_new] = read.try_emplace(path.string());
  if (is_new) entry->second = read_cage(path, problems);
  return entry->second;
}

DepthSite read_site(const Table& table, std::size_t row, const fs::path& folder,
                    std::vector<std::string>& names, std::map<std::string, Cage>& drawings,
                    Problems& problems) {
  DepthSite site;
  site.key = "depth_" + table.new_name(row, "site", names, problems);
  site.meaning = table.text(row, "meaning");
  site.drawing = table.text(row, "drawing");
  const Cage& cage = drawing_of(folder / site.drawing, drawings, problems);
  for (const std::string_view range : split_blanks(table.text(row, "points"))) {
    for (const Index point :
         points_of_range(cage, std::string(range), table.where(row, "points"), problems))
      site.points.push_back(point);
  }
  if (site.points.empty())
    problems.add({table.where(row, "points"), "no point", "points of " + site.drawing, ""});
  const std::string_view word = table.text(row, "direction");
  const auto direction =
      std::ranges::find_if(directions, [&](const auto& d) { return d.first == word; });
  if (direction == directions.end()) {
    problems.add({table.where(row, "direction"), excerpt(word), "normal, forward or down", ""});
  } else {
    site.direction = direction->second;
  }
  site.mean = table.number(row, "mean_mm", problems).value_or(0.0);
  site.men = length_or_none(table, row, "men_mm", problems);
  site.women = length_or_none(table, row, "women_mm", problems);
  site.smallest = table.number(row, "smallest_mm", problems).value_or(0.0);
  site.largest = table.number(row, "largest_mm", problems).value_or(0.0);
  if (site.mean < site.smallest || site.mean > site.largest)
    problems.add({table.where(row, "mean_mm"), fmt::format("{} is not in the range", site.mean),
                  "a mean from smallest_mm to largest_mm", ""});
  return site;
}

/// The outward normal of a surface at a point of one of its triangles: those of the corners, weighted as the point lies between them.
Vec3 normal_at(const mesh::TriangleSurface& surface, const mesh::NearestPoint& place) {
  const std::array<Index, 3>& corners = surface.triangles[at(place.triangle)];
  std::array<Vec3, 3> normals{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (const auto& [a, b, c] : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a != corners[k] && b != corners[k] && c != corners[k]) continue;
      normals[k] +=
          (surface.X[at(b)] - surface.X[at(a)]).cross(surface.X[at(c)] - surface.X[at(a)]);
    }
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& b = surface.X[at(corners[(k + 1) % 3])];
    const Vec3& c = surface.X[at(corners[(k + 2) % 3])];
    sum += (b - place.point).cross(c - place.point).norm() * normals[k].normalized();
  }
  return sum.normalized();
}

Vec3 mirror_image(const Vec3& x) {
  return {x.x(), -x.y(), x.z()};
}

}  // namespace

std::vector<DepthSite> read_depth_sites(const fs::path& folder, Problems& problems) {
  const Table table(folder / "depths.csv",
                    {"site", "drawing", "points", "direction", "mean_mm", "men_mm", "women_mm",
                     "smallest_mm", "largest_mm", "meaning", "source"},
                    problems);
  std::vector<DepthSite> sites;
  std::vector<std::string> names;
  std::map<std::string, Cage> drawings;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    sites.push_back(read_site(table, row, folder, names, drawings, problems));
  return sites;
}

std::vector<MeasuredDepth> measure_depths(const std::vector<DepthSite>& sites, const Jaw& jaw,
                                          const mesh::TriangleSurface& skin) {
  const mesh::NearestTriangles above(skin.X, skin.triangles);
  std::vector<MeasuredDepth> measured;
  for (const BoneSurface& bone : jaw.surfaces) {
    const mesh::NearestTriangles tree(bone.surface.X, bone.surface.triangles);
    for (const DepthSite& site : sites) {
      if (bone.file.filename() != site.drawing) continue;
      // the first vertices of a refined surface are the points of its drawing
      Vec3 mean = Vec3::Zero();
      for (const Index point : site.points)
        mean += bone.surface.X[at(point)] / static_cast<double>(site.points.size());
      const mesh::NearestPoint place = tree.nearest(mean);
      Vec3 way = normal_at(bone.surface, place);
      if (site.direction == DepthDirection::forward) way = -Vec3::UnitX();
      if (site.direction == DepthDirection::down) way = -Vec3::UnitZ();
      const std::vector<double> passes = above.passes(place.point, place.point + thickest * way);
      if (!passes.empty())
        measured.push_back({site.key, place.point, way, thickest * passes.front()});
    }
  }
  return measured;
}

PointMap depth_warp(const std::vector<MeasuredDepth>& measured, const MeasureValues& wanted,
                    const Jaw& jaw) {
  constexpr double in_midline = 0.1;  // [mm]
  std::vector<Vec3> from;
  std::vector<Vec3> to;
  std::size_t found = 0;
  for (const MeasuredDepth& site : measured) {
    const auto value = wanted.find(site.key);
    found += value != wanted.end() ? 1 : 0;
    const double deeper = value == wanted.end() ? 0.0 : value->second - site.depth;
    Vec3 bone = site.bone;
    Vec3 way = site.way;
    if (std::abs(bone.y()) < in_midline) {
      bone.y() = 0.0;
      way = Vec3(way.x(), 0.0, way.z()).normalized();
    } else {
      from.push_back(mirror_image(bone));
      to.push_back(mirror_image(bone - deeper * way));
    }
    from.push_back(bone);
    to.push_back(bone - deeper * way);
  }
  require(found == wanted.size(), "depth_warp: a depth that was not measured");
  for (const JawPoint& point : jaw.points) {
    from.push_back(point.at.X);
    to.push_back(point.at.X);
  }
  return [warp = RadialWarp(from, to)](const Vec3& x) { return warp(x); };
}

}  // namespace facies::anatomy
