// SPDX-License-Identifier: Apache-2.0
// The part of quality.hpp that a person is told about.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "facies/mesh/quality.hpp"

namespace facies::mesh {
namespace {

constexpr std::size_t max_listed = 20;
/// Scaled Jacobian below which an element is flat for all practical purposes.
constexpr double flat = 1e-9;

std::string node_name(const SourceNames& names, std::size_t n) {
  return names.node ? names.node(to_index(n)) : fmt::format("mesh node {}", n);
}

std::string element_name(const SourceNames& names, Index e) {
  return names.element ? names.element(e) : fmt::format("mesh element {}", e);
}

bool is_finite(const Mesh& mesh, const Element& element) {
  return std::ranges::all_of(element.connectivity(),
                             [&](Index node) { return mesh.X()[at(node)].allFinite(); });
}

void check_nodes(const Mesh& mesh, const SourceNames& names, Problems& all) {
  std::vector<bool> used(mesh.n_nodes(), false);
  for (const Element& element : mesh.elements()) {
    for (const Index node : element.connectivity())
      used[at(node)] = true;
  }
  ProblemsOfOneKind infinite("mesh", "nodes without finite coordinates", max_listed);
  ProblemsOfOneKind unused("mesh", "nodes without an element", max_listed);
  for (std::size_t n = 0; n < mesh.n_nodes(); ++n) {
    const Vec3& X = mesh.X()[n];
    if (!X.allFinite()) {
      infinite.add({node_name(names, n), fmt::format("coordinates {}, {}, {}", X(0), X(1), X(2)),
                    "finite numbers", ""});
    }
    if (!used[n]) {
      unused.add({node_name(names, n), "belongs to no element", "at least one element",
                  "remove the node or add the missing element"});
    }
  }
  infinite.move_to(all);
  unused.move_to(all);
}

void check_elements(const Mesh& mesh, const SourceNames& names, Problems& all) {
  ProblemsOfOneKind bad("mesh", "inverted or flat elements", max_listed);
  for (std::size_t i = 0; i < mesh.n_elements(); ++i) {
    const Index e = to_index(i);
    if (!is_finite(mesh, mesh.element(e))) continue;
    const double scaled = element_quality(mesh, e, mesh.X()).scaled_jacobian_gauss;
    if (scaled > flat) continue;
    const std::string_view type = name(mesh.element(e).type);
    bad.add({element_name(names, e),
             fmt::format("{} is {} (scaled Jacobian {:.3g} at a Gauss point)", type,
                         scaled < -flat ? "inverted" : "flat", scaled),
             "a value above 0", "check the order of its nodes and their coordinates"});
  }
  const bool all_bad = mesh.n_elements() > 1 && bad.count() == mesh.n_elements();
  bad.move_to(all);
  if (all_bad) {
    all.add({"mesh", "every element is inverted or flat", "elements with positive volume",
             "the nodes may be numbered left-handed: swap the two ends of each element"});
  }
}

}  // namespace

std::vector<Problem> check_geometry(const Mesh& mesh, const SourceNames& names) {
  Problems all;
  if (mesh.n_elements() == 0) all.add({"mesh", "no element", "at least one element", ""});
  check_nodes(mesh, names, all);
  check_elements(mesh, names, all);
  return all.list();
}

std::vector<Problem> check_size(const Mesh& mesh, double smallest, double largest) {
  if (mesh.n_nodes() == 0) return {};
  Vec3 lower = mesh.X()[0];
  Vec3 upper = lower;
  for (const Vec3& X : mesh.X()) {
    if (!X.allFinite()) return {};
    lower = lower.cwiseMin(X);
    upper = upper.cwiseMax(X);
  }
  const double size = (upper - lower).maxCoeff();
  if (size >= smallest && size <= largest) return {};
  Problem problem{"mesh", fmt::format("{:.6g} mm from end to end", size),
                  fmt::format("{:.6g} to {:.6g} mm", smallest, largest), ""};
  constexpr std::array<std::pair<double, const char*>, 4> units{
      {{1000.0, "metres"}, {10.0, "centimetres"}, {25.4, "inches"}, {0.001, "micrometres"}}};
  for (const auto& [mm, unit] : units) {
    if (problem.hint.empty() && size * mm >= smallest && size * mm <= largest) {
      problem.hint = fmt::format("the coordinates look like {}: multiply them by {}", unit, mm);
    }
  }
  return {problem};
}

}  // namespace facies::mesh
