// SPDX-License-Identifier: Apache-2.0
#include "facies/math/voigt.hpp"

namespace facies {

namespace {

/// An off-diagonal component of a symmetric tensor stands for two equal entries: each gets half of the derivative.
StressVoigt share_of_entry() {
  return {1.0, 1.0, 1.0, 0.5, 0.5, 0.5};
}

}  // namespace

Mat6 strain_rotation(const Mat3& R) {
  Mat6 Q;
  for (int J = 0; J < 6; ++J) {
    const Mat3 E = to_matrix(from_strain_voigt(StrainVoigt::Unit(J)));
    Q.col(J) = strain_voigt(to_sym3(R.transpose() * E * R));
  }
  return Q;
}

StressVoigt tensor_gradient(const Eigen::Matrix<double, 6, 1>& by_components) {
  return share_of_entry().cwiseProduct(by_components);
}

Mat6 tensor_hessian(const Mat6& by_components) {
  return share_of_entry().asDiagonal() * by_components * share_of_entry().asDiagonal();
}

Mat6 symmetric_square(const Sym3<double>& A) {
  Mat6 B;
  B(0, 0) = A.xx * A.xx;
  B(1, 1) = A.yy * A.yy;
  B(2, 2) = A.zz * A.zz;
  B(3, 3) = 0.5 * (A.xx * A.yy + A.xy * A.xy);
  B(4, 4) = 0.5 * (A.yy * A.zz + A.yz * A.yz);
  B(5, 5) = 0.5 * (A.xx * A.zz + A.xz * A.xz);
  B(1, 0) = B(0, 1) = A.xy * A.xy;
  B(2, 0) = B(0, 2) = A.xz * A.xz;
  B(2, 1) = B(1, 2) = A.yz * A.yz;
  B(3, 0) = B(0, 3) = A.xx * A.xy;
  B(4, 0) = B(0, 4) = A.xy * A.xz;
  B(5, 0) = B(0, 5) = A.xx * A.xz;
  B(3, 1) = B(1, 3) = A.xy * A.yy;
  B(4, 1) = B(1, 4) = A.yy * A.yz;
  B(5, 1) = B(1, 5) = A.xy * A.yz;
  B(3, 2) = B(2, 3) = A.xz * A.yz;
  B(4, 2) = B(2, 4) = A.yz * A.zz;
  B(5, 2) = B(2, 5) = A.xz * A.zz;
  B(4, 3) = B(3, 4) = 0.5 * (A.xy * A.yz + A.xz * A.yy);
  B(5, 3) = B(3, 5) = 0.5 * (A.xx * A.yz + A.xz * A.xy);
  B(5, 4) = B(4, 5) = 0.5 * (A.xy * A.zz + A.yz * A.xz);
  return B;
}

}  // namespace facies
