// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/nearest.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/mesh/winding_number.hpp"

namespace facies::scenario {

namespace {

/// Sweeps over all bones until no point is too near to any; a point between two bones may need several.
constexpr int most_sweeps = 20;

/// A little more than asked for, so that rounding leaves no force.
constexpr double margin = 1.0 + 1e-6;

/// Points that are to say on which side of a bone the tissue is [mm].
constexpr double around_bone = 15.0;

/// Tissue that is farther from a bone has nothing to do with it [mm].
constexpr double far_from_bone = 50.0;

using Points = std::vector<mechanics::ContactPoint>;

BoneObstacle bone_of(const anatomy::Jaw& jaw, const SettledJaw& settled,
                     const anatomy::BoneSurface& bone) {
  BoneObstacle obstacle;
  obstacle.surface.name = bone.name;
  obstacle.surface.triangles = bone.surface.triangles;
  for (const Vec3& X : bone.surface.X)
    obstacle.surface.vertices.push_back(anchor_of(jaw, settled, {bone.bone, X}));
  obstacle.closed = bone.closed;
  obstacle.where = bone.file.string();
  return obstacle;
}

/// The part of the inner surface that lies on bone, moved inwards.
BoneObstacle stand_in(const mesh::Mesh& mesh, double distance) {
  const std::vector<Vec3> normals = mesh::vertex_normals(mesh, mesh.faces("inner"), mesh.X());
  mesh::NumberedTriangles part = mesh::triangulate_alone(mesh, mesh.faces("on_bone"));
  BoneObstacle obstacle;
  obstacle.surface.name = "skull";
  obstacle.pushes_out = false;
  for (const Index node : part.nodes) {
    obstacle.surface.vertices.push_back(
        mechanics::Anchor::in_space(mesh.X()[at(node)] + margin * distance * normals[at(node)]));
  }
  obstacle.surface.triangles = std::move(part.triangles);
  return obstacle;
}

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
      x = near.point + margin * distance * outwards(bone, near, inside, x);
      too_near.push_back(bone.obstacle->surface.name);
    }
    if (too_near.empty()) break;
  }
  return too_near;
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

/// The surface around the mouth as a contact of the tissue with itself.
std::unique_ptr<mechanics::Contact> lip_contact(const mechanics::Model& model,
                                                const mesh::Mesh& mesh,
                                                const mechanics::ContactSettings& settings) {
  const std::span<const mesh::Face> faces = mesh.faces("mouth");
  const std::vector<double> area = mesh::node_areas(mesh, faces, mesh.X());
  mesh::NumberedTriangles part = mesh::triangulate_alone(mesh, faces);
  Points points;
  mechanics::ContactSurface surface{"lips", {}, std::move(part.triangles)};
  for (const Index node : part.nodes) {
    const mechanics::Anchor anchor = mechanics::Anchor::on_node(node, mesh.X()[at(node)]);
    points.push_back({anchor, area[at(node)]});
    surface.vertices.push_back(anchor);
  }
  return std::make_unique<mechanics::Contact>(model, std::move(points), std::move(surface),
                                              settings);
}

}  // namespace

std::vector<BoneObstacle> bone_obstacles(const anatomy::FaceAnatomy& face,
                                         const SettledJaw* settled, const ContactChoice& choice) {
  std::vector<BoneObstacle> obstacles;
  if (choice.bones && face.jaw && settled != nullptr) {
    for (const char* name : {"jaw", "maxilla"}) {
      const anatomy::BoneSurface* bone = anatomy::find_named(face.jaw->surfaces, name);
      if (bone != nullptr) obstacles.push_back(bone_of(*face.jaw, *settled, *bone));
    }
  }
  const bool has_stand_in = face.mesh.face_sets().contains("on_bone");
  if (has_stand_in && choice.skull == "inner_surface")
    obstacles.push_back(stand_in(face.mesh, choice.distance));
  return obstacles;
}

std::vector<mechanics::ContactPoint> inner_points(const anatomy::FaceAnatomy& face,
                                                  const std::set<Index>& left_out) {
  const mesh::Mesh& mesh = face.mesh;
  const std::span<const mesh::Face> inner = mesh.faces("inner");
  const std::vector<double> area = mesh::node_areas(mesh, inner, mesh.X());
  Points points;
  for (const Index node : mesh::face_set_nodes(mesh, inner)) {
    if (!left_out.contains(node))
      points.push_back({mechanics::Anchor::on_node(node, mesh.X()[at(node)]), area[at(node)]});
  }
  return points;
}

std::vector<Vec3> resolve_overlaps(const anatomy::FaceAnatomy& face,
                                   const std::vector<mechanics::ContactPoint>& points,
                                   const std::vector<BoneObstacle>& obstacles, double distance) {
  const std::vector<PlacedBone> bones = place_bones(obstacles);
  Problems problems;
  for (const PlacedBone& bone : bones)
    check_place(bone, points, problems);
  problems.throw_if_any<DataError>();
  ProblemsOfOneKind caught("bones", "nodes without a place");
  std::vector<Vec3> u(face.mesh.n_nodes(), Vec3::Zero());
  for (const mechanics::ContactPoint& point : points) {
    Vec3 x = point.anchor.X;
    const std::vector<std::string> too_near = push_out(bones, distance, x);
    if (!too_near.empty()) {
      caught.add({fmt::format("mesh node {}", point.anchor.index),
                  fmt::format("no place {:g} mm away from every bone: it always comes nearer to {}",
                              distance, fmt::join(too_near, " and ")),
                  "bones with room for tissue between them",
                  "a smaller contact.distance, or mend the bones"});
    }
    if (x != point.anchor.X) u[at(point.anchor.index)] = x - point.anchor.X;
  }
  caught.move_to(problems);
  if (problems.empty()) check_elements(face.mesh, u, problems);
  problems.throw_if_any<DataError>();
  return u;
}

ContactTerms add_contacts(mechanics::Model& model, const anatomy::FaceAnatomy& face,
                          const SettledJaw* settled, const ContactChoice& choice,
                          const std::set<Index>& left_out, int threads) {
  const mechanics::ContactSettings settings{
      .d_hat = choice.distance, .stiffness = choice.stiffness, .threads = threads};
  ContactTerms terms;
  std::vector<BoneObstacle> obstacles = bone_obstacles(face, settled, choice);
  if (!obstacles.empty()) {
    const Points points = inner_points(face, left_out);
    terms.start = resolve_overlaps(face, points, obstacles, choice.distance);
    for (BoneObstacle& obstacle : obstacles) {
      terms.contacts.push_back(&model.add(std::make_unique<mechanics::Contact>(
          model, points, std::move(obstacle.surface), settings)));
    }
  }
  if (choice.lips && face.mesh.face_sets().contains("mouth"))
    terms.contacts.push_back(&model.add(lip_contact(model, face.mesh, settings)));
  return terms;
}

}  // namespace facies::scenario
