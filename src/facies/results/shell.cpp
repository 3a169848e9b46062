// SPDX-License-Identifier: Apache-2.0
#include "facies/results/shell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "facies/base/error.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {

namespace {

const double crease_cosine = std::cos(50.0 * std::numbers::pi / 180.0);

/// Of the faces: skin, inner side, where the mesh ends.
enum Kind { skin, inside, cut };
constexpr std::array<Colour, 3> kind_colours{palette::skin, palette::inside, palette::rim};
/// How far the middle of a lid lies behind its border [mm].
constexpr double lid_depth = 6.0;
/// The same for the curtain behind an open mouth: a disc, by this much wider than the mouth.
constexpr double curtain_depth = 45.0;
constexpr double curtain_width = 1.6;

/// The closed lines that border a set of faces, all but the longest, as their nodes in order (the first one twice).
std::vector<std::vector<Index>> shorter_borders(const mesh::Mesh& mesh,
                                                std::span<const mesh::Face> faces) {
  std::map<Index, Index>
      next;  // along the border; an inner edge is run through both ways and drops out
  std::map<std::array<Index, 2>, int> uses;
  for (const mesh::Face& face : faces) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      ++uses[{nodes[i], nodes[(i + 1) % nodes.size()]}];
  }
  for (const auto& [edge, count] : uses) {
    if (!uses.contains({edge[1], edge[0]})) next[edge[0]] = edge[1];
  }
  std::vector<std::vector<Index>> borders;
  std::size_t longest = 0;
  double longest_length = 0.0;
  while (!next.empty()) {
    std::vector<Index> line;
    double length = 0.0;
    for (auto step = next.begin(); step != next.end();
         step = next.find(line.empty() ? -1 : line.back())) {
      const auto [from, to] = *step;
      if (line.empty()) line.push_back(from);
      length += (mesh.X()[at(to)] - mesh.X()[at(from)]).norm();
      line.push_back(to);
      next.erase(step);
    }
    if (length > longest_length) {
      longest_length = length;
      longest = borders.size();
    }
    borders.push_back(std::move(line));
  }
  if (!borders.empty()) borders.erase(borders.begin() + static_cast<std::ptrdiff_t>(longest));
  return borders;
}

/// Which of the holes has the most nodes of the face set "mouth"; their number where none has any.
std::size_t find_mouth(const mesh::Mesh& mesh, const std::vector<std::vector<Index>>& holes) {
  const std::vector<Index> nodes = mesh::face_set_nodes(mesh, mesh.faces("mouth"));
  std::size_t mouth = holes.size();
  std::ptrdiff_t most = 0;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const std::ptrdiff_t n = std::ranges::count_if(
        holes[h], [&](Index node) { return std::ranges::binary_search(nodes, node); });
    if (n > most) {
      most = n;
      mouth = h;
    }
  }
  return mouth;
}

/// The holes whose middle has no eye behind it.
std::vector<std::vector<Index>> without_eyes(std::vector<std::vector<Index>> holes,
                                             const mesh::Mesh& mesh,
                                             std::span<const EyeShape> eyes) {
  constexpr double near = 1.5;  // radii
  std::erase_if(holes, [&](const std::vector<Index>& hole) {
    Vec3 middle = Vec3::Zero();
    for (const Index node : hole)
      middle += mesh.X()[at(node)] / static_cast<double>(hole.size());
    return std::ranges::any_of(eyes, [&](const EyeShape& eye) {
      return (middle - eye.centre).norm() < near * eye.radius;
    });
  });
  return holes;
}

}  // namespace

Shell::Shell(const mesh::Mesh& mesh, std::span<const EyeShape> eyes)
    : mesh_(&mesh),
      faces_(mesh::boundary_faces(mesh)),
      holes_(without_eyes(shorter_borders(mesh, mesh.faces("inner")), mesh, eyes)),
      mouth_(find_mouth(mesh, holes_)) {
  const std::vector<Vec3> normals = mesh::face_normals(mesh, faces_, mesh.X());
  const std::span<const mesh::Face> outer = mesh.faces("outer");
  const std::span<const mesh::Face> inner = mesh.faces("inner");
  std::vector<int> kinds;
  std::vector<std::vector<std::size_t>> faces_at_node(mesh.n_nodes());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const bool is_outer = std::binary_search(outer.begin(), outer.end(), faces_[f]);
    const bool is_inner = std::binary_search(inner.begin(), inner.end(), faces_[f]);
    kinds.push_back(is_outer ? skin : is_inner ? inside : cut);
    for (const Index node : mesh.face_nodes(faces_[f]))
      faces_at_node[at(node)].push_back(f);
  }
  std::vector<std::vector<std::uint32_t>> vertices_at_node(mesh.n_nodes());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    add_face(f, faces_at_node, normals, kinds, vertices_at_node);
  for (Vertex& vertex : vertices_)
    vertex.round = vertices_at_node[at(vertex.node)].size() == 1;
}

void Shell::add_face(std::size_t face, std::span<const std::vector<std::size_t>> faces_at_node,
                     std::span<const Vec3> normals, std::span<const int> kinds,
                     std::vector<std::vector<std::uint32_t>>& vertices_at_node) {
  std::vector<std::uint32_t> corners;
  for (const Index node : mesh_->face_nodes(faces_[face])) {
    Vertex vertex{node, {}, kind_colours[static_cast<std::size_t>(kinds[face])], false};
    for (const std::size_t other : faces_at_node[at(node)]) {
      const bool is_smooth =
          kinds[face] == skin || normals[face].dot(normals[other]) > crease_cosine;
      if (other == face || (kinds[other] == kinds[face] && is_smooth))
        vertex.faces.push_back(other);
    }
    std::vector<std::uint32_t>& known = vertices_at_node[at(node)];
    const auto same = [&](std::uint32_t v) { return vertices_[v].faces == vertex.faces; };
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found != known.end()) {
      corners.push_back(*found);
    } else {
      corners.push_back(static_cast<std::uint32_t>(vertices_.size()));
      known.push_back(corners.back());
      vertices_.push_back(std::move(vertex));
    }
  }
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles_.push_back({corners[0], corners[k - 1], corners[k]});
}

Surface Shell::pose(std::span<const Vec3> u, std::span<const double> node_values, Lids lids) const {
  require(u.size() == mesh_->n_nodes(), "Shell: one displacement per node");
  require(node_values.empty() || node_values.size() == mesh_->n_nodes(),
          "Shell: one value per node, or none");
  std::vector<Vec3> x(u.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = mesh_->X()[i] + u[i];
  std::vector<Vec3> normals;
  for (const mesh::Face& face : faces_)
    normals.push_back(mesh::area_vector(*mesh_, face, x));

  Surface surface;
  surface.triangles = triangles_;
  for (const Vertex& vertex : vertices_) {
    Vec3 normal = Vec3::Zero();
    for (const std::size_t f : vertex.faces)
      normal += normals[f];
    surface.positions.push_back(x[at(vertex.node)].cast<float>());
    surface.normals.push_back(normal.normalized().cast<float>());
    surface.round.push_back(vertex.round);
    surface.colours.push_back(vertex.colour);
    if (!node_values.empty())
      surface.values.push_back(static_cast<float>(node_values[at(vertex.node)]));
  }
  for (std::size_t h = 0; lids != Lids::none && h < holes_.size(); ++h)
    add_lid(holes_[h], x, lids == Lids::open_mouth && h == mouth_, surface);
  if (node_values.empty()) surface.values.clear();
  return surface;
}

void Shell::add_lid(std::span<const Index> hole, std::span<const Vec3> x, bool is_curtain,
                    Surface& surface) {
  Vec3 middle = Vec3::Zero();
  for (const Index node : hole.subspan(1))
    middle += x[at(node)] / static_cast<double>(hole.size() - 1);
  Vec3 inward = Vec3::Zero();
  for (std::size_t i = 1; i < hole.size(); ++i) {
    inward += (x[at(hole[i])] - middle).cross(x[at(hole[i - 1])] - middle);
  }
  // A mouth is a slit that follows the teeth: its own normal says little.
  inward = is_curtain ? Vec3(Vec3::UnitX()) : Vec3(inward.normalized());
  const auto add = [&](const Vec3& position) {
    surface.positions.push_back(position.cast<float>());
    surface.normals.push_back((-inward).cast<float>());
    surface.round.push_back(false);
    surface.colours.push_back(palette::hollow);
    surface.values.push_back(std::numeric_limits<float>::quiet_NaN());
    return static_cast<std::uint32_t>(surface.positions.size() - 1);
  };
  const std::uint32_t centre = add(middle + (is_curtain ? curtain_depth : lid_depth) * inward);
  double radius = 0.0;
  for (const Index node : hole)
    radius = std::max(radius, curtain_width * (x[at(node)] - middle).norm());
  const auto add_border = [&](Index node) {
    if (!is_curtain) return add(x[at(node)]);
    Vec3 aside = x[at(node)] - middle;
    aside.x() = 0.0;
    return add(middle + curtain_depth * inward + radius * aside.normalized());
  };
  std::uint32_t before = add_border(hole[0]);
  for (std::size_t i = 1; i < hole.size(); ++i) {
    const std::uint32_t here = add_border(hole[i]);
    surface.triangles.push_back({centre, before, here});
    before = here;
  }
}

}  // namespace facies::results
