// SPDX-License-Identifier: Apache-2.0
#include "support/random.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/math/voigt.hpp"

namespace facies {
namespace {

TEST(Voigt, StressTimesStrainIsTheDoubleDot) {
  support::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Sym3<double> S = random.direction();
    const Sym3<double> E = random.direction();
    EXPECT_NEAR(stress_voigt(S).dot(strain_voigt(E)), double_dot(S, E), 1e-15);
  }
}

TEST(Voigt, ComesBackFromVectors) {
  const Sym3<double> A = support::Random(2).direction();
  EXPECT_EQ(from_stress_voigt(stress_voigt(A)).components(), A.components());
  EXPECT_EQ(from_strain_voigt(strain_voigt(A)).components(), A.components());
}

TEST(Voigt, SymmetricIdentityMapsATensorToItself) {
  const Sym3<double> A = support::Random(3).direction();
  EXPECT_TRUE((symmetric_identity() * strain_voigt(A)).isApprox(stress_voigt(A), 1e-15));
  EXPECT_EQ(identity_voigt(), stress_voigt(identity_sym3()));
}

TEST(Voigt, SymmetricSquareOfTheIdentityIsTheIdentity) {
  EXPECT_TRUE(symmetric_square(identity_sym3()).isApprox(symmetric_identity(), 1e-15));
}

TEST(Voigt, SymmetricSquareSandwiches) {
  support::Random random(4);
  const Sym3<double> A = random.right_cauchy_green(0.5);
  const Sym3<double> B = random.direction();
  const Sym3<double> ABA = to_sym3(to_matrix(A) * to_matrix(B) * to_matrix(A));
  EXPECT_TRUE((symmetric_square(A) * strain_voigt(B)).isApprox(stress_voigt(ABA), 1e-14));
}

TEST(Voigt, SymmetricSquareOfTheInverseIsMinusItsDerivative) {
  support::Random random(5);
  for (int i = 0; i < 10; ++i) {
    const Sym3<double> C = random.right_cauchy_green(0.4);
    const Sym3<double> dC = random.direction();
    const StressVoigt derivative = -symmetric_square(inverse(C)) * strain_voigt(dC);
    const auto f = [&](double h) -> Eigen::VectorXd {
      return stress_voigt(inverse(C + scaled(dC, h)));
    };
    EXPECT_GE(support::remainder_slope(f, derivative), 1.9);
  }
}

TEST(Voigt, StrainRotationIsTheChangeOfFrame) {
  support::Random random(6);
  const Mat3 R = random.rotation();
  const Sym3<double> E = random.direction();
  const Sym3<double> seen = to_sym3(R.transpose() * to_matrix(E) * R);
  EXPECT_TRUE((strain_rotation(R) * strain_voigt(E)).isApprox(strain_voigt(seen), 1e-14));
}

TEST(Voigt, TensorDerivativesAreThoseOfTheComponents) {
  // f = 1/2 A : A has df/dA = A and d2f/dA dA = symmetric identity. By components the shears count twice.
  const Sym3<double> A = support::Random(7).direction();
  EXPECT_TRUE(tensor_gradient(strain_voigt(A)).isApprox(stress_voigt(A), 1e-15));
  const Mat6 by_components = StressVoigt(1, 1, 1, 2, 2, 2).asDiagonal();
  EXPECT_TRUE(tensor_hessian(by_components).isApprox(symmetric_identity(), 1e-15));
}

}  // namespace
}  // namespace facies
