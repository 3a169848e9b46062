// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/colouring.hpp"

namespace facies::mechanics {

std::vector<std::vector<Index>> colour_elements(const mesh::Mesh& mesh) {
  std::vector<std::vector<Index>> colours;
  std::vector<std::vector<bool>> node_taken;  // [colour][node]
  for (Index e = 0; e < to_index(mesh.n_elements()); ++e) {
    const std::span<const Index> nodes = mesh.element(e).connectivity();
    std::size_t colour = 0;
    const auto is_free = [&](std::size_t c) {
      for (const Index node : nodes) {
        if (node_taken[c][at(node)]) return false;
      }
      return true;
    };
    while (colour < colours.size() && !is_free(colour))
      ++colour;
    if (colour == colours.size()) {
      colours.emplace_back();
      node_taken.emplace_back(mesh.n_nodes(), false);
    }
    colours[colour].push_back(e);
    for (const Index node : nodes)
      node_taken[colour][at(node)] = true;
  }
  return colours;
}

}  // namespace facies::mechanics
