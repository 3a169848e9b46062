// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/reference_mesh.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "facies/mesh/quality.hpp"

namespace facies::anatomy {
namespace {

using mesh::CellType;
using mesh::Element;

constexpr double smallest_face = 50.0;  // [mm]
constexpr double largest_face = 500.0;  // [mm]

bool is_wedge(const std::array<long, 8>& n) {
  return n[2] == n[3] && n[6] == n[7] && std::set<long>(n.begin(), n.end()).size() == 6;
}

/// Our nodes for those of the row, or a problem.
std::optional<Element> make_element(const ElementRow& row, const Numbering& nodes,
                                    ProblemsOfOneKind& bad) {
  std::array<Index, 8> n{};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::optional<Index> index = nodes.index(row.nodes[i]);
    if (!index) {
      bad.add({row.where, fmt::format("element {} names node {}", row.number, row.nodes[i]),
               "a node of the .node file", "the files may be truncated or of different meshes"});
      return std::nullopt;
    }
    n[i] = *index;
  }
  if (is_wedge(row.nodes)) {
    return Element{CellType::wedge6, {n[0], n[1], n[2], n[4], n[5], n[6], -1, -1}};
  }
  if (std::set<Index>(n.begin(), n.end()).size() == 8) return Element{CellType::hex8, n};
  bad.add({row.where, fmt::format("element {} names a node twice", row.number),
           "eight different nodes, or a b c c d e f f for a wedge", ""});
  return std::nullopt;
}

Element turned(const Element& element) {
  const std::array<Index, 8>& n = element.nodes;
  if (element.type == CellType::hex8) {
    return {CellType::hex8, {n[0], n[3], n[2], n[1], n[4], n[7], n[6], n[5]}};
  }
  return {CellType::wedge6, {n[0], n[2], n[1], n[3], n[5], n[4], -1, -1}};
}

void check_mesh(const ReferenceMesh& result, const std::vector<PointRow>& points,
                const std::vector<ElementRow>& elements, const std::string& points_file,
                Problems& problems) {
  const mesh::SourceNames names{
      [&](Index n) {
        return fmt::format("{} (node {})", points[at(n)].where, points[at(n)].number);
      },
      [&](Index e) {
        return fmt::format("{} (element {})", elements[at(e)].where, elements[at(e)].number);
      }};
  problems.add(mesh::check_geometry(result.mesh, names));
  for (Problem problem : mesh::check_size(result.mesh, smallest_face, largest_face)) {
    problem.where = points_file;
    problem.hint = "coordinates of the reference face's files are in metres";
    problems.add(std::move(problem));
  }
}

}  // namespace

Numbering::Numbering(std::vector<long> numbers) : numbers_(std::move(numbers)) {
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    index_.emplace(numbers_[i], to_index(i));
}

std::optional<Index> Numbering::index(long number) const {
  const auto found = index_.find(number);
  if (found == index_.end()) return std::nullopt;
  return found->second;
}

ReferenceMesh build_reference_mesh(const std::vector<PointRow>& points,
                                   const std::vector<ElementRow>& elements,
                                   const std::string& points_file, Problems& problems) {
  ReferenceMesh result;
  std::vector<long> numbers;
  std::vector<Vec3> X;
  for (const PointRow& point : points) {
    numbers.push_back(point.number);
    X.push_back(point.X);
  }
  result.nodes = Numbering(std::move(numbers));

  ProblemsOfOneKind bad("element list", "elements with unknown or repeated nodes");
  std::vector<Element> made;
  numbers.clear();
  for (const ElementRow& row : elements) {
    numbers.push_back(row.number);
    if (const std::optional<Element> element = make_element(row, result.nodes, bad)) {
      made.push_back(*element);
    }
  }
  result.elements = Numbering(std::move(numbers));
  if (!bad.empty()) {
    bad.move_to(problems);
    return result;
  }

  const mesh::Mesh as_written(X, made);
  for (std::size_t e = 0; e < made.size(); ++e) {
    if (made[e].type == CellType::wedge6) ++result.n_wedges;
    if (mesh::element_volume(as_written, to_index(e), X) >= 0.0) continue;
    made[e] = turned(made[e]);
    ++result.n_turned;
  }
  result.mesh = mesh::Mesh(std::move(X), std::move(made));
  check_mesh(result, points, elements, points_file, problems);
  return result;
}

}  // namespace facies::anatomy
