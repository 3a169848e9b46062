// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/results/convergence.hpp"

namespace facies::results {
namespace {

using ::testing::HasSubstr;

std::vector<IncrementRecord> some_increments() {
  IncrementRecord tension{
      "tension",
      1,
      1,
      0.0,
      1.0,
      {{0, 100.0, 1.0}, {1, 3.0, 0.03, 2.5, 1.0, 0.1, 3}, {2, 1e-7, 1e-9, 0.01, 1.0, 0.0, 1}},
      true,
      "residual small",
      -1,
      {}};
  IncrementRecord failed{
      "express",     2,  1, 0.0, 1.0, {{0, 50.0, 1.0}, {1, 70.0, 1.4, 9.0, 0.1, 0.5, 2}}, false,
      "no decrease", -1, {}};
  failed.worst_node = 12;
  failed.inadmissible = {7, -0.25};
  IncrementRecord half{
      "express",        2,  2, 0.0, 0.5, {{0, 25.0, 1.0}, {1, 1e-6, 1e-8, 1.0, 1.0, 0.0, 1}}, true,
      "residual small", -1, {}};
  return {tension, failed, half};
}

TEST(StepTotals, AddUpIncrementsOfEachStep) {
  const std::vector<StepTotals> totals = step_totals(some_increments());
  ASSERT_EQ(totals.size(), 2U);
  EXPECT_EQ(totals[0].step, "tension");
  EXPECT_EQ(totals[0].load, 1.0);
  EXPECT_EQ(totals[0].increments, 1);
  EXPECT_EQ(totals[0].iterations, 2);
  EXPECT_EQ(totals[0].factorisations, 4);
  EXPECT_EQ(totals[1].load, 0.5);
  EXPECT_EQ(totals[1].increments, 1);
  EXPECT_EQ(totals[1].failed_increments, 1);
  EXPECT_EQ(totals[1].iterations, 2);
  EXPECT_EQ(totals[1].factorisations, 3);
}

TEST(ConvergenceText, HasARowForEveryIterationAndSaysWhatWentWrong) {
  const std::string text = convergence_text(some_increments());
  EXPECT_THAT(text, HasSubstr("step 1 tension"));
  EXPECT_THAT(text, HasSubstr("increment 2, load 0 to 0.5"));
  EXPECT_THAT(text, HasSubstr("3.0000e+00   3.0000e-02   2.5000e+00   1.0000   1.00e-01      3"));
  EXPECT_THAT(text, HasSubstr("converged: residual small"));
  EXPECT_THAT(text, HasSubstr("NOT CONVERGED: no decrease; largest residual at node 12; element 7 "
                              "would be inside out (det F = -0.25)"));
}

class Log : public InFolder {};

TEST_F(Log, IsOneObjectOnEachLineAndOnDiskAtOnce) {
  const std::vector<IncrementRecord> increments = some_increments();
  RunLog log(folder_ / "log.jsonl");
  log.iteration(increments[0], increments[0].iterations[1]);
  EXPECT_EQ(split(read_file(folder_ / "log.jsonl"), '\n').size(), 2U);
  log.increment(increments[1]);
  const std::string text = read_file(folder_ / "log.jsonl");
  const auto lines = split(text, '\n');
  ASSERT_EQ(lines.size(), 3U);
  const auto iteration = nlohmann::json::parse(lines[0]);
  EXPECT_EQ(iteration["event"], "iteration");
  EXPECT_EQ(iteration["step"], "tension");
  EXPECT_EQ(iteration["residual_mN"], 3.0);
  const auto increment = nlohmann::json::parse(lines[1]);
  EXPECT_EQ(increment["event"], "increment");
  EXPECT_EQ(increment["converged"], false);
  EXPECT_EQ(increment["inadmissible_element"], 7);
}

TEST_F(Log, KeepsToJsonForNumbersThatAreNone) {
  IncrementRecord increment = some_increments()[0];
  increment.iterations[1].residual = std::nan("");
  increment.reason = "bad byte \xff";
  RunLog log(folder_ / "log.jsonl");
  log.iteration(increment, increment.iterations[1]);
  log.increment(increment);
  const std::string text = read_file(folder_ / "log.jsonl");
  for (const std::string_view line : split(trim(text), '\n'))
    EXPECT_FALSE(nlohmann::json::parse(line, nullptr, false).is_discarded());
}

TEST_F(Log, SaysThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  RunLog log("/dev/full");
  try {
    log.increment(some_increments()[0]);
    FAIL() << "nothing was said";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("free some space"));
  }
}

TEST_F(Log, NeedsItsFolder) {
  EXPECT_THROW(RunLog(folder_ / "missing" / "log.jsonl"), UsageError);
}

}  // namespace
}  // namespace facies::results
