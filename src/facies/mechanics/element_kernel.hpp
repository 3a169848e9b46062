// SPDX-License-Identifier: Apache-2.0
// The mechanics of one element with mean dilatation, free of meshes, files and threads.
//
// Energy: W = sum over points of psi(C_bar) dV0 + V0 U(J_mean), J_mean = v / V0 with the deformed volume v.
// Its first and second derivatives by the nodal positions are the residual and the tangent (docs/theory/element.md).
// Both element types run through the same code: a wedge has two nodes without shape functions.
#pragma once

#include <span>

#include "facies/material/tissue.hpp"

namespace facies::mechanics {

/// Nodal positions or forces, one column per node.
using NodeColumns = Eigen::Matrix<double, 3, 8>;
/// Element tangent: unknown 3*node + axis.
using ElementMatrix = Eigen::Matrix<double, 24, 24>;

/// A quadrature point in the stress-free configuration.
struct ElementPoint {
  Eigen::Matrix<double, 8, 3>
      G;             ///< gradients of the shape functions in the stress-free configuration [1/mm]
  double dV0 = 0.0;  ///< stress-free volume that the point stands for [mm^3]
};

/// An element at a moment: its points, material and active fibres.
struct ElementView {
  std::span<const ElementPoint> points;
  double V0 = 0.0;  ///< stress-free volume [mm^3]
  const material::Law* law = nullptr;
  const material::VolumetricLaw* volumetric = nullptr;
  std::span<const material::Fibre> fibres;
};

/// Smallest det F over the quadrature points; energy, residual and tangent need it to be positive.
[[nodiscard]] double smallest_jacobian(const ElementView& element, const NodeColumns& x);

/// W [uJ]; +infinity where det F is not positive somewhere.
[[nodiscard]] double element_energy(const ElementView& element, const NodeColumns& x);

/// dW/dx [mN].
[[nodiscard]] NodeColumns element_residual(const ElementView& element, const NodeColumns& x);

/// d2W/dx2 [mN/mm], symmetric.
void element_tangent(const ElementView& element, const NodeColumns& x, ElementMatrix& K);

/// Cauchy stress averaged over the deformed element [kPa] and v / V0.
struct ElementMeans {
  Sym3<double> sigma;
  double J = 1.0;
};
[[nodiscard]] ElementMeans element_means(const ElementView& element, const NodeColumns& x);

}  // namespace facies::mechanics
