// SPDX-License-Identifier: Apache-2.0
// Blocks of hexahedra, wedges or both, regular or distorted: what patch tests and convergence tests are made on.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hpp"

#include "facies/mesh/mesh.hpp"

namespace facies::support {

enum class BlockCells : std::uint8_t {
  hexahedra,
  wedges,  ///< every cell cut in two, along diagonals that alternate
  mixed,   ///< columns of hexahedra and of wedges like a checkerboard
};

/// The name of a test that runs on such a block.
inline std::string name_of(BlockCells cells) {
  switch (cells) {
    case BlockCells::hexahedra:
      return "hexahedra";
    case BlockCells::wedges:
      return "wedges";
    case BlockCells::mixed:
      break;
  }
  return "mixed";
}

struct BlockOptions {
  Vec3 size = Vec3::Ones();          ///< from the origin to this corner [mm]
  std::array<int, 3> n = {2, 2, 2};  ///< cells along x, y, z
  BlockCells cells = BlockCells::hexahedra;
  double shake =
      0.0;  ///< nodes move at random by up to this part of a cell; those on a side stay on it
};

namespace block_detail {

inline const std::array<std::string, 3> axis_names = {"x", "y", "z"};

struct Builder {
  const BlockOptions& options;

  [[nodiscard]] Index node(int i, int j, int k) const {
    return i + (options.n[0] + 1) * (j + (options.n[1] + 1) * k);
  }

  /// Calls visit(node, i, j, k) in the order of the nodes.
  template <class Visit>
  void for_each_node(const Visit& visit) const {
    for (int k = 0; k <= options.n[2]; ++k) {
      for (int j = 0; j <= options.n[1]; ++j) {
        for (int i = 0; i <= options.n[0]; ++i)
          visit(node(i, j, k), std::array<int, 3>{i, j, k});
      }
    }
  }

  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> X;
    Random random(11);
    for_each_node([&](Index, const std::array<int, 3>& place) {
      const Vec3 move = random.vector(-options.shake, options.shake);
      Vec3 position;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool on_side = place[axis] == 0 || place[axis] == options.n[axis];
        const auto a = static_cast<Eigen::Index>(axis);
        position(a) = options.size(a) * (place[axis] + (on_side ? 0.0 : move(a))) / options.n[axis];
      }
      X.push_back(position);
    });
    return X;
  }

  void add_cell(int i, int j, int k, std::vector<mesh::Element>& elements) const {
    using mesh::CellType;
    const std::array<Index, 4> a{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                                 node(i, j + 1, k)};
    const std::array<Index, 4> b{node(i, j, k + 1), node(i + 1, j, k + 1),
                                 node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
    const bool odd = (i + j) % 2 == 1;
    if (options.cells == BlockCells::hexahedra || (options.cells == BlockCells::mixed && !odd)) {
      elements.push_back({CellType::hex8, {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]}});
      return;
    }
    const std::size_t s = (i + j / 2) % 2 == 0 ? 0 : 1;  // the diagonal starts at corner s
    const std::size_t t = (s + 3) % 4;
    elements.push_back(
        {CellType::wedge6, {a[s], a[s + 1], a[s + 2], b[s], b[s + 1], b[s + 2], -1, -1}});
    elements.push_back({CellType::wedge6, {a[s], a[s + 2], a[t], b[s], b[s + 2], b[t], -1, -1}});
  }

  void set_nodes(mesh::Mesh& mesh) const {
    std::vector<Index> boundary;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<Index> low;
      std::vector<Index> high;
      for_each_node([&](Index number, const std::array<int, 3>& place) {
        if (place[axis] == 0) low.push_back(number);
        if (place[axis] == options.n[axis]) high.push_back(number);
      });
      boundary.insert(boundary.end(), low.begin(), low.end());
      boundary.insert(boundary.end(), high.begin(), high.end());
      mesh.set_nodes(axis_names[axis] + "_min", std::move(low));
      mesh.set_nodes(axis_names[axis] + "_max", std::move(high));
    }
    mesh.set_nodes("boundary", std::move(boundary));
  }
};

}  // namespace block_detail

/// The block with the node sets x_min, x_max, y_min ... and boundary (all of them). The triangles of wedges lie across z.
inline mesh::Mesh make_block(const BlockOptions& options) {
  const block_detail::Builder builder{options};
  std::vector<mesh::Element> elements;
  for (int k = 0; k < options.n[2]; ++k) {
    for (int j = 0; j < options.n[1]; ++j) {
      for (int i = 0; i < options.n[0]; ++i)
        builder.add_cell(i, j, k, elements);
    }
  }
  mesh::Mesh mesh(builder.positions(), std::move(elements));
  builder.set_nodes(mesh);
  return mesh;
}

/// A copy of the mesh, node sets included, with every node moved to where `map` says.
inline mesh::Mesh mapped(const mesh::Mesh& original, const std::function<Vec3(const Vec3&)>& map) {
  std::vector<Vec3> X;
  X.reserve(original.n_nodes());
  for (const Vec3& x : original.X())
    X.push_back(map(x));
  mesh::Mesh mesh(std::move(X), {original.elements().begin(), original.elements().end()});
  for (const auto& [name, nodes] : original.node_sets())
    mesh.set_nodes(name, nodes);
  return mesh;
}

}  // namespace facies::support
