// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/positive_part.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "facies/base/error.hpp"

namespace facies::mechanics {

void reduce_negative(std::span<double> block, double positivity) {
  // An element's matrix at most: fixed storage keeps the eigenvalue solver off the heap.
  using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 24, 24>;
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(block.size())));
  require(n <= 24, "blocks of more than 24 unknowns cannot be made positive");
  Eigen::Map<Eigen::MatrixXd> matrix(block.data(), n, n);
  const Eigen::SelfAdjointEigenSolver<Block> modes(matrix);
  const auto lambda = modes.eigenvalues();
  if (lambda(0) >= 0.0) return;
  const Block& V = modes.eigenvectors();
  matrix = V * (lambda - positivity * lambda.cwiseMin(0.0)).asDiagonal() * V.transpose();
}

}  // namespace facies::mechanics
