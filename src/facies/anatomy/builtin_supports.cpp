// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_supports.hpp"

#include <map>
#include <set>

namespace facies::anatomy {
namespace {

/// Vertices of the longest border of a net: around the face, the others being around eyes, nostrils and the mouth.
std::vector<Index> longest_border(const mesh::QuadNet& net) {
  std::map<Index, std::vector<Index>> along;
  for (const auto& [edge, quads] : mesh::edges_of(net)) {
    if (quads.size() != 1) continue;
    along[edge.first].push_back(edge.second);
    along[edge.second].push_back(edge.first);
  }
  std::vector<Index> longest;
  std::set<Index> seen;
  for (const auto& [start, unused] : along) {
    if (!seen.insert(start).second) continue;
    std::vector<Index> border{start};
    for (std::size_t i = 0; i < border.size(); ++i) {
      for (const Index v : along.at(border[i])) {
        if (seen.insert(v).second) border.push_back(v);
      }
    }
    if (border.size() > longest.size()) longest = std::move(border);
  }
  return longest;
}

/// A vertex near drawn points belongs to their region where so much of its place comes from them: about half way to points that do
/// not.
constexpr double belongs = 0.45;

}  // namespace

void set_supports(const Drawings& drawings, BuiltinTissue& tissue) {
  const mesh::QuadNet& net = tissue.limit.net;
  std::vector<Index> rim;
  for (const Index v : longest_border(net)) {
    for (int depth = 0; depth <= tissue.n_deep; ++depth)
      rim.push_back(mesh::shell_node(net, v, depth));
  }
  std::vector<Index> held = rim;
  const std::span<const Index> inner = tissue.mesh.nodes("inner");
  held.insert(held.end(), inner.begin(), inner.end());
  std::set<Index> taken(rim.begin(), rim.end());
  tissue.mesh.set_nodes("rim", std::move(rim));
  tissue.mesh.set_nodes("held_in_tension", std::move(held));
  for (const auto& [name, points] : drawings.regions) {
    std::vector<double> is_in(drawings.skin.points.size(), 0.0);
    for (const Index point : points)
      is_in[at(point)] = 1.0;
    const std::vector<double> how_much = mesh::weighted(tissue.limit.limit, is_in);
    std::vector<Index> nodes;
    for (std::size_t v = 0; v < how_much.size(); ++v) {
      const Index node = mesh::shell_node(net, to_index(v), tissue.n_deep);
      if (how_much[v] > belongs && taken.insert(node).second) nodes.push_back(node);
    }
    tissue.mesh.set_nodes(name, std::move(nodes));
  }
}

}  // namespace facies::anatomy
