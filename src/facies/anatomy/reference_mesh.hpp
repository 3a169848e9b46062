// SPDX-License-Identifier: Apache-2.0
// From the rows of the reference face's files to a mesh, and from their numbers to ours.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facies/anatomy/artisynth_files.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::anatomy {

/// Numbers of nodes or elements in a file, each at its index.
class Numbering {
 public:
  Numbering() = default;
  explicit Numbering(std::vector<long> numbers);

  [[nodiscard]] std::optional<Index> index(long number) const;
  [[nodiscard]] long number(Index index) const { return numbers_.at(at(index)); }
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

 private:
  std::vector<long> numbers_;
  std::map<long, Index> index_;
};

struct ReferenceMesh {
  mesh::Mesh mesh;  ///< without sets
  Numbering nodes;
  Numbering elements;
  std::size_t n_turned = 0;  ///< elements that are left-handed in the file
  std::size_t n_wedges = 0;
};

/// The mesh, every element with positive volume. Eight nodes a b c c d e f f make a wedge (a b c | d e f); a left-handed
/// hexahedron is turned to (1 4 3 2 | 5 8 7 6), a left-handed wedge likewise. Adds to `problems` unknown and repeated
/// nodes, elements that are flat or inverted all the same, nodes without an element, a face that is not 50 to 500 mm
/// large; the mesh is then not to be used.
/// `points` and `elements` must not be empty; `points_file` is named in messages about the whole.
[[nodiscard]] ReferenceMesh build_reference_mesh(const std::vector<PointRow>& points,
                                                 const std::vector<ElementRow>& elements,
                                                 const std::string& points_file,
                                                 Problems& problems);

}  // namespace facies::anatomy
