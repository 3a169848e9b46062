// SPDX-License-Identifier: Apache-2.0
// From the terms of a model to the values of a sparse symmetric matrix.
#pragma once

#include <vector>

#include "facies/solve/equations.hpp"

namespace facies::solve {

/// Assembles tangents over a pattern that stays the same until it is widened. The values have the same bits for any number of
/// threads.
class Assembly {
 public:
  /// The model must outlive the assembly.
  Assembly(const mechanics::Model& model, std::span<const Index> prescribed);

  [[nodiscard]] const Equations& equations() const { return equations_; }
  [[nodiscard]] const SparsityPattern& pattern() const { return pattern_; }

  /// Whether the pattern has a place for everything that couples at this state.
  [[nodiscard]] bool covers(const mechanics::State& state) const;

  /// Makes a new pattern with room for what couples at this state and for what may soon.
  void widen(const mechanics::State& state);

  /// Nonzeros of the upper triangle of K over the free unknowns [n_nonzeros] [mN/mm]. `positivity` 0 gives K = dr/du; 1
  /// replaces negative eigenvalues of each block by zero, so that the sum has none; between, they are made smaller by
  /// that part.
  /// `moves` [n_dofs] [mm] are displacements that prescribed unknowns are about to make (empty: none); their forces on
  /// the free unknowns, K_fp moves, are added to `coupling` [n_equations] [mN]. The pattern must cover the state.
  void tangent(const mechanics::State& state, const mechanics::Controls& controls,
               double positivity, std::span<double> values, std::span<const double> moves,
               std::span<double> coupling) const;

 private:
  const mechanics::Model& model_;
  std::vector<mechanics::Stencils> stencils_;  // [n_terms], empty for those that change
  Equations equations_;
  SparsityPattern pattern_;
  std::vector<Slots> slots_;  // [n_terms], of stencils_
};

}  // namespace facies::solve
