// SPDX-License-Identifier: Apache-2.0
// The factorisation on matrices small enough to know everything about.
#include <algorithm>
#include <cmath>

#include "support/dense.hpp"
#include "support/random.hpp"
#include "support/session.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/solve/factor.hpp"

namespace facies::solve {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SparsityPattern full_pattern(Index n) {
  SparsityPattern pattern{{0}, {}};
  for (Index row = 0; row < n; ++row) {
    for (Index column = row; column < n; ++column)
      pattern.column.push_back(column);
    pattern.row_begin.push_back(to_index(pattern.column.size()));
  }
  return pattern;
}

std::vector<double> upper_triangle(const MatrixXd& A) {
  std::vector<double> values;
  for (Eigen::Index row = 0; row < A.rows(); ++row) {
    for (Eigen::Index column = row; column < A.cols(); ++column)
      values.push_back(A(row, column));
  }
  return values;
}

/// Random, symmetric, with `shift` added to the diagonal.
MatrixXd random_matrix(Eigen::Index n, double shift, std::uint64_t seed) {
  support::Random random(seed);
  MatrixXd A(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j)
      A(i, j) = A(j, i) = random.uniform(-1.0, 1.0) + (i == j ? shift : 0.0);
  }
  return A;
}

int negative_eigenvalues(const MatrixXd& A) {
  const std::vector<double> values = support::symmetric_eigenvalues(A);
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [](double value) { return value < 0.0; }));
}

void expect_solution(const SymmetricFactor& factor, const MatrixXd& A) {
  VectorXd expected(A.rows());
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    expected(i) = 1.0 + std::sin(double(i));
  const VectorXd rhs = A * expected;
  VectorXd x(A.rows());
  factor.solve({rhs.data(), static_cast<std::size_t>(rhs.size())},
               {x.data(), static_cast<std::size_t>(x.size())});
  EXPECT_LE(support::norm_of(x - expected), 1e-11 * support::norm_of(expected));
}

TEST(SymmetricFactor, SolvesAndCountsNegativeEigenvalues) {
  for (const double shift : {8.0, 2.0, 0.0, -2.0, -8.0}) {
    const MatrixXd A = random_matrix(12, shift, 3);
    SymmetricFactor factor(full_pattern(12));
    EXPECT_EQ(factor.factorise(upper_triangle(A)), negative_eigenvalues(A)) << shift;
    expect_solution(factor, A);
  }
}

TEST(SymmetricFactor, FindsNothingNegativeInADefiniteMatrixAndAllInItsOpposite) {
  const MatrixXd A = random_matrix(12, 12.0, 3);
  SymmetricFactor factor(full_pattern(12));
  EXPECT_EQ(factor.factorise(upper_triangle(A)), 0);
  EXPECT_EQ(factor.factorise(upper_triangle(-A)), 12);
}

TEST(SymmetricFactor, NeedsNoPivotOnTheDiagonal) {
  MatrixXd A(2, 2);
  A << 0, 1, 1, 0;
  SymmetricFactor factor(full_pattern(2));
  EXPECT_EQ(factor.factorise(upper_triangle(A)), 1);
  expect_solution(factor, A);
}

TEST(SymmetricFactor, TakesNewValuesAgainAndAgain) {
  SymmetricFactor factor(full_pattern(12));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const MatrixXd A = random_matrix(12, seed % 2 == 0 ? 8.0 : 0.0, seed);
    EXPECT_EQ(factor.factorise(upper_triangle(A)), negative_eigenvalues(A)) << seed;
    expect_solution(factor, A);
  }
}

TEST(SymmetricFactor, DoesNotTakeASingularMatrixForDefinite) {
  MatrixXd A(3, 3);  // a chain of two springs that nothing holds
  A << 1, -1, 0, -1, 2, -1, 0, -1, 1;
  SymmetricFactor factor(full_pattern(3));
  EXPECT_GT(factor.factorise(upper_triangle(A)), 0);
  EXPECT_THROW(factor.solve(std::vector<double>(3, 1.0), std::span(A.data(), 3)), BugError);
  A(0, 0) += 1.0;  // held: and the factor is as good as new
  EXPECT_EQ(factor.factorise(upper_triangle(A)), 0);
  expect_solution(factor, A);
}

TEST(SymmetricFactor, SurvivesPivotsThatNobodyExpected) {
  // Analysed for a strong diagonal; then the diagonal is gone, and pivots cause far more fill than was counted on.
  const Index n = 1000;
  support::Random random(4);
  SparsityPattern pattern{{0}, {}};
  std::vector<double> hard;
  std::vector<double> easy;
  for (Index row = 0; row < n; ++row) {
    for (Index column = row; column < n; ++column) {
      if (column > row + 1 && random.uniform(0.0, 1.0) > 0.004) continue;
      pattern.column.push_back(column);
      hard.push_back(column == row ? 0.0 : random.uniform(-1.0, 1.0));
      easy.push_back(column == row ? 20.0 : hard.back());
    }
    pattern.row_begin.push_back(to_index(pattern.column.size()));
  }
  SymmetricFactor factor(pattern);
  EXPECT_EQ(factor.factorise(easy), 0);
  const int negative = factor.factorise(hard);
  EXPECT_GT(negative, n / 3);
  EXPECT_LT(negative, 2 * n / 3);
}

TEST(SymmetricFactor, DoesNotTakeNotANumberForDefinite) {
  MatrixXd A = MatrixXd::Identity(3, 3);
  A(1, 1) = std::numeric_limits<double>::quiet_NaN();
  SymmetricFactor factor(full_pattern(3));
  EXPECT_GT(factor.factorise(upper_triangle(A)), 0);
}

TEST(SymmetricFactor, KeepsASparseMatrixSparse) {
  // A chain of n springs has a factor with about 2 n entries.
  const Index n = 400;
  SparsityPattern pattern{{0}, {}};
  std::vector<double> values;
  for (Index row = 0; row < n; ++row) {
    pattern.column.push_back(row);
    values.push_back(2.0);
    if (row + 1 < n) {
      pattern.column.push_back(row + 1);
      values.push_back(-1.0);
    }
    pattern.row_begin.push_back(to_index(pattern.column.size()));
  }
  SymmetricFactor factor(pattern);
  EXPECT_EQ(factor.factorise(values), 0);
  EXPECT_GE(factor.factor_nonzeros(), 2.0 * n - 1.0);
  EXPECT_LE(factor.factor_nonzeros(), 10.0 * n);
}

TEST(SymmetricFactor, GivesTheSameBitsTwice) {
  const MatrixXd A = random_matrix(12, 0.0, 5);
  const std::vector<double> rhs(12, 1.0);
  std::vector<double> first(12);
  std::vector<double> second(12);
  SymmetricFactor factor(full_pattern(12));
  (void)factor.factorise(upper_triangle(A));
  factor.solve(rhs, first);
  SymmetricFactor another(full_pattern(12));
  (void)another.factorise(upper_triangle(random_matrix(12, 8.0, 6)));
  (void)another.factorise(upper_triangle(A));
  another.solve(rhs, second);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace facies::solve
