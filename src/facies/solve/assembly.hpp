// SPDX-License-Identifier: Apache-2.0
// From the terms of a model to the values of a sparse symmetric matrix.
#pragma once

#include <vector>

#include "facies/solve/equations.hpp"

namespace facies::solve {

/// What happens to each term's blocks on their way into the matrix.
enum class Blocks {
  exact,  ///< nothing: the sum is K = dr/du
  positive,  ///< negative eigenvalues are replaced by zero: the sum is positive definite, and no longer dr/du
};

/// Assembles tangents over a fixed pattern. The values have the same bits for any number of threads.
class Assembly {
 public:
  /// The model must outlive the assembly.
  Assembly(const mechanics::Model& model, std::span<const Index> prescribed);

  [[nodiscard]] const Equations& equations() const { return equations_; }
  [[nodiscard]] const SparsityPattern& pattern() const { return pattern_; }

  /// Nonzeros of the upper triangle of K over the free unknowns [n_nonzeros] [mN/mm].
  /// `moves` [n_dofs] [mm] are displacements that prescribed unknowns are about to make (empty: none); their forces on
  /// the free unknowns, K_fp moves, are added to `coupling` [n_equations] [mN].
  void tangent(const mechanics::State& state, const mechanics::Controls& controls, Blocks blocks,
               std::span<double> values, std::span<const double> moves,
               std::span<double> coupling) const;

 private:
  const mechanics::Model& model_;
  std::vector<mechanics::Stencils> stencils_;  // [n_terms]
  Equations equations_;
  SparsityPattern pattern_;
  std::vector<Slots> slots_;  // [n_terms]
};

}  // namespace facies::solve
