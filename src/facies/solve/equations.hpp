// SPDX-License-Identifier: Apache-2.0
// Which unknowns are solved for, and where their couplings stand in a sparse symmetric matrix.
#pragma once

#include <cstdint>
#include <vector>

#include "facies/mechanics/model.hpp"

namespace facies::solve {

/// Numbers of the unknowns that are free: equation_of_dof[dof] is -1 for a prescribed one.
struct Equations {
  std::vector<Index> equation_of_dof;  ///< [n_dofs]
  std::vector<Index> dof_of_equation;  ///< [n_equations]

  [[nodiscard]] std::size_t size() const { return dof_of_equation.size(); }
};

/// Every unknown but the prescribed ones, in their order. Throws BugError for a dof that does not exist.
[[nodiscard]] Equations number_equations(std::size_t n_dofs, std::span<const Index> prescribed);

/// Upper triangle of a symmetric sparse matrix by rows, diagonal first, columns ascending.
struct SparsityPattern {
  std::vector<Index> row_begin;  ///< [n + 1]
  std::vector<Index> column;     ///< [n_nonzeros]

  [[nodiscard]] std::size_t size() const { return row_begin.size() - 1; }
  [[nodiscard]] std::size_t n_nonzeros() const { return column.size(); }
  /// Position of (row, column), row <= column; -1 where it is not in the pattern.
  [[nodiscard]] Index position(Index row, Index column) const;
};

/// The couplings of all terms of the model, and the diagonal.
[[nodiscard]] SparsityPattern build_pattern(std::span<const mechanics::Stencils> stencils,
                                            const Equations& equations);

/// Where the lower triangle of each group's block goes among the nonzeros: entries (i, j), i >= j, column by column;
/// `prescribed` where an unknown of the pair is prescribed, -1 where the pattern lacks the pair.
struct Slots {
  static constexpr Index prescribed = -2;
  std::vector<std::size_t> begin;  ///< [n_groups + 1]
  std::vector<Index> slot;
};
[[nodiscard]] Slots find_slots(const mechanics::Stencils& stencils, const Equations& equations,
                               const SparsityPattern& pattern);

}  // namespace facies::solve
