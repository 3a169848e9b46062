// SPDX-License-Identifier: Apache-2.0
// The one place that knows how symmetric tensors become vectors of six and where a factor of two belongs.
//
// Order: xx yy zz xy yz xz. A stress vector holds tensor components; a strain vector holds doubled shears, so that
// S:E = S_v . E_v and dS_v = C4 dE_v, where C4(I,J) is the tensor component C4_ijkl with ij of I and kl of J.
#pragma once

#include "facies/math/tensor.hpp"

namespace facies {

/// Stress-like vector: tensor components.
using StressVoigt = Eigen::Matrix<double, 6, 1>;
/// Strain-like vector: shear components doubled.
using StrainVoigt = Eigen::Matrix<double, 6, 1>;
/// Fourth-order tensor with minor symmetries: tensor components.
using Mat6 = Eigen::Matrix<double, 6, 6>;

[[nodiscard]] inline StressVoigt stress_voigt(const Sym3<double>& S) {
  StressVoigt v;
  v << S.xx, S.yy, S.zz, S.xy, S.yz, S.xz;
  return v;
}

[[nodiscard]] inline StrainVoigt strain_voigt(const Sym3<double>& E) {
  StrainVoigt v;
  v << E.xx, E.yy, E.zz, 2.0 * E.xy, 2.0 * E.yz, 2.0 * E.xz;
  return v;
}

[[nodiscard]] inline Sym3<double> from_stress_voigt(const StressVoigt& v) {
  return {v(0), v(1), v(2), v(3), v(4), v(5)};
}

[[nodiscard]] inline Sym3<double> from_strain_voigt(const StrainVoigt& v) {
  return {v(0), v(1), v(2), 0.5 * v(3), 0.5 * v(4), 0.5 * v(5)};
}

/// The six components of I, as a stress vector and as a strain vector alike.
[[nodiscard]] inline StressVoigt identity_voigt() {
  return {1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
}

/// The fourth-order identity on symmetric tensors, (d_ik d_jl + d_il d_jk) / 2.
[[nodiscard]] inline Mat6 symmetric_identity() {
  return StressVoigt(1.0, 1.0, 1.0, 0.5, 0.5, 0.5).asDiagonal();
}

/// The matrix Q with strain_voigt(R^T E R) = Q strain_voigt(E): strain seen from the orthonormal columns of R.
/// A fourth-order tensor with components D in that frame has the components Q^T D Q.
[[nodiscard]] Mat6 strain_rotation(const Mat3& R);

/// df/dA as a stress vector from the derivatives of f by the six stored components of A.
[[nodiscard]] StressVoigt tensor_gradient(const Eigen::Matrix<double, 6, 1>& by_components);

/// d2f/dA dA from the second derivatives of f by the six stored components of A.
[[nodiscard]] Mat6 tensor_hessian(const Mat6& by_components);

/// A (.) A: the components (A_ik A_jl + A_il A_jk) / 2. With A = C^-1 this is minus dC^-1/dC.
[[nodiscard]] Mat6 symmetric_square(const Sym3<double>& A);

}  // namespace facies
