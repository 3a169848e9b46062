// SPDX-License-Identifier: Apache-2.0
// A rectangular sheet of layers, flat or bulging: the small mesh of examples and tests.
#pragma once

#include <string>
#include <vector>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {

enum class SheetShape : std::uint8_t {
  flat,
  cylinder,  ///< bulges about an axis along z
  sphere,    ///< bulges both ways
};

/// Which columns of the sheet are hexahedra; every other column is cut into two wedges.
enum class SheetCells : std::uint8_t {
  hexahedra,
  wedges,
  checkerboard,
  right_half_wedges,  ///< wedges where y > 0 (the subject's right)
};

struct SheetLayer {
  std::string name;        ///< of the element set
  double thickness = 1.0;  ///< [mm]
  int n_elements = 1;      ///< over the thickness
};

struct SheetOptions {
  double size_y = 40.0;  ///< width along the outer surface [mm]
  double size_z = 40.0;  ///< height along the outer surface [mm]
  int n_y = 8;
  int n_z = 8;
  /// Outermost first.
  std::vector<SheetLayer> layers = {
      {"skin", 1.5, 1}, {"hypodermis_mid", 5.0, 1}, {"hypodermis_inner", 5.0, 1}};
  SheetShape shape = SheetShape::flat;
  double radius = 80.0;  ///< of the outer surface of a cylinder or sphere [mm]
  SheetCells cells = SheetCells::hexahedra;
};

/// The sheet in face axes: its outer surface looks towards -x and touches the origin with its middle, +y is the subject's
/// right, +z up. Layers follow each other towards +x. The parameter lines of a sphere are those of an equiangular cube face.
///
/// Every element has its zeta direction outwards (local face 1 looks out, 0 in). Elements and nodes are numbered from the
/// outside in, then along y, then along z.
/// Sets: elements by layer name; faces outer, inner; nodes outer, inner, y_min, y_max, z_min, z_max and rim (these four).
/// Throws DataError with every option that makes no sense.
[[nodiscard]] Mesh make_layered_sheet(const SheetOptions& options);

}  // namespace facies::mesh
