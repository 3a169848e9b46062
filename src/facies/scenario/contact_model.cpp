// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/contact_model.hpp"

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/scenario/bone_points.hpp"

namespace facies::scenario {

namespace {

using Points = std::vector<mechanics::ContactPoint>;

BoneObstacle bone_of(const anatomy::Jaw& jaw, const SettledJaw& settled,
                     const anatomy::BoneSurface& bone) {
  BoneObstacle obstacle;
  obstacle.surface.name = bone.name;
  obstacle.surface.triangles = bone.surface.triangles;
  for (const Vec3& X : bone.surface.X)
    obstacle.surface.vertices.push_back(anchor_of(jaw, settled, {bone.bone, X}));
  obstacle.closed = bone.closed;
  obstacle.presses = bone.presses;
  obstacle.where = bone.file.string();
  return obstacle;
}

/// Tissue lies on the bones of the jaws; the hyoid is away from it.
bool is_met(const anatomy::Jaw& jaw, const anatomy::BoneSurface& surface) {
  const std::string& bone = jaw.bones[at(surface.bone)].name;
  return bone == "jaw" || bone == "maxilla";
}

/// The part of the inner surface that lies on bone, moved inwards.
BoneObstacle stand_in(const mesh::Mesh& mesh, double distance) {
  const std::vector<Vec3> normals = mesh::vertex_normals(mesh, mesh.faces("inner"), mesh.X());
  mesh::NumberedTriangles part = mesh::triangulate_alone(mesh, mesh.faces("on_bone"));
  BoneObstacle obstacle;
  obstacle.surface.name = "skull";
  obstacle.pushes_out = false;
  for (const Index node : part.nodes) {
    const Vec3 below = clear_of_contact * distance * normals[at(node)];
    obstacle.surface.vertices.push_back(mechanics::Anchor::in_space(mesh.X()[at(node)] + below));
  }
  obstacle.surface.triangles = std::move(part.triangles);
  return obstacle;
}

/// The surface around the mouth as a contact of the tissue with itself.
std::unique_ptr<mechanics::Contact> lip_contact(const mechanics::Model& model,
                                                const mesh::Mesh& mesh,
                                                const mechanics::ContactSettings& settings) {
  const std::span<const mesh::Face> faces = mesh.faces("mouth");
  const std::vector<double> area = mesh::node_areas(mesh, faces, mesh.X());
  mechanics::ContactSurface surface = tissue_surface(mesh, faces, "lips");
  Points points;
  for (const mechanics::Anchor& node : surface.vertices)
    points.push_back({node, area[at(node.index)]});
  return std::make_unique<mechanics::Contact>(model, std::move(points), std::move(surface),
                                              settings);
}

/// The vertices of a bone as points that the inner surface of the tissue may not pass.
std::unique_ptr<mechanics::Contact> edge_contact(const mechanics::Model& model,
                                                 const mesh::Mesh& mesh,
                                                 const std::vector<Vec3>& start,
                                                 const mechanics::ContactSurface& bone,
                                                 double distance,
                                                 const mechanics::ContactSettings& settings) {
  return std::make_unique<mechanics::Contact>(
      model, bone_points(mesh, start, bone, distance),
      tissue_surface(mesh, mesh.faces("inner"), "edges of the " + bone.name), settings);
}

}  // namespace

std::vector<BoneObstacle> bone_obstacles(const anatomy::FaceAnatomy& face,
                                         const SettledJaw* settled, const ContactChoice& choice) {
  std::vector<BoneObstacle> obstacles;
  if (choice.bones && face.jaw && settled != nullptr) {
    for (const anatomy::BoneSurface& bone : face.jaw->surfaces) {
      if (bone.kind != anatomy::SurfaceKind::solid) continue;
      if (is_met(*face.jaw, bone)) obstacles.push_back(bone_of(*face.jaw, *settled, bone));
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

mechanics::ContactSurface tissue_surface(const mesh::Mesh& mesh, std::span<const mesh::Face> faces,
                                         const std::string& name) {
  mesh::NumberedTriangles part = mesh::triangulate_alone(mesh, faces);
  mechanics::ContactSurface surface{name, {}, std::move(part.triangles)};
  for (const Index node : part.nodes)
    surface.vertices.push_back(mechanics::Anchor::on_node(node, mesh.X()[at(node)]));
  return surface;
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
      if (obstacle.presses) {
        terms.contacts.push_back(&model.add(edge_contact(
            model, face.mesh, terms.start, obstacle.surface, choice.distance, settings)));
      }
      terms.contacts.push_back(&model.add(std::make_unique<mechanics::Contact>(
          model, points, std::move(obstacle.surface), settings)));
    }
  }
  if (choice.lips && face.mesh.face_sets().contains("mouth"))
    terms.contacts.push_back(&model.add(lip_contact(model, face.mesh, settings)));
  return terms;
}

}  // namespace facies::scenario
