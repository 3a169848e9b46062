// SPDX-License-Identifier: Apache-2.0
// Numbering, pattern and slots against a dense matrix.
#include <algorithm>
#include <set>

#include "support/random.hpp"
#include <Eigen/Core>
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/solve/equations.hpp"

namespace facies::solve {
namespace {

using mechanics::Stencils;

TEST(Equations, NumberTheFreeUnknownsInTheirOrder) {
  const std::vector<Index> prescribed = {0, 3};
  const Equations equations = number_equations(6, prescribed);
  EXPECT_EQ(equations.equation_of_dof, (std::vector<Index>{-1, 0, 1, -1, 2, 3}));
  EXPECT_EQ(equations.dof_of_equation, (std::vector<Index>{1, 2, 4, 5}));
}

TEST(Equations, AreAllUnknownsWhereNothingIsPrescribed) {
  EXPECT_EQ(number_equations(4, {}).dof_of_equation, (std::vector<Index>{0, 1, 2, 3}));
}

TEST(Equations, MayBeNone) {
  const std::vector<Index> all = {0, 1, 2};
  EXPECT_EQ(number_equations(3, all).size(), 0U);
}

TEST(Equations, RefuseAnUnknownThatDoesNotExist) {
  EXPECT_THROW((void)number_equations(3, std::vector<Index>{3}), BugError);
  EXPECT_THROW((void)number_equations(3, std::vector<Index>{-1}), BugError);
}

/// Two terms with random groups over 20 unknowns, three of them prescribed.
class Pattern : public ::testing::Test {
 protected:
  static constexpr std::size_t n_dofs = 20;

  void SetUp() override {
    for (Stencils& term : terms_) {
      for (int g = 0; g < 8; ++g) {
        std::set<Index> group;
        while (group.size() < 4)
          group.insert(static_cast<Index>(random_.uniform(0.0, double(n_dofs))));
        std::vector<Index> dofs(group.begin(), group.end());
        std::rotate(dofs.begin(), dofs.begin() + g % 4, dofs.end());  // groups need no order
        term.push_back(dofs);
      }
    }
  }

  support::Random random_{1};
  std::vector<Stencils> terms_{2};
  Equations equations_ = number_equations(n_dofs, std::vector<Index>{2, 7, 19});
};

TEST_F(Pattern, HoldsEveryCouplingAndTheDiagonalAndNothingElse) {
  std::set<std::pair<Index, Index>> expected;
  for (Index row = 0; row < to_index(equations_.size()); ++row)
    expected.insert({row, row});
  for (const Stencils& term : terms_) {
    for (std::size_t g = 0; g < term.size(); ++g) {
      for (const Index i : term[g]) {
        for (const Index j : term[g]) {
          const Index row = equations_.equation_of_dof[at(i)];
          const Index column = equations_.equation_of_dof[at(j)];
          if (row >= 0 && row <= column) expected.insert({row, column});
        }
      }
    }
  }
  const SparsityPattern pattern = build_pattern(terms_, equations_);
  ASSERT_EQ(pattern.size(), equations_.size());
  std::vector<std::pair<Index, Index>> found;
  for (Index row = 0; row < to_index(pattern.size()); ++row) {
    EXPECT_EQ(pattern.column[at(pattern.row_begin[at(row)])], row) << "the diagonal comes first";
    for (Index k = pattern.row_begin[at(row)]; k < pattern.row_begin[at(row) + 1]; ++k) {
      found.emplace_back(row, pattern.column[at(k)]);
      EXPECT_EQ(pattern.position(row, pattern.column[at(k)]), k);
    }
  }
  // A list equal to an ordered set: sorted, and no entry twice.
  EXPECT_EQ(found, std::vector(expected.begin(), expected.end()));
  EXPECT_EQ(pattern.n_nonzeros(), expected.size());
}

TEST_F(Pattern, TakesBlocksWhereADenseMatrixTakesThem) {
  const SparsityPattern pattern = build_pattern(terms_, equations_);
  std::vector<double> values(pattern.n_nonzeros(), 0.0);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n_dofs, n_dofs);
  for (const Stencils& term : terms_) {
    const Slots slots = find_slots(term, equations_, pattern);
    ASSERT_EQ(slots.begin.size(), term.size() + 1);
    for (std::size_t g = 0; g < term.size(); ++g) {
      std::size_t next = slots.begin[g];
      for (std::size_t j = 0; j < term[g].size(); ++j) {
        for (std::size_t i = j; i < term[g].size(); ++i, ++next) {
          const double k = random_.uniform(-1.0, 1.0);
          const Index a = term[g][i];
          const Index b = term[g][j];
          dense(a, b) += k;
          if (a != b) dense(b, a) += k;
          if (slots.slot[next] >= 0) values[at(slots.slot[next])] += k;
        }
      }
      EXPECT_EQ(next, slots.begin[g + 1]);
    }
  }
  for (Index row = 0; row < to_index(pattern.size()); ++row) {
    for (Index k = pattern.row_begin[at(row)]; k < pattern.row_begin[at(row) + 1]; ++k) {
      const Index i = equations_.dof_of_equation[at(row)];
      const Index j = equations_.dof_of_equation[at(pattern.column[at(k)])];
      EXPECT_NEAR(values[at(k)], dense(i, j), 1e-14);
    }
  }
}

TEST(PatternWithoutCouplings, IsTheDiagonal) {
  const SparsityPattern pattern = build_pattern({}, number_equations(3, {}));
  EXPECT_EQ(pattern.row_begin, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(pattern.column, (std::vector<Index>{0, 1, 2}));
}

}  // namespace
}  // namespace facies::solve
