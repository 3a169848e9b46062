// SPDX-License-Identifier: Apache-2.0
// Bones, muscles and curves that cannot be used, through the program: named, with a status of their own, nothing written.
#include <gmock/gmock.h>

#include "anatomy/synthetic_face.hpp"
#include "cli/program.hpp"

namespace facies::cli {
namespace {

using anatomy::SyntheticFace;
using testing::AllOf;
using testing::HasSubstr;

/// A face of our own in the layout of artisynth_models, with a scenario that runs on it.
class BadFace : public ProgramTest {
 protected:
  BadFace() {
    namespace fs = std::filesystem;
    fs::create_directories(folder() / "home/data");
    fs::create_directories(folder() / "home/scenarios");
    fs::create_directory_symlink(files_.tables(), folder() / "home/data/reference-face");
    write("x.yaml", "face: artisynth:" + files_.models().string() +
                        "\njaw: held\ncontact: {bones: false}\noutput: {pictures: false}\n"
                        "steps:\n  - move: {duration: 0.1 s, curves: c.csv}\n");
    write("c.csv", "time_s,OOP\n0,0\n0.1,0.2\n");
  }

  [[nodiscard]] Outcome check() const {
    return facies("check x.yaml", "FACIES_DATA='" + (folder() / "home").string() + "'");
  }

  /// `facies check` and `facies run` say this, with status 4, and leave nothing behind.
  void expect_refused(const std::string& message) const {
    for (const char* command : {"check x.yaml", "run x.yaml --out here", "run x.yaml"}) {
      const Outcome outcome = facies(command, "FACIES_DATA='" + (folder() / "home").string() + "'");
      EXPECT_EQ(outcome.status, 4) << command;
      EXPECT_THAT(outcome.err, HasSubstr(message));
    }
    EXPECT_FALSE(std::filesystem::exists(folder() / "here"));
    EXPECT_FALSE(std::filesystem::exists(folder() / "out"));
  }

  void change_bone(const std::string& old, const std::string& with) const {
    SyntheticFace::replace_all(files_.geometry("jaw.obj"), old, with);
  }
  void change_table(const std::string& name, const std::string& old,
                    const std::string& with) const {
    SyntheticFace::replace_all(files_.tables() / name, old, with);
  }

  SyntheticFace files_;
};

TEST_F(BadFace, IsNotTheOneAsWritten) {
  const Outcome outcome = check();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(BadFace, WithAnOpenBone) {
  change_bone("f 1 2 6 5\n", "");
  expect_refused("jaw.obj: a border of 4 edges, the first near (15.0, -15.0, -15.0) mm");
}

TEST_F(BadFace, WithABoneInsideOut) {
  SyntheticFace::write(
      files_.geometry("jaw.obj"),
      "v 0 0 0\nv 0.03 0 0\nv 0 0.03 0\nv 0 0 0.03\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  expect_refused("jaw.obj: a surface that is inside out");
}

TEST_F(BadFace, WithABoneThatRunsThroughItself) {
  change_bone("v 0.015 -0.015 -0.015", "v 0.06 0.01 0.02");
  expect_refused("pairs of triangles through each other, counted from 1:");
}

TEST_F(BadFace, WithABoneInMillimetres) {
  change_bone("0.0", "");
  expect_refused("jaw.obj: a bone of 5.196e+04 mm, 51.96 in the file's unit");
}

TEST_F(BadFace, WithABoneInMetresThatItsTableSaysIsInMillimetres) {
  change_table("jaw-surfaces.csv", ",1000,1,", ",1,1,");
  expect_refused("the column 'scale' of jaw-surfaces.csv, now 1, takes the file's unit to mm");
}

TEST_F(BadFace, WithAMuscleWhoseEndsCoincide) {
  change_table("jaw-muscles.csv", "jaw,30,10,15", "jaw,30,10,50");
  expect_refused("both ends of muscle rm at one place");
}

TEST_F(BadFace, WithAMuscleOnABoneThatDoesNotExist) {
  change_table("jaw-muscles.csv", "50,jaw,30,10", "50,jow,30,10");
  expect_refused("jaw-muscles.csv:3:34: 'jow'; expected a bone of jaw-bones.csv for muscle rm");
}

TEST_F(BadFace, WithAJointThatCannotBeSatisfied) {
  write("x.yaml", "face: artisynth:" + files_.models().string() +
                      "\njaw: free\ncontact: {bones: false}\noutput: {pictures: false}\n"
                      "steps:\n  - tension: {tsf: 1.1}\n");
  change_table("jaw-stops.csv", "bite,m,lower,1,0,0,-1,0.5,s\n",
               "front,m,lower,1,1,0,0,-5,s\nback,m,lower,1,-1,0,0,-5,s\n");
  expect_refused("mm beyond the stop back; expected at most 0.1 mm");
}

TEST_F(BadFace, WithACurveThatIsNotSortedIsToldOfAllAtOnce) {
  write("c.csv", "time_s,OOP\n0,0\n0.1,0.2\n0.05,0.1\n");
  change_bone("f 1 2 6 5\n", "");
  change_table("jaw-muscles.csv", "jaw,30,10,15", "jaw,30,10,50");
  const Outcome outcome = check();
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("c.csv:4:1: the time 0.05 s is earlier than the one before it"),
                    HasSubstr("sort the points by their times"), HasSubstr("a border of 4 edges"),
                    HasSubstr("both ends of muscle rm at one place"), HasSubstr("3 problems")));
}

TEST_F(BadFace, WithACurveInTheScenarioThatIsNotSorted) {
  write("x.yaml",
        "steps:\n  - move: {duration: 0.1 s, STRIP: [[0 s, 0], [0.08 s, 0.2], [0.05 s, 0.1]]}\n");
  for (const char* command : {"check x.yaml", "run x.yaml"}) {
    const Outcome outcome = facies(command);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.err, HasSubstr("x.yaml:2:63: the time 0.05 s is earlier than the one"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder() / "out"));
}

}  // namespace
}  // namespace facies::cli
