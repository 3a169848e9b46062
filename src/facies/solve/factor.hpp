// SPDX-License-Identifier: Apache-2.0
// Direct factorisation of a sparse symmetric matrix, and what it tells about definiteness.
#pragma once

#include <memory>
#include <vector>

#include "facies/solve/equations.hpp"

namespace facies::solve {

/// L D L^T of symmetric matrices that share one pattern (MUMPS through PETSc). The symbolic phase is done once, and again
/// after a matrix that could not be factorised. A matrix without rows is fine.
class SymmetricFactor {
 public:
  explicit SymmetricFactor(const SparsityPattern& pattern);
  ~SymmetricFactor();
  SymmetricFactor(const SymmetricFactor&) = delete;
  SymmetricFactor& operator=(const SymmetricFactor&) = delete;
  SymmetricFactor(SymmetricFactor&&) = delete;
  SymmetricFactor& operator=(SymmetricFactor&&) = delete;

  /// Factorises the matrix with these nonzeros [n_nonzeros] and returns how many of its eigenvalues are negative
  /// (Sylvester's law of inertia); n where the matrix is singular and there is nothing to solve with.
  /// Throws NumericsError where memory does not suffice.
  [[nodiscard]] int factorise(std::span<const double> values);

  /// Solves with the last factorisation, which must not have been of a singular matrix; right-hand side and solution [n].
  void solve(std::span<const double> rhs, std::span<double> x) const;

  /// Nonzeros of the last factor.
  [[nodiscard]] double factor_nonzeros() const;

 private:
  struct Petsc;

  void analyse();

  std::unique_ptr<Petsc> petsc_;
};

}  // namespace facies::solve
