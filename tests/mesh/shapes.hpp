// SPDX-License-Identifier: Apache-2.0
// Small meshes with known geometry.
#pragma once

#include <utility>
#include <vector>

#include "support/random.hpp"

#include "facies/mesh/layered_sheet.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

/// One element with its nodes at their local coordinates, mapped by x -> A x + b.
inline Mesh single_element(CellType type, const Mat3& A = Mat3::Identity(),
                           const Vec3& b = Vec3::Zero()) {
  std::vector<Vec3> X;
  Element element;
  element.type = type;
  for (std::size_t i = 0; i < n_nodes(type); ++i) {
    X.emplace_back(A * node_xi(type, i) + b);
    element.nodes[i] = to_index(i);
  }
  return {std::move(X), {element}};
}

/// A copy of the mesh with other node positions and without sets.
inline Mesh with_positions(const Mesh& mesh, std::vector<Vec3> X) {
  return {std::move(X), {mesh.elements().begin(), mesh.elements().end()}};
}

/// A checkerboard of hexahedra and wedges, 4 x 3 x 2 columns cells of 1 mm, every node moved by up to `shake` mm.
inline Mesh shaken_checkerboard(double shake) {
  SheetOptions options;
  options.size_y = 4.0;
  options.size_z = 3.0;
  options.n_y = 4;
  options.n_z = 3;
  options.layers = {{"skin", 1.0, 1}, {"hypodermis", 1.0, 1}};
  options.cells = SheetCells::checkerboard;
  const Mesh mesh = make_layered_sheet(options);
  support::Random random(7);
  std::vector<Vec3> X(mesh.X().begin(), mesh.X().end());
  for (Vec3& x : X)
    x += random.vector(-shake, shake);
  return with_positions(mesh, std::move(X));
}

}  // namespace facies::mesh
