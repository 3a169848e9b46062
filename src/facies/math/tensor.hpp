// SPDX-License-Identifier: Apache-2.0
// 3-vectors, 3x3 matrices and symmetric tensors of mechanics.
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

namespace facies {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Symmetric second-order tensor: its six tensor components in the order xx yy zz xy yz xz (that of VTK files).
template <class T>
struct Sym3 {
  T xx{}, yy{}, zz{}, xy{}, yz{}, xz{};

  [[nodiscard]] std::array<T, 6> components() const { return {xx, yy, zz, xy, yz, xz}; }
};

template <class T>
[[nodiscard]] T trace(const Sym3<T>& A) {
  return A.xx + A.yy + A.zz;
}

template <class T>
[[nodiscard]] T determinant(const Sym3<T>& A) {
  return A.xx * (A.yy * A.zz - A.yz * A.yz) - A.xy * (A.xy * A.zz - A.yz * A.xz) +
         A.xz * (A.xy * A.yz - A.yy * A.xz);
}

/// A:B, the sum over all nine component products.
template <class T, class U>
[[nodiscard]] T double_dot(const Sym3<T>& A, const Sym3<U>& B) {
  return A.xx * B.xx + A.yy * B.yy + A.zz * B.zz + 2.0 * (A.xy * B.xy + A.yz * B.yz + A.xz * B.xz);
}

/// Inverse of a tensor whose determinant is not zero.
[[nodiscard]] inline Sym3<double> inverse(const Sym3<double>& A) {
  const double d = 1.0 / determinant(A);
  return {d * (A.yy * A.zz - A.yz * A.yz), d * (A.xx * A.zz - A.xz * A.xz),
          d * (A.xx * A.yy - A.xy * A.xy), d * (A.xz * A.yz - A.xy * A.zz),
          d * (A.xy * A.xz - A.xx * A.yz), d * (A.xy * A.yz - A.xz * A.yy)};
}

[[nodiscard]] inline Sym3<double> scaled(const Sym3<double>& A, double factor) {
  return {factor * A.xx, factor * A.yy, factor * A.zz, factor * A.xy, factor * A.yz, factor * A.xz};
}

[[nodiscard]] inline Sym3<double> operator+(const Sym3<double>& A, const Sym3<double>& B) {
  return {A.xx + B.xx, A.yy + B.yy, A.zz + B.zz, A.xy + B.xy, A.yz + B.yz, A.xz + B.xz};
}

[[nodiscard]] inline Sym3<double> operator-(const Sym3<double>& A, const Sym3<double>& B) {
  return A + scaled(B, -1.0);
}

[[nodiscard]] inline Sym3<double> identity_sym3() {
  return {1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
}

/// Right Cauchy-Green tensor C = F^T F.
[[nodiscard]] inline Sym3<double> right_cauchy_green(const Mat3& F) {
  return {F.col(0).squaredNorm(), F.col(1).squaredNorm(), F.col(2).squaredNorm(),
          F.col(0).dot(F.col(1)), F.col(1).dot(F.col(2)), F.col(0).dot(F.col(2))};
}

/// a (x) a.
[[nodiscard]] inline Sym3<double> dyad(const Vec3& a) {
  return {a.x() * a.x(), a.y() * a.y(), a.z() * a.z(), a.x() * a.y(), a.y() * a.z(), a.x() * a.z()};
}

[[nodiscard]] inline Mat3 to_matrix(const Sym3<double>& A) {
  Mat3 M;
  M << A.xx, A.xy, A.xz, A.xy, A.yy, A.yz, A.xz, A.yz, A.zz;
  return M;
}

/// The symmetric part of M.
[[nodiscard]] inline Sym3<double> to_sym3(const Mat3& M) {
  return {M(0, 0),
          M(1, 1),
          M(2, 2),
          0.5 * (M(0, 1) + M(1, 0)),
          0.5 * (M(1, 2) + M(2, 1)),
          0.5 * (M(0, 2) + M(2, 0))};
}

/// Cauchy stress sigma = F S F^T / det F [kPa] from the second Piola-Kirchhoff stress S [kPa].
[[nodiscard]] inline Sym3<double> push_forward(const Mat3& F, const Sym3<double>& S) {
  return to_sym3(F * to_matrix(S) * F.transpose() / F.determinant());
}

}  // namespace facies
