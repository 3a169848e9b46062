// SPDX-License-Identifier: Apache-2.0
// Sides of meshes as contact points and contact surfaces.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "facies/mechanics/contact.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::support {

/// The faces on the boundary of the mesh that have all their nodes among these.
inline std::vector<mesh::Face> faces_between(const mesh::Mesh& mesh, std::span<const Index> nodes) {
  std::vector<mesh::Face> faces;
  for (const mesh::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<Index> corners = mesh::face_set_nodes(mesh, {&face, 1});
    const auto is_among = [&](Index node) {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    };
    if (std::all_of(corners.begin(), corners.end(), is_among)) faces.push_back(face);
  }
  return faces;
}

/// The nodes of these faces, each with `share` of its part of their area.
inline std::vector<mechanics::ContactPoint> contact_points(const mesh::Mesh& mesh,
                                                           std::span<const mesh::Face> faces,
                                                           double share = 1.0) {
  const std::vector<double> area = mesh::node_areas(mesh, faces, mesh.X());
  std::vector<mechanics::ContactPoint> points;
  for (const Index node : mesh::face_set_nodes(mesh, faces)) {
    points.push_back(
        {mechanics::Anchor::on_node(node, mesh.X()[at(node)]), share * area[at(node)]});
  }
  return points;
}

/// These faces as a surface that moves with their nodes.
inline mechanics::ContactSurface contact_surface(std::string name, const mesh::Mesh& mesh,
                                                 std::span<const mesh::Face> faces) {
  mesh::NumberedTriangles cut = mesh::triangulate_alone(mesh, faces);
  mechanics::ContactSurface surface{std::move(name), {}, std::move(cut.triangles)};
  for (const Index node : cut.nodes)
    surface.vertices.push_back(mechanics::Anchor::on_node(node, mesh.X()[at(node)]));
  return surface;
}

}  // namespace facies::support
