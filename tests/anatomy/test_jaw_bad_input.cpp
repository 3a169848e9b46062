// SPDX-License-Identifier: Apache-2.0
// Tables of a jaw that cannot be used: each is refused with a message that names the file, the line and the remedy.
#include <gmock/gmock.h>

#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// What is told after `old` became `with` in a table of the synthetic jaw.
std::string told_after(const std::string& table, const std::string& old, const std::string& with) {
  const SyntheticFace files;
  SyntheticFace::replace_all(files.tables() / table, old, with);
  return files.message();
}

TEST(BadJaw, IsNotTheOneAsWritten) {
  EXPECT_EQ(SyntheticFace().message(), "");
}

TEST(BadJaw, WithAMuscleOnAnUnknownBoneNamesTheNearest) {
  EXPECT_THAT(told_after("jaw-muscles.csv", "50,jaw,30,10", "50,jow,30,10"),
              AllOf(HasSubstr("jaw-muscles.csv:3:34: 'jow'; expected a bone of jaw-bones.csv for "
                              "muscle rm"),
                    HasSubstr("did you mean 'jaw'?")));
}

TEST(BadJaw, WithAMuscleWhoseEndsCoincideNamesIt) {
  EXPECT_THAT(
      told_after("jaw-muscles.csv", "jaw,30,10,15", "jaw,30,10,50"),
      AllOf(HasSubstr("jaw-muscles.csv:3:"), HasSubstr("both ends of muscle rm at one place")));
}

TEST(BadJaw, WithAMuscleWithinOneBoneNamesIt) {
  EXPECT_THAT(told_after("jaw-muscles.csv", "50,jaw,30,10", "50,skull,30,10"),
              AllOf(HasSubstr("jaw-muscles.csv:3:34: both ends of muscle rm on skull"),
                    HasSubstr("expected two different bones")));
}

TEST(BadJaw, WithImpossibleMusclesNamesEveryNumber) {
  const std::string told =
      told_after("jaw-muscles.csv", ",190.4,30,40,0.46,0.015,1,", ",0,30,20,1.0,-0.1,nan,");
  EXPECT_THAT(
      told,
      AllOf(HasSubstr("0; expected more than 0"), HasSubstr("20; expected more than opt_length_mm"),
            HasSubstr("1; expected 0 or more and less than 1"),
            HasSubstr("-0.1; expected 0 or more"), HasSubstr("'nan'; expected a number")));
  EXPECT_THAT(told, AllOf(HasSubstr("jaw-muscles.csv:2:"), HasSubstr("jaw-muscles.csv:3:")));
  EXPECT_THAT(told_after("jaw-muscles.csv", "lm,left", "lm,sinister"),
              HasSubstr("'sinister'; expected left, right or middle"));
}

TEST(BadJaw, WithAnExciterOfUnknownMusclesNamesThem) {
  EXPECT_THAT(told_after("jaw-exciters.csv", "rm lm", "rm lx"),
              AllOf(HasSubstr("jaw-exciters.csv:2:15: 'lx'"), HasSubstr("did you mean 'lm'?")));
  EXPECT_THAT(told_after("jaw-exciters.csv", "rm lm", "rm rm"), HasSubstr("'rm' twice"));
  EXPECT_THAT(told_after("jaw-exciters.csv", "rm lm", ""), HasSubstr("no muscle"));
}

TEST(BadJaw, WithAnExciterNamedLikeAMuscleIsRefused) {
  EXPECT_THAT(told_after("jaw-exciters.csv", "close,", "lm,"), HasSubstr("no other row has"));
}

TEST(BadJaw, WithoutABoneThatMovesOrWithTwo) {
  EXPECT_THAT(told_after("jaw-bones.csv", "jaw,m,1", "jaw,m,0"),
              HasSubstr("jaw-bones.csv: 0 bones that move; expected one"));
  EXPECT_THAT(
      told_after("jaw-bones.csv", "skull,m,0,,,,,,,,,,,,", "skull,m,1,1,0,0,0,1,1,1,0,0,0,0,0"),
      HasSubstr("2 bones that move"));
}

TEST(BadJaw, WithAnImpossibleMassOrInertia) {
  EXPECT_THAT(told_after("jaw-bones.csv", "1,0.2,30", "1,-0.2,30"),
              HasSubstr("-0.2; expected more than 0"));
  EXPECT_THAT(told_after("jaw-bones.csv", "200,150,250", "200,150,2500"),
              AllOf(HasSubstr("jaw-bones.csv:3:"), HasSubstr("principal moments of inertia"),
                    HasSubstr("larger than the other two")));
}

TEST(BadJaw, WithoutAPoseOrWithAStrangeOne) {
  EXPECT_THAT(told_after("jaw-poses.csv", "intercuspal", "yawning"),
              AllOf(HasSubstr("'yawning'; expected 'start' or 'intercuspal'"),
                    HasSubstr("no pose 'intercuspal'")));
  EXPECT_THAT(told_after("jaw-poses.csv", "0,1,0,90", "0,2,0,90"),
              HasSubstr("an axis of length 2; expected length 1"));
}

TEST(BadJaw, LedByPointsThatAreNotItsOwn) {
  EXPECT_THAT(
      told_after("jaw-guides.csv", "condyle", "upper"),
      HasSubstr("jaw-guides.csv:2:7: 'upper' of skull; expected a point of the bone that moves"));
  EXPECT_THAT(told_after("jaw-stops.csv", ",lower,", ",lowre,"),
              AllOf(HasSubstr("jaw-stops.csv:2:8: 'lowre'"), HasSubstr("did you mean 'lower'?")));
}

TEST(BadJaw, WithAPathOfNoLengthOrANormalThatIsNone) {
  EXPECT_THAT(told_after("jaw-guides.csv", ",12,", ",0,"), HasSubstr("0; expected more than 0"));
  EXPECT_THAT(told_after("jaw-stops.csv", "0,0,-1,", "0,0,0,"),
              HasSubstr("a normal of length 0; expected length 1"));
}

TEST(BadJaw, WithASurfaceThatIsNotThereNamesItsFile) {
  const SyntheticFace files;
  std::filesystem::remove(files.geometry("jaw.obj"));
  EXPECT_THAT(files.message(), AllOf(HasSubstr("jaw.obj: no such file"),
                                     HasSubstr("the surface 'jaw' of jaw-surfaces.csv")));
  EXPECT_THAT(told_after("jaw-surfaces.csv", ",1000,", ",0,"),
              HasSubstr("0; expected more than 0"));
  EXPECT_THAT(told_after("jaw-surfaces.csv", ",solid,", ",liquid,"),
              HasSubstr("'liquid'; expected solid, shell or cast"));
  EXPECT_THAT(told_after("jaw-crowns.csv", "jaw,0,0,1,", "jaw,0,0,2,"),
              HasSubstr("a normal of length 2; expected length 1"));
}

TEST(BadJaw, WithAnOpenSurfaceIsRefusedWhereItsTableSaysClosed) {
  const SyntheticFace files;
  SyntheticFace::replace_all(files.geometry("jaw.obj"), "f 1 3 4 2\n", "");
  EXPECT_THAT(files.message(), AllOf(HasSubstr("jaw.obj: a border of 4 edges"),
                                     HasSubstr("say 0 under 'closed' in jaw-surfaces.csv")));
  SyntheticFace::replace_all(files.tables() / "jaw-surfaces.csv", ",1000,1,", ",1000,0,");
  EXPECT_EQ(files.message(), "");
  EXPECT_EQ(files.read().jaw->surfaces.at(0).surface.triangles.size(), 10U);
  EXPECT_THAT(told_after("jaw-surfaces.csv", ",1000,1,", ",1000,yes,"), HasSubstr("'yes'"));
}

TEST(BadJaw, IsToldOfTogetherWithItsBones) {
  const SyntheticFace files;
  SyntheticFace::replace_all(files.geometry("jaw.obj"), "0.0", "0.00");
  SyntheticFace::replace_all(files.tables() / "jaw-muscles.csv", "jaw,30,10,15", "jaw,30,10,50");
  EXPECT_THAT(files.message(),
              AllOf(HasSubstr("both ends of muscle rm at one place"),
                    HasSubstr("jaw.obj: a bone of 5.196 mm, 0.005196 in the file's unit")));
}

TEST(BadJaw, WithoutItsTablesNamesAllOfThem) {
  const SyntheticFace files;
  std::filesystem::remove(files.tables() / "jaw-bones.csv");
  std::filesystem::remove(files.tables() / "jaw-stops.csv");
  EXPECT_THAT(files.message(), AllOf(HasSubstr("jaw-bones.csv: no such file"),
                                     HasSubstr("jaw-stops.csv: no such file")));
}

TEST(BadJaw, WithAMissingColumnSaysOnlyThat) {
  const std::string told = told_after("jaw-bones.csv", "moves", "mvoes");
  EXPECT_THAT(told, HasSubstr("did you mean 'mvoes'?"));
  EXPECT_THAT(told, testing::Not(HasSubstr("jaw-muscles.csv")));
}

}  // namespace
}  // namespace facies::anatomy
