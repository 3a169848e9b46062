// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/columns.hpp"
#include "facies/mesh/nearest.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/winding_number.hpp"

namespace facies::scenario {

namespace {

/// Sweeps over all bones until no point is too near to any, or on the far side; a point between two bones may need several.
constexpr int most_sweeps = 20;

/// Points that are to say on which side of a bone the tissue is [mm].
constexpr double around_bone = 15.0;

/// Tissue that is farther from a bone has nothing to do with it [mm].
constexpr double far_from_bone = 50.0;

using Points = std::vector<mechanics::ContactPoint>;

/// A bone in the place where it begins.
struct PlacedBone {
  const BoneObstacle* obstacle;
  std::vector<Vec3> X;
  Eigen::AlignedBox3d box;
  mesh::NearestTriangles nearest;

  [[nodiscard]] const std::vector<std::array<Index, 3>>& triangles() const {
    return obstacle->surface.triangles;
  }
};

std::vector<PlacedBone> place_bones(const std::vector<BoneObstacle>& obstacles) {
  std::vector<PlacedBone> bones;
  for (const BoneObstacle& obstacle : obstacles) {
    if (!obstacle.pushes_out) continue;
    std::vector<Vec3> X;
    Eigen::AlignedBox3d box;
    for (const mechanics::Anchor& vertex : obstacle.surface.vertices) {
      X.push_back(vertex.X);
      box.extend(vertex.X);
    }
    mesh::NearestTriangles nearest(X, obstacle.surface.triangles);
    bones.push_back({&obstacle, std::move(X), box, std::move(nearest)});
  }
  return bones;
}

/// In a closed bone or behind an open one: resolve_overlaps.
bool is_inside(const PlacedBone& bone, const mesh::NearestPoint& near, const Vec3& x) {
  const bool may_be = bone.obstacle->closed ? bone.box.contains(x) : near.is_inside;
  if (!may_be) return false;
  const double winding = mesh::winding_number(bone.X, bone.triangles(), x);
  return bone.obstacle->closed ? std::abs(winding) > 0.5 : winding > 0.25;
}

/// Unit direction that leads a point away from the bone that it is near to or in; from a point on it, the normal.
Vec3 outwards(const PlacedBone& bone, const mesh::NearestPoint& near, bool inside, const Vec3& x) {
  constexpr double on_it = 1e-9;  // [mm]
  if (near.distance > on_it) return (inside ? near.point - x : x - near.point) / near.distance;
  const auto& [i, j, k] = bone.triangles()[at(near.triangle)];
  return (bone.X[at(j)] - bone.X[at(i)]).cross(bone.X[at(k)] - bone.X[at(i)]).normalized();
}

/// A bone is where the face is, and tissue around it on its outer side.
void check_place(const PlacedBone& bone, const Points& points, Problems& problems) {
  double nearest = std::numeric_limits<double>::infinity();
  int n_around = 0;
  int n_inside = 0;
  for (const mechanics::ContactPoint& point : points) {
    const mesh::NearestPoint near = bone.nearest.nearest(point.anchor.X);
    nearest = std::min(nearest, near.distance);
    if (near.distance > around_bone) continue;
    ++n_around;
    if (near.is_inside) ++n_inside;
  }
  const std::string& name = bone.obstacle->surface.name;
  const std::string where =
      bone.obstacle->where.empty() ? fmt::format("bone '{}'", name) : bone.obstacle->where;
  if (nearest > far_from_bone) {
    problems.add(
        {where, fmt::format("{} begins {:.0f} mm from the tissue nearest to it", name, nearest),
         "a bone of this face",
         "look at its unit ('scale' of jaw-surfaces.csv), its axes and the poses of the jaw"});
  }
  if (2 * n_inside > n_around) {
    problems.add(
        {where,
         fmt::format("{} of {} tissue nodes around it are on its inner side", n_inside, n_around),
         "tissue outside", "the surface may be inside out: turn every triangle"});
  }
}

/// Takes a point out of all bones in turn until none is too near. Answers the names of those that still are: none where
/// it found a place.
std::vector<std::string> push_out(const std::vector<PlacedBone>& bones, double distance, Vec3& x) {
  std::vector<std::string> too_near;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    too_near.clear();
    for (const PlacedBone& bone : bones) {
      const mesh::NearestPoint near = bone.nearest.nearest(x);
      const bool inside = is_inside(bone, near, x);
      if (!inside && near.distance >= distance) continue;
      x = near.point + clear_of_contact * distance * outwards(bone, near, inside, x);
      too_near.push_back(bone.obstacle->surface.name);
    }
    if (too_near.empty()) break;
  }
  return too_near;
}

/// The nodes above a node in its column of elements, up to the skin's surface: the next one first.
using Way = std::vector<Index>;

/// The way of every node, empty for one on the skin's surface and for one without a column. [n_nodes]
std::vector<Way> ways_to_skin(const mesh::Mesh& mesh) {
  std::vector<Way> ways(mesh.n_nodes());
  for (const std::vector<Index>& column : mesh::node_columns(mesh, mesh.faces("outer"))) {
    for (std::size_t below = 1; below < column.size(); ++below) {
      Way& way = ways[at(column[below])];
      if (way.empty()) way.assign(column.rend() - std::ptrdiff_t(below), column.rend());
    }
  }
  return ways;
}

/// Where a way to the skin leaves a bone.
struct Exit {
  Vec3 x = Vec3::Zero();
  std::span<const Index> rest;  ///< of the way, beyond it
  std::string bone;
};

/// The last place in which the way from x to the skin leaves a bone; nothing where no bone is in its way.
std::optional<Exit> last_exit(const std::vector<PlacedBone>& bones, std::span<const Vec3> X,
                              std::span<const Index> way, const Vec3& x) {
  std::optional<Exit> last;
  Vec3 from = x;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vec3& to = X[at(way[i])];
    double farthest = 0.0;
    for (const PlacedBone& bone : bones) {
      const std::vector<double> passes = bone.nearest.passes(from, to);
      if (passes.empty() || passes.back() <= farthest) continue;
      farthest = passes.back();
      last = {from + farthest * (to - from), way.subspan(i), bone.obstacle->surface.name};
    }
    from = to;
  }
  return last;
}

/// Where a point finds a place.
struct Place {
  Vec3 x = Vec3::Zero();
  bool was_on_far_side = false;
  std::vector<std::string> in_the_way;  ///< bones that leave it none; empty where it found one
};

/// The nearest place outside all bones, `distance` away from each, from which the way to the skin is free.
Place find_place(const std::vector<PlacedBone>& bones, std::span<const Vec3> X, const Way& way,
                 double distance, const Vec3& x) {
  Place place{x, false, {}};
  std::span<const Index> rest = way;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    place.in_the_way = push_out(bones, distance, place.x);
    // Between bones that run through each other the shortest ways lead to and fro: then along the way, from the beginning.
    const bool is_caught = !place.in_the_way.empty();
    if (is_caught && place.was_on_far_side) return place;
    const std::optional<Exit> exit = last_exit(bones, X, rest, is_caught ? x : place.x);
    if (!exit) return place;
    place.x = exit->x;
    place.was_on_far_side = true;
    rest = exit->rest;
    place.in_the_way = {exit->bone};
  }
  return place;
}

/// Presses the nodes of a way together whose lower end has gone from `before` to `after`: each stays at its part of the
/// way's length, the last one in its place.
void press_together(std::span<const Vec3> X, const Way& way, const Vec3& before, const Vec3& after,
                    std::vector<Vec3>& u) {
  double length = 0.0;
  std::vector<double> from_end;
  Vec3 from = before;
  for (const Index node : way) {
    length += (X[at(node)] - from).norm();
    from_end.push_back(length);
    from = X[at(node)];
  }
  const Vec3 shift = after - before;
  for (std::size_t i = 0; i < way.size(); ++i)
    u[at(way[i])] = (1.0 - from_end[i] / length) * shift;
}

/// No element may be inside out once its nodes are out of the bones.
void check_elements(const mesh::Mesh& mesh, const std::vector<Vec3>& u, Problems& problems) {
  std::vector<Vec3> x(mesh.X().begin(), mesh.X().end());
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += u[n];
  ProblemsOfOneKind inverted("bones", "elements turned inside out", 3);
  for (Index e = 0; e < to_index(mesh.n_elements()); ++e) {
    const bool moved = std::ranges::any_of(mesh.element(e).connectivity(),
                                           [&](Index node) { return u[at(node)] != Vec3::Zero(); });
    if (!moved || mesh::element_quality(mesh, e, x).scaled_jacobian_gauss > 0.0) continue;
    inverted.add({fmt::format("mesh element {}", e),
                  "it is inside out once its nodes are out of the bones",
                  "bones that reach less deep into the tissue",
                  "look at the bones, the poses of the jaw and its joint"});
  }
  inverted.move_to(problems);
}

}  // namespace

std::vector<Vec3> resolve_overlaps(const anatomy::FaceAnatomy& face,
                                   const std::vector<mechanics::ContactPoint>& points,
                                   const std::vector<BoneObstacle>& obstacles, double distance) {
  const std::vector<PlacedBone> bones = place_bones(obstacles);
  Problems problems;
  for (const PlacedBone& bone : bones)
    check_place(bone, points, problems);
  problems.throw_if_any<DataError>();
  ProblemsOfOneKind caught("bones", "nodes without a place");
  const std::span<const Vec3> X = face.mesh.X();
  const std::vector<Way> ways = ways_to_skin(face.mesh);
  std::vector<Vec3> u(face.mesh.n_nodes(), Vec3::Zero());
  for (const mechanics::ContactPoint& point : points) {
    const Index node = point.anchor.index;
    const Way& way = ways[at(node)];
    const Place place = find_place(bones, X, way, distance, X[at(node)]);
    if (!place.in_the_way.empty()) {
      caught.add({fmt::format("mesh node {}", node),
                  fmt::format("no place {:g} mm away from every bone, on the skin's side of it: {} "
                              "is always in the way",
                              distance, fmt::join(place.in_the_way, " or ")),
                  "bones with room for tissue between them",
                  "a smaller contact.distance, or mend the bones"});
    }
    if (place.x == X[at(node)]) continue;
    u[at(node)] = place.x - X[at(node)];
    if (place.was_on_far_side) press_together(X, way, X[at(node)], place.x, u);
  }
  caught.move_to(problems);
  if (problems.empty()) check_elements(face.mesh, u, problems);
  problems.throw_if_any<DataError>();
  return u;
}

}  // namespace facies::scenario
