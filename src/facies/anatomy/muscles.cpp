// SPDX-License-Identifier: Apache-2.0
// Which elements belong to a muscle, and which way its fibres run there (docs/theory/anatomy.md).
#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/segments.hpp"

namespace facies::anatomy {
namespace {

/// The piece of a path between two different points that follow each other.
struct Segment {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  Side side = Side::middle;
};

std::vector<Segment> segments_of(const MusclePaths& muscle) {
  std::vector<Segment> segments;
  for (const FibrePath& path : muscle.paths) {
    const std::size_t n = path.points.size();
    const std::size_t n_segments = path.closed ? n : std::max<std::size_t>(n, 1) - 1;
    for (std::size_t i = 0; i < n_segments; ++i) {
      const Segment segment{path.points[i], path.points[(i + 1) % n], path.side};
      if (segment.a != segment.b) segments.push_back(segment);
    }
  }
  return segments;
}

std::vector<double> distances(const Vec3& p, const std::vector<Segment>& segments) {
  std::vector<double> result;
  result.reserve(segments.size());
  for (const Segment& segment : segments)
    result.push_back(mesh::closest_on_segment(p, segment.a, segment.b).distance);
  return result;
}

/// The principal axis of sum w t t^T over the segments with tangent t and w = length exp(-(d / width)^2): the smooth
/// field of axes nearest to the fibres around. Points the way of the nearest segment.
Vec3 direction(const std::vector<Segment>& segments, const std::vector<double>& distance,
               std::size_t nearest, double width) {
  Mat3 M = Mat3::Zero();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec3 along = segments[i].b - segments[i].a;
    // Relative to the nearest, so that the weights far from all fibres do not vanish together.
    const double exponent =
        (distance[i] * distance[i] - distance[nearest] * distance[nearest]) / (width * width);
    M += std::exp(-exponent) / along.norm() * along * along.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(M);
  const Vec3 axis = solver.eigenvectors().col(2).normalized();
  return axis.dot(segments[nearest].b - segments[nearest].a) < 0.0 ? Vec3(-axis) : axis;
}

std::string name_on(const std::string& group, Side side) {
  if (side == Side::middle) return group;
  return group + (side == Side::left ? "_L" : "_R");
}

/// The muscle on the sides that it has paths on: left, right, middle.
std::vector<Muscle> sides_of(const MusclePaths& paths) {
  std::vector<Muscle> muscles;
  for (const Side side : {Side::left, Side::right, Side::middle}) {
    for (const FibrePath& path : paths.paths) {
      if (path.side != side) continue;
      muscles.push_back({name_on(paths.name, side), paths.name, side, {}, {}});
      break;
    }
  }
  return muscles;
}

/// `reach` and `width` in the reference configuration [mm].
std::vector<Muscle> select(const mesh::Mesh& mesh, const MusclePaths& paths, double reach,
                           double width) {
  std::vector<Muscle> muscles = sides_of(paths);
  const std::vector<Segment> segments = segments_of(paths);
  if (segments.empty()) return muscles;
  for (std::size_t i = 0; i < mesh.n_elements(); ++i) {
    const Index e = to_index(i);
    const std::vector<double> distance = distances(mesh.centroid(e), segments);
    const auto nearest =
        static_cast<std::size_t>(std::ranges::min_element(distance) - distance.begin());
    if (!(distance[nearest] < reach)) continue;
    for (Muscle& muscle : muscles) {
      if (muscle.side != segments[nearest].side) continue;
      muscle.elements.push_back(e);
      muscle.directions.push_back(direction(segments, distance, nearest, width));
    }
  }
  return muscles;
}

}  // namespace

std::vector<std::string> leave_out_fibres(FaceAnatomy& face,
                                          const std::vector<std::string>& fibres) {
  std::vector<std::string> known;
  for (MusclePaths& muscle : face.muscle_paths) {
    std::map<Side, int> count;
    std::erase_if(muscle.paths, [&](const FibrePath& path) {
      const std::string name = fmt::format("{}.{}", muscle.name, ++count[path.side]);
      if (std::ranges::find(known, name) == known.end()) known.push_back(name);
      return std::ranges::find(fibres, name) != fibres.end();
    });
  }
  return known;
}

std::vector<Muscle> select_muscles(const FaceAnatomy& face, double radius, double scale) {
  require(radius > 0.0 && scale > 0.0, "muscles are selected by a positive radius and scale");
  // Dividing mesh and paths by `scale` is measuring in units of `scale`.
  const double reach = radius * scale;
  Problems problems;
  std::vector<Muscle> all;
  for (const MusclePaths& paths : face.muscle_paths) {
    if (paths.paths.empty()) problems.add({"muscle " + paths.name, "no path", "at least one", ""});
    for (Muscle& muscle : select(face.mesh, paths, reach, 0.5 * reach)) {
      if (muscle.elements.empty()) {
        problems.add({"muscle " + muscle.name,
                      fmt::format("no element within {:.6g} mm of its fibres", reach),
                      "at least one", "enlarge the radius or refine the mesh"});
      }
      all.push_back(std::move(muscle));
    }
  }
  problems.throw_if_any<DataError>();
  return all;
}

}  // namespace facies::anatomy
