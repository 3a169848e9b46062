// SPDX-License-Identifier: Apache-2.0
// The step `move`: its curves, from the scenario and from tables, and what is told of bad ones.
#include <gmock/gmock.h>

#include "scenario/reading.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/scenario/write_scenario.hpp"

namespace facies::scenario {
namespace {

using testing::HasSubstr;

MoveStep move_of(const Reading& reading) {
  EXPECT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
  return std::get<MoveStep>(reading.scenario.steps.at(0));
}

TEST(Curve, IsStraightBetweenItsPointsAndConstantBeyondThem) {
  const Curve curve{{{0.1, 0.2}, {0.3, 0.6}, {0.4, 0.0}}};
  EXPECT_DOUBLE_EQ(curve.at(-1.0), 0.2);
  EXPECT_DOUBLE_EQ(curve.at(0.1), 0.2);
  EXPECT_DOUBLE_EQ(curve.at(0.2), 0.4);
  EXPECT_DOUBLE_EQ(curve.at(0.3), 0.6);
  EXPECT_DOUBLE_EQ(curve.at(0.375), 0.15);
  EXPECT_DOUBLE_EQ(curve.at(9.0), 0.0);
  EXPECT_DOUBLE_EQ((Curve{{{0.0, 0.7}}}).at(5.0), 0.7);
}

TEST(Move, TakesNumbersAndPoints) {
  const MoveStep step = move_of(read(R"(steps:
  - move:
      duration: 500 ms
      method: quasi_static
      frames: 7
      ZYG: [[0 s, 0], [200 ms, 0.5]]
      LLS_L: 0.4
)"));
  EXPECT_DOUBLE_EQ(step.duration, 0.5);
  EXPECT_EQ(step.method, "quasi_static");
  EXPECT_EQ(step.frames, 7);
  EXPECT_EQ(step.levels.at("ZYG"), (Curve{{{0.0, 0.0}, {0.2, 0.5}}}));
  EXPECT_EQ(step.levels.at("LLS_L"), (Curve{{{0.0, 0.4}}}));
}

/// A folder with a scenario whose curves are in a table.
class MoveByTable : public testing::Test {
 protected:
  [[nodiscard]] Reading read_with(const std::string& table, const std::string& more = "") const {
    write_file(folder_.path() / "c.csv", table);
    const std::string text =
        "steps:\n  - move:\n      duration: 0.5 s\n      curves: c.csv\n" + more;
    return read_text(text, (folder_.path() / "x.yaml").string(), "x", {});
  }

  /// Problems without the path of the folder.
  [[nodiscard]] std::string told(const std::string& table, const std::string& more = "") const {
    std::string all;
    for (const Problem& problem : read_with(table, more).problems)
      all += to_string(problem) + '\n';
    const std::string path = folder_.path().string() + "/";
    for (std::size_t at = all.find(path); at != std::string::npos; at = all.find(path))
      all.erase(at, path.size());
    return all;
  }

  support::TemporaryFolder folder_;
};

TEST_F(MoveByTable, HasACurveForEachColumn) {
  const Reading reading =
      read_with("# a smile\ntime_s,ZYG,RIS_R\n0,0,0.1\n\n0.25, 0.5, 0\n", "      DAO: 0.2\n");
  const MoveStep step = move_of(reading);
  EXPECT_EQ(step.levels.at("ZYG"), (Curve{{{0.0, 0.0}, {0.25, 0.5}}}));
  EXPECT_EQ(step.levels.at("RIS_R"), (Curve{{{0.0, 0.1}, {0.25, 0.0}}}));
  EXPECT_EQ(step.levels.at("DAO"), (Curve{{{0.0, 0.2}}}));
  EXPECT_EQ(step.curves, (folder_.path() / "c.csv").string());
}

TEST_F(MoveByTable, IsWrittenWithItsCurvesSoThatTheTableIsNotNeededAgain) {
  MoveStep step = move_of(read_with("time_s,ZYG\n0,0\n0.1,0.3333333333333333\n"));
  const Reading first = read_with("time_s,ZYG\n0,0\n0.1,0.3333333333333333\n");
  step.curves.clear();
  EXPECT_EQ(move_of(read(to_yaml(first.scenario))), step);
}

TEST_F(MoveByTable, WhoseColumnTheFaceDoesNotHavePointsToItsTitle) {
  const Reading reading = read_with("time_s,ZYG,ZIG\n0,0,0\n");
  const std::vector<Problem> problems = check_against_face(reading.scenario, {{"ZYG"}, {"lad"}});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].where, HasSubstr("c.csv:1:12"));
  EXPECT_THAT(problems[0].hint, HasSubstr("did you mean 'ZYG'?"));
}

TEST_F(MoveByTable, TellsEverythingThatIsWrongWithIt) {
  EXPECT_EQ(told("time_s,ZYG,RIS\n0,0,0\n0.2,0.5\n0.1,x,\n0.1,1.5,0\n0.7,0,0\n-1,0,0\n"),
            "c.csv:3: 2 cells; expected 3, one below each title\n"
            "c.csv:4:5: 'x' is not a number; expected a number without a unit\n"
            "c.csv:4:7: an empty cell; expected a number without a unit\n"
            "c.csv:5:1: the time 0.1 s is the same as the one before it; expected times that grow\n"
            "    a jump needs two different times, however near each other\n"
            "c.csv:5:5: 1.5 is out of range; expected at least 0 and at most 1\n"
            "c.csv:6:1: the time 0.7 s lies outside the step; expected 0 s to 0.5 s\n"
            "c.csv:7:1: the time -1 s lies outside the step; expected 0 s to 0.5 s\n"
            "c.csv:7:1: the time -1 s is earlier than the one before it; expected times that grow\n"
            "    sort the points by their times\n");
}

TEST_F(MoveByTable, NeedsTitlesRowsAndAFile) {
  EXPECT_THAT(told("t,ZYG\n0,0\n"), HasSubstr("c.csv:1:1: the first column is 't'"));
  EXPECT_THAT(told("time_s,ZYG,ZYG\n0,0,0\n"), HasSubstr("c.csv:1:12: a second column 'ZYG'"));
  EXPECT_THAT(told("time_s,\n0,0\n"), HasSubstr("a column without a name"));
  EXPECT_THAT(told("time_s\n0\n"), HasSubstr("no column beside the times"));
  EXPECT_THAT(told("time_s,ZYG\n"), HasSubstr("c.csv: no rows"));
  EXPECT_THAT(told(""), HasSubstr("c.csv"));
  const Reading reading = read("steps: [move: {duration: 1 s, curves: nowhere.csv}]\n");
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].where, "nowhere.csv");
}

TEST_F(MoveByTable, MayNotRepeatACurveOfTheStep) {
  EXPECT_EQ(told("time_s,ZYG\n0,0\n", "      ZYG: 0.3\n"),
            "c.csv:1:8: 'ZYG' has a curve in the step as well; expected one curve for each name\n"
            "    the other is at x.yaml:5:7\n");
}

TEST(Move, TellsEverythingThatIsWrongWithItsCurves) {
  EXPECT_EQ(
      problems_of("steps:\n"
                  "  - move:\n"
                  "      duration: 0.5 s\n"
                  "      frames: 0\n"
                  "      method: fast\n"
                  "      ZYG: [[0 s, 0], [0.2 s, 1.5], [0.2, 0.3], 5]\n"
                  "      RIS: [[0.3 s, 0], [0.1 s, 0.3], [0.1 s, 0.4], [2 s, 0]]\n"
                  "      DAO: []\n"
                  "      LAO: {a: 1}\n"),
      "x.yaml:4:15: 0 is out of range; expected at least 1 and at most 10000\n"
      "x.yaml:5:15: 'fast' is unknown\n    known: dynamic, quasi_static\n"
      "x.yaml:6:31: 1.5 is out of range; expected at least 0 and at most 1\n"
      "x.yaml:6:38: 0.2 has no unit; expected a time such as 0.2 s\n"
      "x.yaml:6:49: the value '5'; expected a point such as [0.2 s, 0.5]\n"
      "x.yaml:7:26: the time 0.1 s is earlier than the one before it; expected times that grow\n"
      "    sort the points by their times\n"
      "x.yaml:7:40: the time 0.1 s is the same as the one before it; expected times that grow\n"
      "    a jump needs two different times, however near each other\n"
      "x.yaml:7:54: the time 2 s lies outside the step; expected 0 s to 0.5 s\n"
      "x.yaml:8:12: no points; expected a number, or points such as [[0 s, 0], [0.2 s, 0.5]]\n"
      "x.yaml:9:12: a mapping; expected a number, or points such as [[0 s, 0], [0.2 s, 0.5]]\n");
}

TEST(Move, NeedsADurationAndMuscles) {
  EXPECT_THAT(problems_of("steps: [move: {ZYG: 1}]\n"), HasSubstr("without a duration"));
  EXPECT_THAT(problems_of("steps: [move: {duration: 0 s, ZYG: 1}]\n"),
              HasSubstr("x.yaml:1:26: 0 s is out of range"));
  EXPECT_THAT(problems_of("steps: [move: {duration: 1 s}]\n"), HasSubstr("without muscles"));
}

TEST(Move, ReadsAndWritesTheSame) {
  Reading reading = read(
      "dynamics: {rayleigh_alpha: 12.5 1/s, rayleigh_beta: 3 ms, rho_inf: 1}\n"
      "steps: [move: {duration: 1 s, frames: 3, method: quasi_static, ZYG: [[0.1 s, 0], [0.3 s, "
      "0.7]], \"no\": 0.2}]\n");
  Reading again = read(to_yaml(reading.scenario));
  ASSERT_TRUE(again.problems.empty()) << to_string(again.problems.front());
  reading.scenario.written_at.clear();
  again.scenario.written_at.clear();
  EXPECT_EQ(again.scenario, reading.scenario);
  EXPECT_DOUBLE_EQ(again.scenario.dynamics.rayleigh_alpha, 12.5);
}

}  // namespace
}  // namespace facies::scenario
