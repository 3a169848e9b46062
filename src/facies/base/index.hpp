// SPDX-License-Identifier: Apache-2.0
// Numbering inside facies: 0-based and contiguous. Numbers of files (1-based, gaps allowed) never leave the readers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace facies {

/// A node, element, face, muscle ... of its list. Negative values never name anything.
using Index = std::int32_t;

/// The index as a position in a standard container.
constexpr std::size_t at(Index index) {
  return static_cast<std::size_t>(index);
}

/// The position in a standard container as an index.
constexpr Index to_index(std::size_t position) {
  return static_cast<Index>(position);
}

}  // namespace facies
