// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/positive_part.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace facies::mechanics {

namespace {

/// Eigenvalues that should be zero (of an element that is moved as a whole) come out as small as this, as a part of the
/// largest entry.
constexpr double rounding = 1e-12;

/// Whether no eigenvalue is negative by more than rounding. Asking Cholesky takes a twentieth of the time of eigenvalues.
template <class Block>
bool has_no_negative(Block matrix) {
  matrix.diagonal().array() += rounding * matrix.diagonal().cwiseAbs().maxCoeff();
  return Eigen::LLT<Eigen::Ref<Block>>(matrix).info() == Eigen::Success;
}

template <class Block>
void reduce(Eigen::Map<Eigen::MatrixXd> matrix, double positivity) {
  if (has_no_negative<Block>(matrix)) return;
  const Eigen::SelfAdjointEigenSolver<Block> modes(matrix);
  const auto& lambda = modes.eigenvalues();
  if (lambda(0) >= 0.0) return;
  const Block& V = modes.eigenvectors();
  matrix = V * (lambda - positivity * lambda.cwiseMin(0.0)).asDiagonal() * V.transpose();
}

}  // namespace

void reduce_negative(std::span<double> block, double positivity) {
  // Fixed storage keeps the eigenvalue solver off the heap for all but the largest contacts.
  constexpr Eigen::Index of_an_element = 24;
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(block.size())));
  const Eigen::Map<Eigen::MatrixXd> matrix(block.data(), n, n);
  if (n <= of_an_element) {
    reduce<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, of_an_element,
                         of_an_element>>(matrix, positivity);
  } else {
    reduce<Eigen::MatrixXd>(matrix, positivity);
  }
}

}  // namespace facies::mechanics
