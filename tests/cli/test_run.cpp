// SPDX-License-Identifier: Apache-2.0
// `facies run` on a small sheet of skin: what it prints, what it leaves behind, and with which exit status it ends.
#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace facies::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A sheet that takes a fraction of a second.
const std::string small =
    "run patch-stretch --face patch:width=30,height=30,ny=4,nz=4 --no-pictures ";
/// The same, stretched beyond what any iteration can reach, in many iterations.
const std::string diverging = small + "--set tension.tsf=2 --set muscle.sigma_max='5000 kPa' ";

class Run : public ProgramTest {
 protected:
  [[nodiscard]] bool has(const std::string& path) const {
    return std::filesystem::exists(folder() / path);
  }
};

TEST_F(Run, EndsWithATableAndAFolderOfResults) {
  const Outcome outcome = facies(small);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("CENTER"), HasSubstr("done in"), HasSubstr("out/patch-stretch")));
  EXPECT_THAT(outcome.err, HasSubstr("step 3/3 express, increment 1, load 0 to 1: converged"));
  EXPECT_TRUE(has("out/patch-stretch/scenario.yaml"));
  EXPECT_TRUE(has("out/patch-stretch/landmarks.csv"));
}

TEST_F(Run, CanBeRepeatedFromTheScenarioItLeaves) {
  ASSERT_EQ(facies(small + "--out first --set express.STRIP=0.3").status, 0);
  ASSERT_EQ(facies("run first/scenario.yaml --no-pictures --out second").status, 0);
  for (const char* file : {"/landmarks.csv", "/scenario.yaml", "/distances.csv"}) {
    EXPECT_EQ(read_file(folder() / ("first" + std::string(file))),
              read_file(folder() / ("second" + std::string(file))));
  }
}

TEST_F(Run, MovesInTimeAndRecordsIt) {
  write("curves.csv", "time_s,STRIP\n0,0\n0.05,0.4\n0.1,0.4\n");
  write("move.yaml",
        "face: patch:width=30,height=30,ny=4,nz=4\noutput: {pictures: false}\n"
        "steps:\n  - move: {duration: 0.1 s, frames: 4, curves: curves.csv}\n");
  const Outcome outcome = facies("run move.yaml --out here");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read_file(folder() / "here/motion.csv"), HasSubstr("\nmove,0.025,CENTER,"));
  EXPECT_THAT(read_file(folder() / "here/energy.csv"), HasSubstr("\nmove,0.1,"));
  EXPECT_THAT(read_file(folder() / "here/motion.pvd"),
              AllOf(HasSubstr("timestep=\"0.05\""), HasSubstr("fields/01-move-002.vtu")));
  EXPECT_THAT(read_file(folder() / "here/summary.json"), HasSubstr("curves.csv"));
  EXPECT_EQ(facies("run here/scenario.yaml --out again").status, 0);
  for (const char* file : {"/motion.csv", "/energy.csv", "/scenario.yaml"}) {
    EXPECT_EQ(read_file(folder() / ("here" + std::string(file))),
              read_file(folder() / ("again" + std::string(file))));
  }
}

TEST_F(Run, EndsWithStatus5WhereAMotionCannotGoOn) {
  const Outcome outcome = facies(
      "run patch-twitch --face patch:width=30,height=30,ny=4,nz=4 --no-pictures "
      "--set 'dynamics.tolerance=1e-9 mm' --set 'dynamics.smallest_step=0.5 ms'");
  EXPECT_EQ(outcome.status, 5);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("move did not converge"), HasSubstr("the error is"),
                                 HasSubstr("even in a step of")));
}

TEST_F(Run, ReplacesResultsOnlyWhenForced) {
  ASSERT_EQ(facies(small + "--out here").status, 0);
  const Outcome refused = facies(small + "--out here");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(facies(small + "--out here --force").status, 0);
}

TEST_F(Run, EndsWithStatus2WhereItCannotWrite) {
  write("file", "");
  EXPECT_EQ(facies(small + "--out file/results").status, 2);
  EXPECT_EQ(facies(small + "--out /proc/results").status, 2);
  EXPECT_EQ(facies(small + "--out no/such/folder").status, 2);
}

TEST_F(Run, LeavesNothingBehindWhereNothingWasWritten) {
  EXPECT_EQ(facies("run smile-open").status, 3);  // the patch has none of its muscles
  EXPECT_EQ(facies("run patch-stretch --face artisynth:/nonexistent").status, 4);
  EXPECT_FALSE(has("out"));
}

TEST_F(Run, SaysNothingWhenAskedToBeQuiet) {
  const Outcome outcome = facies(small + "-q");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST_F(Run, PrintsTheConvergenceTableWhenAskedTo) {
  const Outcome outcome = facies(small + "-v");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("iteration   |r| [mN]   relative"));
}

TEST_F(Run, ThatDivergesEndsWithStatus5AndSaysWhere) {
  const Outcome outcome =
      facies(diverging + "--set solver.max_iterations=4 --set solver.smallest_increment=0.5");
  EXPECT_EQ(outcome.status, 5) << outcome.out;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("error: patch-stretch: tension did not converge"),
                                 HasSubstr("element")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("done in")));
  EXPECT_TRUE(has("out/patch-stretch/summary.json"));
}

TEST_F(Run, ThatIsInterruptedEndsWithStatus130AndAReadableFolder) {
  const std::string command = "cd '" + folder().string() + "' && ('" FACIES_PROGRAM "' " +
                              diverging +
                              "--set solver.max_iterations=1000 -v 2> err.txt > out.txt & "
                              "pid=$!; while ! grep -q mN err.txt; do sleep 0.05; done; "
                              "kill -INT $pid; wait $pid)";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(read_file(folder() / "err.txt"), HasSubstr("interrupted; what was reached is in"));
  EXPECT_TRUE(has("out/patch-stretch/summary.json"));
}

}  // namespace
}  // namespace facies::cli
