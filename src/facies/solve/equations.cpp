// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/equations.hpp"

#include <algorithm>

#include "facies/base/error.hpp"

namespace facies::solve {

Equations number_equations(std::size_t n_dofs, std::span<const Index> prescribed) {
  Equations equations;
  equations.equation_of_dof.assign(n_dofs, 0);
  for (const Index dof : prescribed) {
    require(dof >= 0 && at(dof) < n_dofs, "a prescribed unknown must exist");
    equations.equation_of_dof[at(dof)] = -1;
  }
  for (std::size_t dof = 0; dof < n_dofs; ++dof) {
    if (equations.equation_of_dof[dof] < 0) continue;
    equations.equation_of_dof[dof] = to_index(equations.size());
    equations.dof_of_equation.push_back(to_index(dof));
  }
  return equations;
}

Index SparsityPattern::position(Index row, Index wanted) const {
  const auto begin = column.begin() + row_begin[at(row)];
  const auto end = column.begin() + row_begin[at(row) + 1];
  const auto place = std::lower_bound(begin, end, wanted);
  return place == end || *place != wanted ? -1 : static_cast<Index>(place - column.begin());
}

namespace {

/// Calls visit(row, column) with row <= column for every pair of free unknowns of a group.
template <class Visit>
void for_each_pair(const mechanics::Stencils& stencils, const Equations& equations,
                   const Visit& visit) {
  for (std::size_t g = 0; g < stencils.size(); ++g) {
    const std::span<const Index> group = stencils[g];
    for (std::size_t j = 0; j < group.size(); ++j) {
      const Index b = equations.equation_of_dof[at(group[j])];
      if (b < 0) continue;
      for (std::size_t i = j; i < group.size(); ++i) {
        const Index a = equations.equation_of_dof[at(group[i])];
        if (a >= 0) visit(std::min(a, b), std::max(a, b));
      }
    }
  }
}

}  // namespace

SparsityPattern build_pattern(std::span<const mechanics::Stencils> stencils,
                              const Equations& equations) {
  const std::size_t n = equations.size();
  std::vector<std::size_t> begin(n + 1, 0);
  for (std::size_t row = 0; row < n; ++row)
    begin[row + 1] = 1;  // the diagonal
  for (const mechanics::Stencils& list : stencils) {
    for_each_pair(list, equations, [&](Index row, Index) { ++begin[at(row) + 1]; });
  }
  for (std::size_t row = 0; row < n; ++row)
    begin[row + 1] += begin[row];
  std::vector<Index> columns(begin[n]);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t row = 0; row < n; ++row)
    columns[next[row]++] = to_index(row);
  for (const mechanics::Stencils& list : stencils) {
    for_each_pair(list, equations,
                  [&](Index row, Index column) { columns[next[at(row)]++] = column; });
  }
  SparsityPattern pattern;
  pattern.row_begin.push_back(0);
  for (std::size_t row = 0; row < n; ++row) {
    const auto first = columns.begin() + static_cast<std::ptrdiff_t>(begin[row]);
    const auto last = columns.begin() + static_cast<std::ptrdiff_t>(begin[row + 1]);
    std::sort(first, last);
    pattern.column.insert(pattern.column.end(), first, std::unique(first, last));
    pattern.row_begin.push_back(to_index(pattern.column.size()));
  }
  return pattern;
}

Slots find_slots(const mechanics::Stencils& stencils, const Equations& equations,
                 const SparsityPattern& pattern) {
  Slots slots;
  slots.begin.push_back(0);
  for (std::size_t g = 0; g < stencils.size(); ++g) {
    const std::span<const Index> group = stencils[g];
    for (std::size_t j = 0; j < group.size(); ++j) {
      const Index b = equations.equation_of_dof[at(group[j])];
      for (std::size_t i = j; i < group.size(); ++i) {
        const Index a = equations.equation_of_dof[at(group[i])];
        slots.slot.push_back(a < 0 || b < 0 ? Slots::prescribed
                                            : pattern.position(std::min(a, b), std::max(a, b)));
      }
    }
    slots.begin.push_back(slots.slot.size());
  }
  return slots;
}

}  // namespace facies::solve
