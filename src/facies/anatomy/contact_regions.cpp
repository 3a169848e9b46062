// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/contact_regions.hpp"

#include <algorithm>
#include <set>

#include "facies/mesh/surface.hpp"

namespace facies::anatomy {

namespace {

/// Nodes behind which there is no bone.
std::set<Index> free_nodes(const mesh::Mesh& mesh) {
  std::set<Index> nodes;
  for (const auto& [name, members] : mesh.node_sets()) {
    if (name.ends_with("_free")) nodes.insert(members.begin(), members.end());
  }
  return nodes;
}

std::vector<mesh::Face> faces_on_bone(const mesh::Mesh& mesh, double above) {
  const std::set<Index> without_bone = free_nodes(mesh);
  if (without_bone.empty()) return {};
  std::vector<mesh::Face> faces;
  for (const mesh::Face& face : mesh.faces("inner")) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    const bool on_bone = std::all_of(nodes.begin(), nodes.end(), [&](Index node) {
      return mesh.X()[at(node)].z() >= above && !without_bone.contains(node);
    });
    if (on_bone) faces.push_back(face);
  }
  return faces;
}

const Landmark* find_landmark(const FaceAnatomy& face, const char* name) {
  const auto found = std::ranges::find(face.landmarks, name, &Landmark::name);
  return found == face.landmarks.end() ? nullptr : &*found;
}

/// Distance from the segment ab, all seen from the front (along x).
double frontal_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Eigen::Vector2d from = a.tail<2>();
  const Eigen::Vector2d along = b.tail<2>() - from;
  const Eigen::Vector2d to_p = p.tail<2>() - from;
  const double t = std::clamp(to_p.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (to_p - t * along).norm();
}

std::vector<mesh::Face> faces_around_mouth(const FaceAnatomy& face, double around) {
  const Landmark* left = find_landmark(face, "LMC");
  const Landmark* right = find_landmark(face, "RMC");
  if (left == nullptr || right == nullptr) return {};
  const std::span<const Vec3> X = face.mesh.X();
  const Vec3& a = X[at(left->node)];
  const Vec3& b = X[at(right->node)];
  const double deepest = std::max(a.x(), b.x()) + around;
  std::vector<mesh::Face> faces;
  for (const mesh::Face& boundary : mesh::boundary_faces(face.mesh)) {
    const std::vector<Index> nodes = face.mesh.face_nodes(boundary);
    const bool near = std::all_of(nodes.begin(), nodes.end(), [&](Index node) {
      const Vec3& x = X[at(node)];
      return x.x() <= deepest && frontal_distance(x, a, b) <= around;
    });
    if (near) faces.push_back(boundary);
  }
  return faces;
}

}  // namespace

void mark_contact_regions(FaceAnatomy& face, double above, double around) {
  std::vector<mesh::Face> on_bone = faces_on_bone(face.mesh, above);
  if (!on_bone.empty()) face.mesh.set_faces("on_bone", std::move(on_bone));
  std::vector<mesh::Face> mouth = faces_around_mouth(face, around);
  if (!mouth.empty()) face.mesh.set_faces("mouth", std::move(mouth));
}

}  // namespace facies::anatomy
