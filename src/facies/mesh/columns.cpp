// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/columns.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

/// The one or two elements of each face of the mesh.
std::map<FaceKey, std::vector<Face>> faces_by_key(const Mesh& mesh) {
  std::map<FaceKey, std::vector<Face>> by_key;
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    const std::size_t n_faces = faces(mesh.elements()[e].type).size();
    for (std::size_t local = 0; local < n_faces; ++local) {
      const Face face{to_index(e), static_cast<std::uint8_t>(local)};
      by_key[face_key(mesh, face)].push_back(face);
    }
  }
  return by_key;
}

/// The node that an edge outside `face` joins with `node` of that face.
Index node_below(const Mesh& mesh, Face face, Index node) {
  const Element& element = mesh.element(face.element);
  const std::vector<Index> top = mesh.face_nodes(face);
  for (const auto& edge : edges(element.type)) {
    const Index a = element.nodes[edge[0]];
    const Index b = element.nodes[edge[1]];
    if (a == node && std::ranges::find(top, b) == top.end()) return b;
    if (b == node && std::ranges::find(top, a) == top.end()) return a;
  }
  return -1;
}

}  // namespace

Face opposite_face(const Mesh& mesh, Face face) {
  const auto all = faces(mesh.element(face.element).type);
  const std::vector<std::uint8_t>& own = all[face.local];
  for (std::size_t local = 0; local < all.size(); ++local) {
    const bool apart = std::ranges::none_of(
        all[local], [&](std::uint8_t n) { return std::ranges::find(own, n) != own.end(); });
    if (apart && all[local].size() == own.size()) {
      return {face.element, static_cast<std::uint8_t>(local)};
    }
  }
  return {};
}

std::vector<Face> outward_faces(const Mesh& mesh, std::span<const Face> outer) {
  const std::map<FaceKey, std::vector<Face>> by_key = faces_by_key(mesh);
  std::vector<Face> outward(mesh.n_elements());
  std::vector<Face> front(outer.begin(), outer.end());
  while (!front.empty()) {
    std::vector<Face> next;
    for (const Face& face : front) {
      if (outward[at(face.element)].element >= 0) continue;
      outward[at(face.element)] = face;
      const Face back = opposite_face(mesh, face);
      if (back.element < 0) continue;
      for (const Face& below : by_key.at(face_key(mesh, back))) {
        if (below.element != face.element) next.push_back(below);
      }
    }
    front = std::move(next);
  }
  return outward;
}

std::vector<std::vector<Index>> node_columns(const Mesh& mesh, std::span<const Face> outer) {
  std::vector<Index> below(mesh.n_nodes(), -1);
  for (const Face& face : outward_faces(mesh, outer)) {
    if (face.element < 0) continue;
    for (const Index node : mesh.face_nodes(face))
      below[at(node)] = node_below(mesh, face, node);
  }
  std::vector<std::vector<Index>> columns;
  for (const Index top : face_set_nodes(mesh, outer)) {
    std::vector<Index> column;
    // A column that comes back to itself (a ring of elements) ends where it would start again.
    for (Index n = top; n >= 0 && std::ranges::find(column, n) == column.end(); n = below[at(n)]) {
      column.push_back(n);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<double> element_thickness(const Mesh& mesh, std::span<const Index> elements,
                                      std::span<const Face> outward, std::span<const Vec3> x) {
  std::vector<double> thickness;
  thickness.reserve(elements.size());
  for (const Index e : elements) {
    const Face top = outward[at(e)];
    const Face bottom = top.element < 0 ? Face{} : opposite_face(mesh, top);
    if (bottom.element < 0) {
      thickness.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double area = 0.5 * (face_area(mesh, top, x) + face_area(mesh, bottom, x));
    thickness.push_back(element_volume(mesh, e, x) / area);
  }
  return thickness;
}

}  // namespace facies::mesh
