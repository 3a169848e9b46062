// SPDX-License-Identifier: Apache-2.0
#include "support/random.hpp"
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "facies/math/tensor.hpp"

namespace facies {
namespace {

TEST(Sym3, AgreesWithFullMatrices) {
  support::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Sym3<double> A = random.right_cauchy_green(0.5);
    const Sym3<double> B = random.direction();
    const Mat3 M = to_matrix(A);
    const Mat3 N = to_matrix(B);
    EXPECT_NEAR(trace(A), M.trace(), 1e-13);
    EXPECT_NEAR(determinant(A), M.determinant(), 1e-12);
    EXPECT_NEAR(double_dot(A, B), (M.array() * N.array()).sum(), 1e-13);
    EXPECT_TRUE(to_matrix(inverse(A)).isApprox(M.inverse(), 1e-12));
    EXPECT_TRUE(to_matrix(A + B).isApprox(M + N, 1e-14));
    EXPECT_TRUE(to_matrix(A - B).isApprox(M - N, 1e-13));
    EXPECT_EQ(to_sym3(M).components(), A.components());
  }
}

TEST(Sym3, HoldsTheRightCauchyGreenTensor) {
  const Mat3 F = support::Random(2).deformation_gradient(0.5);
  EXPECT_TRUE(to_matrix(right_cauchy_green(F)).isApprox(F.transpose() * F, 1e-14));
}

TEST(Sym3, DyadHasTheNormAsTrace) {
  const Vec3 a(1.0, -2.0, 3.0);
  EXPECT_TRUE(to_matrix(dyad(a)).isApprox(a * a.transpose(), 1e-15));
}

TEST(PushForward, GivesTheStressOnTheStretchedArea) {
  // A bar of unit section pulled by S11: force F11 S11 on the area F22 F33.
  const Mat3 F = Vec3(2.0, 0.5, 0.8).asDiagonal();
  const Sym3<double> sigma = push_forward(F, {3.0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(sigma.xx, 2.0 * 3.0 / (0.5 * 0.8), 1e-13);
  EXPECT_EQ(sigma.yy, 0.0);
}

}  // namespace
}  // namespace facies
