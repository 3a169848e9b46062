// SPDX-License-Identifier: Apache-2.0
// Steps that were taken correct an inverse stiffness that has gone stale.
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/solve/secant.hpp"

namespace facies::solve {
namespace {

constexpr int n = 6;
using Vector = Eigen::Matrix<double, n, 1>;
using Matrix = Eigen::Matrix<double, n, n>;

std::vector<double> copy(const Vector& v) {
  return {v.data(), v.data() + n};
}

class Secant : public ::testing::Test {
 protected:
  Vector random_vector() {
    return Vector::NullaryExpr([&](Eigen::Index) { return random_.uniform(-1.0, 1.0); });
  }

  /// Symmetric, positive definite.
  Matrix random_stiffness() {
    const Matrix A =
        Matrix::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random_.uniform(-1.0, 1.0); });
    return A * A.transpose() + Matrix::Identity();
  }

  [[nodiscard]] Vector solve(const Vector& rhs) const {
    Vector x;
    pairs_.solve({rhs.data(), n},
                 [&](std::span<const double> b, std::span<double> y) {
                   const Eigen::Map<const Vector> right(b.data());
                   Eigen::Map<Vector>(y.data()) = stale_.llt().solve(right);
                 },
                 {x.data(), n});
    return x;
  }

  /// H, column by column.
  [[nodiscard]] Matrix inverse() const {
    Matrix H;
    for (int k = 0; k < n; ++k)
      H.col(k) = solve(Vector::Unit(k));
    return H;
  }

  support::Random random_{17};
  Matrix stale_ = random_stiffness();
  Matrix K_ = random_stiffness();
  SecantPairs pairs_{3};
};

TEST_F(Secant, WithoutAnyStepIsTheFactor) {
  const Vector b = random_vector();
  EXPECT_TRUE(solve(b).isApprox(stale_.llt().solve(b), 1e-12));
}

TEST_F(Secant, AnswersTheLastChangeOfResidualWithTheLastStep) {
  for (int k = 0; k < 5; ++k) {
    const Vector step = random_vector();
    const Vector change = K_ * step;
    pairs_.learn(copy(step), copy(change));
    EXPECT_TRUE(solve(change).isApprox(step, 1e-10)) << "step " << k;
  }
}

TEST_F(Secant, StaysSymmetricAndPositiveDefinite) {
  for (int k = 0; k < 5; ++k) {
    const Vector step = random_vector();
    pairs_.learn(copy(step), copy(K_ * step));
  }
  const Matrix H = inverse();
  EXPECT_TRUE(H.isApprox(H.transpose(), 1e-10));
  EXPECT_EQ(Eigen::LLT<Matrix>(H).info(), Eigen::Success);
}

TEST_F(Secant, IsTheFormulaOfBroydenFletcherGoldfarbAndShanno) {
  const Vector s = random_vector();
  const Vector y = K_ * s;
  pairs_.learn(copy(s), copy(y));
  const Matrix V = Matrix::Identity() - y * s.transpose() / s.dot(y);
  const Matrix expected = V.transpose() * stale_.inverse() * V + s * s.transpose() / s.dot(y);
  EXPECT_TRUE(inverse().isApprox(expected, 1e-10));
}

TEST_F(Secant, PassesByAStepAlongWhichTheResidualsWorkFell) {
  const Vector step = random_vector();
  pairs_.learn(copy(step), copy(-(K_ * step)));
  EXPECT_TRUE(inverse().isApprox(stale_.inverse(), 1e-10));
}

TEST_F(Secant, ForgetsTheOldestAndAllOfThem) {
  const Vector oldest = random_vector();
  pairs_.learn(copy(oldest), copy(K_ * oldest));
  SecantPairs others{3};
  std::swap(others, pairs_);
  for (int k = 0; k < 3; ++k) {
    const Vector step = random_vector();
    pairs_.learn(copy(step), copy(K_ * step));
    others.learn(copy(step), copy(K_ * step));
  }
  const Matrix of_three = inverse();
  std::swap(others, pairs_);
  EXPECT_TRUE(inverse().isApprox(of_three, 1e-12));
  pairs_.forget();
  EXPECT_TRUE(inverse().isApprox(stale_.inverse(), 1e-10));
}

}  // namespace
}  // namespace facies::solve
