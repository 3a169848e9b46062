// SPDX-License-Identifier: Apache-2.0
// Blocks without their negative eigenvalues, against blocks built from eigenvalues that are known.
#include <vector>

#include "support/random.hpp"
#include <Eigen/QR>
#include <gtest/gtest.h>

#include "facies/math/tensor.hpp"
#include "facies/mechanics/positive_part.hpp"

namespace facies::mechanics {
namespace {

std::span<double> entries(Eigen::MatrixXd& block) {
  return {block.data(), static_cast<std::size_t>(block.size())};
}

/// Blocks of an element, smaller, and larger than the storage that is fixed.
class PositivePart : public ::testing::TestWithParam<Eigen::Index> {
 protected:
  PositivePart() {
    Eigen::MatrixXd any(n_, n_);
    for (Eigen::Index i = 0; i < any.size(); ++i)
      any.data()[i] = random_.uniform(-1.0, 1.0);
    modes_ = Eigen::HouseholderQR<Eigen::MatrixXd>(any).householderQ();
    for (double& value : lambda_)
      value = random_.uniform(1.0, 100.0);
  }

  [[nodiscard]] Eigen::MatrixXd block_with(const Eigen::VectorXd& eigenvalues) const {
    return modes_ * eigenvalues.asDiagonal() * modes_.transpose();
  }

  Eigen::Index n_ = GetParam();
  support::Random random_{4};
  Eigen::MatrixXd modes_;
  Eigen::VectorXd lambda_ = Eigen::VectorXd::Zero(n_);
};

TEST_P(PositivePart, MakesNegativeEigenvaluesSmallerAndLeavesTheOthers) {
  lambda_(0) = -40.0;
  lambda_(1) = -1e-3;
  for (const double positivity : {0.25, 1.0}) {
    Eigen::MatrixXd block = block_with(lambda_);
    reduce_negative(entries(block), positivity);
    Eigen::VectorXd expected = lambda_;
    expected.head<2>() *= 1.0 - positivity;
    EXPECT_LE((block - block_with(expected)).norm(), 1e-11);
  }
}

TEST_P(PositivePart, SeesAnEigenvalueThatIsNegativeByLittleMoreThanRounding) {
  lambda_(0) = -1e-8;
  Eigen::MatrixXd block = block_with(lambda_);
  reduce_negative(entries(block), 1.0);
  const auto first = modes_.col(0);
  EXPECT_NEAR(first.dot(block * first), 0.0, 1e-12);
}

TEST_P(PositivePart, LeavesAPositiveBlockAsItIs) {
  const Eigen::MatrixXd before = block_with(lambda_);
  Eigen::MatrixXd block = before;
  reduce_negative(entries(block), 1.0);
  EXPECT_EQ(block, before);
}

TEST_P(PositivePart, ReadsTheLowerTriangleAlone) {
  lambda_(0) = -40.0;
  Eigen::MatrixXd expected = block_with(lambda_);
  Eigen::MatrixXd block = expected.triangularView<Eigen::Lower>();
  reduce_negative(entries(expected), 1.0);
  reduce_negative(entries(block), 1.0);
  EXPECT_EQ(block, expected);
}

TEST_P(PositivePart, LeavesABlockThatNoTranslationChanges) {
  // Springs between all nodes, with stiffnesses of all sizes: three eigenvalues are zero but for rounding.
  const Eigen::Index n_nodes = n_ / 3;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n_, n_);
    for (Eigen::Index a = 0; a < n_nodes; ++a) {
      for (Eigen::Index b = 0; b < a; ++b) {
        const Vec3 along = random_.vector(-10.0, 10.0);
        const Mat3 k = random_.uniform(0.0, 1e3) * along * along.transpose();
        block.block<3, 3>(3 * a, 3 * a) += k;
        block.block<3, 3>(3 * b, 3 * b) += k;
        block.block<3, 3>(3 * a, 3 * b) -= k;
        block.block<3, 3>(3 * b, 3 * a) -= k;
      }
    }
    const Eigen::MatrixXd before = block;
    reduce_negative(entries(block), 1.0);
    ASSERT_EQ(block, before);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, PositivePart, ::testing::Values(3, 9, 18, 24, 30));

TEST(PositivePartOfNothing, IsNothing) {
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(24, 24);
  reduce_negative(entries(block), 1.0);
  EXPECT_EQ(block, Eigen::MatrixXd::Zero(24, 24));
}

}  // namespace
}  // namespace facies::mechanics
