// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_jaw.hpp"

#include <cmath>

#include "facies/anatomy/cage.hpp"
#include "facies/anatomy/jaw_tables.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

std::vector<Vec3> moved(const std::vector<Vec3>& points, const PointMap& move) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& x : points)
    result.push_back(move(x));
  return result;
}

/// How many times as large the bone has become, by its closed surfaces.
double growth_of(const Jaw& jaw, const std::vector<double>& drawn_volumes) {
  double before = 0.0;
  double after = 0.0;
  for (std::size_t s = 0; s < jaw.surfaces.size(); ++s) {
    if (jaw.surfaces[s].bone != jaw.mandible || !jaw.surfaces[s].closed) continue;
    before += drawn_volumes[s];
    after += mesh::check_surface(jaw.surfaces[s].surface).volume;
  }
  return before > 0.0 ? after / before : 1.0;
}

/// Surfaces of the drawings, moved. Answers their volumes before.
std::vector<double> read_surfaces(Jaw& jaw, const fs::path& folder, const PointMap& move,
                                  std::vector<fs::path>& files, Problems& problems) {
  std::vector<double> volumes;
  for (BoneSurface& surface : jaw.surfaces) {
    surface.file = folder / surface.file;
    files.push_back(surface.file);
    const Cage cage = read_cage(surface.file, problems);
    if (cage.points.empty()) return {};
    volumes.push_back(mesh::check_surface(smooth_surface(cage, cage.points)).volume);
    surface.surface = smooth_surface(cage, moved(cage.points, move));
  }
  return volumes;
}

/// Everything but the surfaces.
void move_mechanism(Jaw& jaw, const PointMap& move, double growth) {
  const Jaw drawn = jaw;
  Bone& mandible = jaw.bones[at(jaw.mandible)];
  mandible.mass *= growth;
  mandible.inertia *= std::pow(growth, 5.0 / 3.0);
  mandible.centre = move(mandible.centre);
  const Vec3& centre = drawn.bones[at(jaw.mandible)].centre;
  for (JawPose* pose : {&jaw.start, &jaw.intercuspal})
    pose->u = move(centre + pose->u) - mandible.centre;
  for (JawPoint& point : jaw.points)
    point.at.X = move(point.at.X);
  const auto led = [](const Jaw& of, Index point) {
    return place_of(of, of.intercuspal, of.points[at(point)].at);
  };
  for (JawGuide& guide : jaw.guides) {
    const Vec3 way = led(jaw, guide.point) - led(drawn, guide.point);
    guide.curve.x0 += way.x();
    guide.curve.z0 += way.z();
  }
  for (JawStop& stop : jaw.stops)
    stop.plane += led(jaw, stop.point) - led(drawn, stop.point);
  for (JawMuscle& muscle : jaw.muscles) {
    const double before = (muscle.origin.X - muscle.insertion.X).norm();
    muscle.origin.X = move(muscle.origin.X);
    muscle.insertion.X = move(muscle.insertion.X);
    const double longer = (muscle.origin.X - muscle.insertion.X).norm() / before;
    muscle.optimal_length *= longer;
    muscle.max_length *= longer;
  }
}

}  // namespace

Jaw make_builtin_jaw(const fs::path& folder, const PointMap& move, std::vector<fs::path>& files,
                     Problems& problems) {
  Jaw jaw = read_jaw_tables(folder, problems);
  for (const fs::path& table : jaw_table_files(folder))
    files.push_back(table);
  const std::vector<double> volumes = read_surfaces(jaw, folder, move, files, problems);
  if (!problems.empty()) return jaw;
  move_mechanism(jaw, move, growth_of(jaw, volumes));
  return jaw;
}

}  // namespace facies::anatomy
