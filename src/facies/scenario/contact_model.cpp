// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/contact_model.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/nearest.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::scenario {

namespace {

/// Sweeps over all bones until no point is too near to any; a point between two bones may need several.
constexpr int most_sweeps = 20;

/// A little more than asked for, so that rounding leaves no force.
constexpr double margin = 1.0 + 1e-6;

BoneObstacle bone_of(const anatomy::Jaw& jaw, const SettledJaw& settled,
                     const anatomy::BoneSurface& file, Problems& problems) {
  const mesh::TriangleSurface surface =
      mesh::merge_coincident_vertices(mesh::read_obj(file.file, file.scale, problems));
  BoneObstacle obstacle;
  obstacle.surface.name = file.name;
  obstacle.surface.triangles = surface.triangles;
  for (const Vec3& X : surface.X)
    obstacle.surface.vertices.push_back(anchor_of(jaw, settled, {file.bone, X}));
  return obstacle;
}

/// Unit direction that leads a point away from the bone that it is near to or in; from a point on it, the normal.
Vec3 outwards(const mechanics::ContactSurface& surface, const mesh::NearestPoint& near,
              const Vec3& x) {
  constexpr double on_it = 1e-9;  // [mm]
  if (near.distance > on_it)
    return (near.is_inside ? Vec3(near.point - x) : Vec3(x - near.point)) / near.distance;
  const std::array<Index, 3>& corners = surface.triangles[at(near.triangle)];
  const auto corner = [&](std::size_t k) { return surface.vertices[at(corners[k])].X; };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

/// The part of the inner surface that lies on bone, moved inwards.
BoneObstacle stand_in(const mesh::Mesh& mesh, double distance) {
  const std::span<const mesh::Face> faces = mesh.faces("on_bone");
  const std::vector<Vec3> normals = mesh::vertex_normals(mesh, mesh.faces("inner"), mesh.X());
  const std::vector<Index> nodes = mesh::face_set_nodes(mesh, faces);
  BoneObstacle obstacle;
  obstacle.surface.name = "skull";
  obstacle.pushes_out = false;
  for (const Index node : nodes) {
    obstacle.surface.vertices.push_back(
        mechanics::Anchor::in_space(mesh.X()[at(node)] + margin * distance * normals[at(node)]));
  }
  for (const std::array<Index, 3>& triangle : mesh::triangulate(mesh, faces).triangles) {
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), triangle[k]);
      corners[k] = static_cast<Index>(found - nodes.begin());
    }
    obstacle.surface.triangles.push_back(corners);
  }
  return obstacle;
}

}  // namespace

std::vector<BoneObstacle> bone_obstacles(const anatomy::FaceAnatomy& face,
                                         const SettledJaw* settled, const ContactChoice& choice) {
  std::vector<BoneObstacle> obstacles;
  Problems problems;
  if (choice.bones && face.jaw && settled != nullptr) {
    for (const char* name : {"jaw", "maxilla"}) {
      const anatomy::BoneSurface* file = anatomy::find_named(face.jaw->surfaces, name);
      if (file != nullptr) obstacles.push_back(bone_of(*face.jaw, *settled, *file, problems));
    }
  }
  problems.throw_if_any<DataError>();
  const bool has_stand_in = face.mesh.face_sets().contains("on_bone");
  if (has_stand_in && choice.skull == "inner_surface")
    obstacles.push_back(stand_in(face.mesh, choice.distance));
  return obstacles;
}

std::vector<mechanics::ContactPoint> inner_points(const anatomy::FaceAnatomy& face,
                                                  const std::set<Index>& left_out) {
  const mesh::Mesh& mesh = face.mesh;
  std::map<Index, double> area;
  for (const mesh::Face& inner : mesh.faces("inner")) {
    const std::array<mesh::Face, 1> alone = {inner};
    const std::vector<Index> nodes = mesh::face_set_nodes(mesh, alone);
    const double share = mesh::face_area(mesh, inner, mesh.X()) / static_cast<double>(nodes.size());
    for (const Index node : nodes)
      area[node] += share;
  }
  std::vector<mechanics::ContactPoint> points;
  for (const auto& [node, share] : area) {
    if (!left_out.contains(node))
      points.push_back({mechanics::Anchor::on_node(node, mesh.X()[at(node)]), share});
  }
  return points;
}

std::vector<Vec3> resolve_overlaps(const anatomy::FaceAnatomy& face,
                                   const std::vector<mechanics::ContactPoint>& points,
                                   const std::vector<BoneObstacle>& obstacles, double distance) {
  std::vector<mesh::NearestTriangles> nearest;
  for (const BoneObstacle& obstacle : obstacles) {
    std::vector<Vec3> X;
    for (const mechanics::Anchor& vertex : obstacle.surface.vertices)
      X.push_back(vertex.X);
    nearest.emplace_back(X, obstacle.surface.triangles);
  }
  std::vector<Vec3> u(face.mesh.n_nodes(), Vec3::Zero());
  for (const mechanics::ContactPoint& point : points) {
    Vec3& way = u[at(point.anchor.index)];
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      bool is_free = true;
      for (std::size_t k = 0; k < obstacles.size(); ++k) {
        if (!obstacles[k].pushes_out) continue;
        const Vec3 x = point.anchor.X + way;
        const mesh::NearestPoint near = nearest[k].nearest(x);
        if (near.signed_distance() >= distance) continue;
        is_free = false;
        way +=
            (margin * distance - near.signed_distance()) * outwards(obstacles[k].surface, near, x);
      }
      if (is_free) break;
    }
  }
  return u;
}

}  // namespace facies::scenario
