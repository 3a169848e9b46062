// SPDX-License-Identifier: Apache-2.0
// A mesh of linear hexahedra and wedges with named sets of nodes, elements and faces.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "facies/base/error.hpp"
#include "facies/mesh/cells.hpp"

namespace facies::mesh {

/// One element: its type and its nodes in the order of cells.hpp. Entries beyond n_nodes(type) are -1.
struct Element {
  CellType type = CellType::hex8;
  std::array<Index, max_nodes> nodes{-1, -1, -1, -1, -1, -1, -1, -1};

  [[nodiscard]] std::span<const Index> connectivity() const {
    return {nodes.data(), n_nodes(type)};
  }
};

/// A face of an element: `local` counts within faces(type).
struct Face {
  Index element = -1;
  std::uint8_t local = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
  friend auto operator<=>(const Face&, const Face&) = default;
};

/// Reference positions, elements and named sets. A value; checked at construction.
class Mesh {
 public:
  Mesh() = default;

  /// Throws DataError where an element names a node that does not exist or the same node twice.
  Mesh(std::vector<Vec3> X, std::vector<Element> elements);

  [[nodiscard]] std::size_t n_nodes() const { return X_.size(); }
  [[nodiscard]] std::size_t n_elements() const { return elements_.size(); }
  /// Reference positions [n_nodes] [mm].
  [[nodiscard]] std::span<const Vec3> X() const { return X_; }
  [[nodiscard]] std::span<const Element> elements() const { return elements_; }
  [[nodiscard]] const Element& element(Index e) const { return elements_[at(e)]; }

  /// Node numbers of a face, counter-clockwise seen from outside (3 or 4).
  [[nodiscard]] std::vector<Index> face_nodes(Face face) const;

  /// Mean of the element's node positions [mm] (the "centroid" of the reference program's muscle selection).
  [[nodiscard]] Vec3 centroid(Index e) const;

  /// Sets are sorted and free of repetitions. Setting one replaces it; members must exist (BugError).
  void set_nodes(const std::string& name, std::vector<Index> nodes);
  void set_elements(const std::string& name, std::vector<Index> elements);
  void set_faces(const std::string& name, std::vector<Face> faces);

  /// The set of that name; an empty one where there is none.
  [[nodiscard]] std::span<const Index> nodes(const std::string& name) const;
  [[nodiscard]] std::span<const Index> elements(const std::string& name) const;
  [[nodiscard]] std::span<const Face> faces(const std::string& name) const;

  [[nodiscard]] const std::map<std::string, std::vector<Index>>& node_sets() const {
    return node_sets_;
  }
  [[nodiscard]] const std::map<std::string, std::vector<Index>>& element_sets() const {
    return element_sets_;
  }
  [[nodiscard]] const std::map<std::string, std::vector<Face>>& face_sets() const {
    return face_sets_;
  }

 private:
  std::vector<Vec3> X_;
  std::vector<Element> elements_;
  std::map<std::string, std::vector<Index>> node_sets_;
  std::map<std::string, std::vector<Index>> element_sets_;
  std::map<std::string, std::vector<Face>> face_sets_;
};

}  // namespace facies::mesh
