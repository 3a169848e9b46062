// SPDX-License-Identifier: Apache-2.0
// Groups of elements that share no node, so that threads may add to nodes without meeting.
#pragma once

#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mechanics {

/// Elements by colour: two elements of one colour share no node. Working colour after colour, every node receives its
/// elements' contributions in the same order for any number of threads, so sums have the same bits.
[[nodiscard]] std::vector<std::vector<Index>> colour_elements(const mesh::Mesh& mesh);

}  // namespace facies::mechanics
