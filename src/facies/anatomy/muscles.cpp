// SPDX-License-Identifier: Apache-2.0
// Which elements belong to a muscle, and which way its fibres run there (docs/theory/anatomy.md).
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/anatomy/muscle_band.hpp"
#include "facies/mesh/segments.hpp"

namespace facies::anatomy {
namespace {

/// The piece of a path between two different points that follow each other.
struct Segment {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  Side side = Side::middle;
  BandSegment band;  ///< of a muscle that is one
};

BandSegment band_segment(const FibrePath& path, std::size_t i, std::size_t next) {
  require(path.normals.size() == path.points.size(), "a band needs a normal at every point");
  return {path.points[i],         path.points[next],
          path.normals[i],        path.normals[next],
          !path.closed && i == 0, !path.closed && next + 1 == path.points.size()};
}

std::vector<Segment> segments_of(const MusclePaths& muscle) {
  std::vector<Segment> segments;
  for (const FibrePath& path : muscle.paths) {
    const std::size_t n = path.points.size();
    const std::size_t n_segments = path.closed ? n : std::max<std::size_t>(n, 1) - 1;
    for (std::size_t i = 0; i < n_segments; ++i) {
      const std::size_t next = (i + 1) % n;
      Segment segment{path.points[i], path.points[next], path.side, {}};
      if (muscle.is_band()) segment.band = band_segment(path, i, next);
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
      muscles.push_back({name_on(paths.name, side), paths.name, side, {}, {}, {}});
      break;
    }
  }
  return muscles;
}

void add(Muscle& muscle, Index e, const Vec3& direction, double share) {
  muscle.elements.push_back(e);
  muscle.directions.push_back(direction);
  muscle.shares.push_back(share);
}

/// Elements whose centroid lies closer than `reach` to a path [mm], in the reference configuration.
std::vector<Muscle> select_near(const mesh::Mesh& mesh, const MusclePaths& paths, double reach) {
  std::vector<Muscle> muscles = sides_of(paths);
  const std::vector<Segment> segments = segments_of(paths);
  if (segments.empty()) return muscles;
  for (Index e = 0; at(e) < mesh.n_elements(); ++e) {
    const std::vector<double> distance = distances(mesh.centroid(e), segments);
    const auto nearest =
        static_cast<std::size_t>(std::ranges::min_element(distance) - distance.begin());
    if (!(distance[nearest] < reach)) continue;
    for (Muscle& muscle : muscles) {
      if (muscle.side == segments[nearest].side)
        add(muscle, e, direction(segments, distance, nearest, 0.5 * reach), 1.0);
    }
  }
  return muscles;
}

/// The share of an element in the bands of each of the muscles' sides: a part that is in several bands belongs to the nearest fibre's.
std::vector<double> shares_of(const mesh::Mesh& mesh, Index e, const std::vector<Segment>& segments,
                              const BandSize& size, const std::vector<Muscle>& muscles) {
  std::vector<double> inside(muscles.size(), 0.0);
  double all = 0.0;
  for (const ElementPart& part : parts_of(mesh, e)) {
    all += part.volume;
    const Segment* nearest = nullptr;
    double distance = std::numeric_limits<double>::infinity();
    for (const Segment& segment : segments) {
      if (!is_in_band(part.middle, segment.band, size)) continue;
      const double d = mesh::closest_on_segment(part.middle, segment.a, segment.b).distance;
      if (d < distance) {
        distance = d;
        nearest = &segment;
      }
    }
    if (nearest == nullptr) continue;
    for (std::size_t m = 0; m < muscles.size(); ++m)
      inside[m] += muscles[m].side == nearest->side ? part.volume : 0.0;
  }
  for (double& volume : inside)
    volume /= all;
  return inside;
}

/// The segments whose band can meet the element.
std::vector<Segment> near(const mesh::Mesh& mesh, Index e, const std::vector<Segment>& segments,
                          const std::vector<double>& distance, const BandSize& size) {
  const Vec3 c = mesh.centroid(e);
  double reach = 0.0;
  for (const Index node : mesh.element(e).connectivity())
    reach = std::max(reach, (mesh.X()[at(node)] - c).norm());
  reach += 0.5 * std::hypot(size.width, size.thickness);
  std::vector<Segment> found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (distance[i] < reach) found.push_back(segments[i]);
  }
  return found;
}

/// The segment of a side that is nearest to an element.
std::size_t nearest_of(Side side, const std::vector<Segment>& segments,
                       const std::vector<double>& distance) {
  std::size_t nearest = segments.size();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].side == side && (nearest == segments.size() || distance[i] < distance[nearest]))
      nearest = i;
  }
  return nearest;
}

/// Leaves out elements that have no neighbour in the muscle.
Muscle in_company(const mesh::Mesh& mesh, const Muscle& muscle) {
  const std::vector<Index> kept = without_lone_elements(mesh, muscle.elements);
  Muscle result{muscle.name, muscle.group, muscle.side, {}, {}, {}};
  for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
    if (std::ranges::binary_search(kept, muscle.elements[i]))
      add(result, muscle.elements[i], muscle.directions[i], muscle.shares[i]);
  }
  return result;
}

/// Elements below the skin with a share in a band of `size`.
std::vector<Muscle> select_in_bands(const mesh::Mesh& mesh, const MusclePaths& paths,
                                    const BandSize& size) {
  constexpr double least_share = 0.05;
  std::vector<Muscle> muscles = sides_of(paths);
  const std::vector<Segment> segments = segments_of(paths);
  for (Index e = 0; at(e) < mesh.n_elements(); ++e) {
    if (std::ranges::binary_search(mesh.elements("skin"), e)) continue;
    const std::vector<double> distance = distances(mesh.centroid(e), segments);
    const std::vector<Segment> close = near(mesh, e, segments, distance, size);
    if (close.empty()) continue;
    const std::vector<double> shares = shares_of(mesh, e, close, size, muscles);
    for (std::size_t m = 0; m < muscles.size(); ++m) {
      if (shares[m] < least_share) continue;
      const std::size_t nearest = nearest_of(muscles[m].side, segments, distance);
      add(muscles[m], e, direction(segments, distance, nearest, size.width), shares[m]);
    }
  }
  for (Muscle& muscle : muscles)
    muscle = in_company(mesh, muscle);
  return muscles;
}

Problem no_element(const std::string& name, const MusclePaths& paths, double reach) {
  if (paths.is_band()) {
    return {"muscle " + name,
            fmt::format("no two neighbouring elements in its band of {:g} x {:g} mm", paths.width,
                        paths.thickness),
            "elements along its fibres", "draw its fibres in the tissue or refine the mesh"};
  }
  return {"muscle " + name, fmt::format("no element within {:.6g} mm of its fibres", reach),
          "at least one", "enlarge the radius or refine the mesh"};
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

std::vector<Muscle> select_muscles(const FaceAnatomy& face, const MuscleReach& reach,
                                   double scale) {
  require(reach.radius > 0.0 && reach.margin >= 0.0 && scale > 0.0,
          "muscles are selected by a positive radius, a margin and a positive scale");
  // Dividing mesh and paths by `scale` is measuring in units of `scale`.
  const double radius = reach.radius * scale;
  Problems problems;
  std::vector<Muscle> all;
  for (const MusclePaths& paths : face.muscle_paths) {
    if (paths.paths.empty()) problems.add({"muscle " + paths.name, "no path", "at least one", ""});
    const BandSize size{paths.width + 2.0 * reach.margin, paths.thickness + 2.0 * reach.margin};
    for (Muscle& muscle : paths.is_band() ? select_in_bands(face.mesh, paths, size)
                                          : select_near(face.mesh, paths, radius)) {
      if (muscle.elements.empty()) problems.add(no_element(muscle.name, paths, radius));
      all.push_back(std::move(muscle));
    }
  }
  problems.throw_if_any<DataError>();
  return all;
}

}  // namespace facies::anatomy
