// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/mesh.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace facies::mesh {
namespace {

template <class T>
void sort_unique(std::vector<T>& members) {
  std::ranges::sort(members);
  // std::unique, because clang 14 rejects the subrange of std::ranges::unique.
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

bool is_member(Index index, std::size_t size) {
  return index >= 0 && at(index) < size;
}

template <class T>
std::span<const T> find_set(const std::map<std::string, std::vector<T>>& sets,
                            const std::string& name) {
  const auto found = sets.find(name);
  if (found == sets.end()) return {};
  return found->second;
}

void check_element(std::size_t e, const Element& element, std::size_t n_nodes, Problems& problems) {
  const std::string where = fmt::format("mesh element {} ({})", e, name(element.type));
  const std::span<const Index> nodes = element.connectivity();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_member(nodes[i], n_nodes)) {
      problems.add({where, fmt::format("node {}, which does not exist", nodes[i]),
                    fmt::format("{} nodes counted from 0", n_nodes), ""});
    } else if (std::ranges::find(nodes.first(i), nodes[i]) != nodes.begin() + std::ptrdiff_t(i)) {
      problems.add({where, fmt::format("node {} more than once", nodes[i]),
                    fmt::format("{} different nodes", nodes.size()),
                    element.type == CellType::hex8
                        ? "a hexahedron with collapsed edges may be a wedge"
                        : ""});
    }
  }
}

}  // namespace

Mesh::Mesh(std::vector<Vec3> X, std::vector<Element> elements)
    : X_(std::move(X)), elements_(std::move(elements)) {
  Problems problems;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    check_element(e, elements_[e], X_.size(), problems);
  }
  problems.throw_if_any<DataError>();
}

std::vector<Index> Mesh::face_nodes(Face face) const {
  const Element& owner = element(face.element);
  std::vector<Index> nodes;
  for (const std::uint8_t local : mesh::faces(owner.type)[face.local]) {
    nodes.push_back(owner.nodes[local]);
  }
  return nodes;
}

Vec3 Mesh::centroid(Index e) const {
  Vec3 sum = Vec3::Zero();
  const std::span<const Index> nodes = element(e).connectivity();
  for (const Index node : nodes)
    sum += X_[at(node)];
  return sum / double(nodes.size());
}

void Mesh::set_nodes(const std::string& name, std::vector<Index> nodes) {
  sort_unique(nodes);
  require(
      nodes.empty() || (is_member(nodes.front(), n_nodes()) && is_member(nodes.back(), n_nodes())),
      "a node set names a node that the mesh does not have");
  node_sets_[name] = std::move(nodes);
}

void Mesh::set_elements(const std::string& name, std::vector<Index> elements) {
  sort_unique(elements);
  require(elements.empty() || (is_member(elements.front(), n_elements()) &&
                               is_member(elements.back(), n_elements())),
          "an element set names an element that the mesh does not have");
  element_sets_[name] = std::move(elements);
}

void Mesh::set_faces(const std::string& name, std::vector<Face> faces) {
  sort_unique(faces);
  for (const Face& face : faces) {
    require(is_member(face.element, n_elements()) &&
                face.local < mesh::faces(element(face.element).type).size(),
            "a face set names a face that the mesh does not have");
  }
  face_sets_[name] = std::move(faces);
}

std::span<const Index> Mesh::nodes(const std::string& name) const {
  return find_set(node_sets_, name);
}

std::span<const Index> Mesh::elements(const std::string& name) const {
  return find_set(element_sets_, name);
}

std::span<const Face> Mesh::faces(const std::string& name) const {
  return find_set(face_sets_, name);
}

}  // namespace facies::mesh
