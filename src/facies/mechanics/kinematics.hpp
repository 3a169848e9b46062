// SPDX-License-Identifier: Apache-2.0
// The isoparametric map of an element.
#pragma once

#include "facies/mesh/mesh.hpp"

namespace facies::mechanics {

/// dX/dxi of the reference configuration [mm], column k the derivative by xi_k.
[[nodiscard]] inline Mat3 isoparametric_jacobian(const mesh::Mesh& mesh,
                                                 const mesh::Element& element,
                                                 const mesh::ShapeGradients& dN_dxi) {
  Mat3 dX_dxi = Mat3::Zero();
  for (std::size_t a = 0; a < element.connectivity().size(); ++a) {
    dX_dxi += mesh.X()[at(element.nodes[a])] * dN_dxi.row(static_cast<Eigen::Index>(a));
  }
  return dX_dxi;
}

}  // namespace facies::mechanics
