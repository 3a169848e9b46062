// SPDX-License-Identifier: Apache-2.0
// The life of the solver library.
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "facies/solve/factor.hpp"
#include "facies/solve/session.hpp"

namespace facies::solve {
namespace {

TEST(Session, MayBeOpenedInsideAnother) {
  const Session outer;
  { const Session inner; }
  // The library is still there.
  SymmetricFactor factor({{0, 1}, {0}});
  EXPECT_EQ(factor.factorise(std::vector<double>{2.0}), 0);
}

TEST(Session, TellsTheVersionsOfItsLibraries) {
  EXPECT_THAT(solver_versions(), ::testing::MatchesRegex("PETSc 3\\.[0-9]+\\.[0-9]+, MUMPS"));
}

}  // namespace
}  // namespace facies::solve
