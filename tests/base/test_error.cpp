// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "facies/base/error.hpp"

namespace facies {
namespace {

const Problem with_hint{"smile.yaml:12:7", "unknown muscle 'ZGY'", "", "did you mean 'ZYG'?"};
const Problem without_hint{"/steps/2", "3", "a number from 0 to 1", ""};

TEST(Error, SaysWhereWhatExpectedAndWhatToDo) {
  EXPECT_EQ(to_string(with_hint), "smile.yaml:12:7: unknown muscle 'ZGY'\n    did you mean 'ZYG'?");
  EXPECT_EQ(to_string(without_hint), "/steps/2: 3; expected a number from 0 to 1");
}

TEST(Error, NeedsNoPlace) {
  EXPECT_EQ(to_string({"", "the disk is full", "", ""}), "the disk is full");
}

TEST(Error, CarriesEveryProblem) {
  Problems problems;
  problems.add(with_hint);
  problems.add(std::vector<Problem>{without_hint});
  ASSERT_EQ(problems.size(), 2U);
  try {
    problems.throw_if_any<ScenarioError>();
    FAIL() << "nothing was thrown";
  } catch (const ScenarioError& error) {
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_EQ(error.problems()[1].where, "/steps/2");
    EXPECT_EQ(std::string(error.what()), to_string(with_hint) + "\n" + to_string(without_hint));
  }
}

TEST(Error, IsNotThrownWhereNothingIsWrong) {
  const Problems none;
  EXPECT_TRUE(none.empty());
  EXPECT_NO_THROW(none.throw_if_any<DataError>());
}

TEST(Error, TellsInputFromDefects) {
  EXPECT_NO_THROW(require(true, "holds"));
  EXPECT_THROW(require(false, "does not hold"), BugError);
  EXPECT_THROW(throw DataError({without_hint}), InputError);
}

}  // namespace
}  // namespace facies
