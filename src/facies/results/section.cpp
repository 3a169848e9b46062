// SPDX-License-Identifier: Apache-2.0
#include "facies/results/section.hpp"

#include <algorithm>
#include <map>

#include "facies/base/error.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {

namespace {

/// Of the faces: skin, inner side, where the mesh ends, between two layers.
enum Kind : std::uint8_t { outer, inner, rim, between };
constexpr std::array<Colour, 4> kind_colours{palette::skin, palette::inside, palette::rim,
                                             palette::rim};

struct LayerFace {
  mesh::Face face;  ///< of the element on its inside
  Kind kind = rim;
  Sides sides;
};

/// The boundary, then the faces between layers, each once.
std::vector<LayerFace> layer_faces(const Subject& subject) {
  const mesh::Mesh& mesh = *subject.mesh;
  const std::span<const mesh::Face> skin = mesh.faces("outer");
  const std::span<const mesh::Face> inside = mesh.faces("inner");
  const auto layer_of = [&](mesh::Face face) { return subject.layer_of_element[at(face.element)]; };
  std::vector<LayerFace> list;
  for (const mesh::Face face : mesh::boundary_faces(mesh)) {
    const bool is_outer = std::binary_search(skin.begin(), skin.end(), face);
    const bool is_inner = std::binary_search(inside.begin(), inside.end(), face);
    list.push_back({face, is_outer ? outer : is_inner ? inner : rim, {layer_of(face), -1}});
  }
  std::map<mesh::FaceKey, mesh::Face> seen;
  for (Index e = 0; e < to_index(mesh.n_elements()); ++e) {
    const std::size_t n_faces = mesh::faces(mesh.element(e).type).size();
    for (std::uint8_t local = 0; local < n_faces; ++local) {
      const mesh::Face face{e, local};
      const auto [other, is_new] = seen.try_emplace(mesh::face_key(mesh, face), face);
      if (is_new || layer_of(other->second) == layer_of(face)) continue;
      list.push_back({face, between, {layer_of(face), layer_of(other->second)}});
    }
  }
  return list;
}

/// Triangles as they are, with the mean normals of those around each vertex.
Surface flat_surface(std::span<const Vec3> x,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Vec3> normals(x.size(), Vec3::Zero());
  for (const auto& t : triangles) {
    const Vec3 area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
    for (const std::uint32_t vertex : t)
      normals[vertex] += area;
  }
  Surface surface;
  for (std::size_t v = 0; v < x.size(); ++v) {
    surface.positions.push_back(x[v].cast<float>());
    surface.normals.push_back(normals[v].normalized().cast<float>());
  }
  surface.round.assign(x.size(), false);
  surface.colours.resize(x.size());
  surface.triangles = triangles;
  return surface;
}

}  // namespace

Colour layer_colour(std::size_t layer) {
  return palette::cut_layers[layer % palette::cut_layers.size()];
}

LayeredTissue::LayeredTissue(const Subject& subject) : mesh_(subject.mesh) {
  require(subject.layer_of_element.size() == mesh_->n_elements(),
          "LayeredTissue: one layer per element");
  for (std::size_t layer = 0; layer < subject.layers.size(); ++layer)
    fills_.push_back(layer_colour(layer));
  const std::vector<LayerFace> list = layer_faces(subject);
  std::vector<mesh::Face> faces;
  faces.reserve(list.size());
  for (const LayerFace& entry : list)
    faces.push_back(entry.face);
  std::map<std::pair<Index, Kind>, std::uint32_t> vertex_at;
  const mesh::FaceTriangles cut = mesh::triangulate(*mesh_, faces);
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    const LayerFace& entry = list[at(cut.face[t])];
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index node = cut.triangles[t][k];
      const auto [found, is_new] =
          vertex_at.try_emplace({node, entry.kind}, static_cast<std::uint32_t>(vertices_.size()));
      if (is_new) vertices_.push_back({node, kind_colours[entry.kind]});
      corners[k] = found->second;
    }
    triangles_.push_back(corners);
    sides_.push_back(entry.sides);
  }
}

Surface LayeredTissue::pose(std::span<const Vec3> u) const {
  require(u.size() == mesh_->n_nodes(), "LayeredTissue: one displacement per node");
  std::vector<Vec3> x;
  for (const Vertex& vertex : vertices_)
    x.emplace_back(mesh_->X()[at(vertex.node)] + u[at(vertex.node)]);
  Surface surface = flat_surface(x, triangles_);
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    surface.colours[v] = vertices_[v].colour;
  surface.sides = sides_;
  surface.fills = fills_;
  return surface;
}

Surface surface_of(const BoneShape& bone) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::array<Index, 3>& t : bone.surface.triangles)
    triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                         static_cast<std::uint32_t>(t[2])});
  Surface surface = flat_surface(bone.surface.X, triangles);
  surface.colours.assign(surface.positions.size(), bone.colour);
  for (std::size_t v = 0; v < bone.is_tooth.size(); ++v) {
    if (bone.is_tooth[v]) surface.colours[v] = palette::teeth;
  }
  if (bone.is_solid) {
    surface.sides.assign(surface.triangles.size(), {0, -1});
    surface.fills = {palette::cut_bone};
  }
  return surface;
}

Surface surface_of(const BoneShape& bone, const Subject& subject, const mechanics::State& state) {
  BoneShape now = bone;
  for (Vec3& x : now.surface.X)
    x = place_of(subject, bone, state, x);
  now.is_solid = false;
  return surface_of(now);
}

Actor carried(const Scene& scene, const BoneShape& bone, const Subject& subject,
              const mechanics::State& state) {
  Actor actor{.scene = &scene};
  if (bone.body >= 0 && at(bone.body) < state.bodies.size())
    actor.R = state.bodies[at(bone.body)].R;
  actor.t = place_of(subject, bone, state, Vec3::Zero());
  return actor;
}

}  // namespace facies::results
