// SPDX-License-Identifier: Apache-2.0
// facies info and what can be asked of a face, as people use them.
#include <algorithm>
#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace facies::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Info : public ProgramTest {
 protected:
  [[nodiscard]] std::size_t n_pictures(const std::string& name) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder() / name), fs::directory_iterator()));
  }
};

/// Small and quick to draw.
constexpr const char* small_patch = "info --face patch:ny=4,nz=4";

TEST_F(Info, TellsWhatTheBuiltinFaceWasMadeToHave) {
  const Outcome outcome = facies("info --face 'builtin:size=coarse,mouth_width=56 mm'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(ContainsRegex("mouth_width +56\\.00 +56\\.00 +40 to 62   width of the mouth"),
                    ContainsRegex("chin_height +[0-9]+\\.[0-9]+ +20 to 40"),
                    ContainsRegex("depth_nasion +[0-9.]+ +5 to 8")));
}

TEST_F(Info, OfAFaceThatIsNotMadeFromMeasuresHasNone) {
  EXPECT_THAT(facies(small_patch).out, Not(HasSubstr("asked [mm]")));
}

TEST_F(Info, WithoutAFolderWritesNothing) {
  EXPECT_EQ(facies(small_patch).status, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder()), fs::directory_iterator()), 2)
      << "more than out.txt and err.txt";
}

TEST_F(Info, DrawsTheAnatomyIntoAFolder) {
  const Outcome outcome = facies(std::string(small_patch) + " --out pictures");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("pictures in pictures: overview.png skin.png"));
  for (const char* name : {"overview", "skin", "muscles", "layers", "tension-lines", "landmarks"})
    EXPECT_TRUE(fs::exists(folder() / "pictures" / (std::string(name) + ".png"))) << name;
  EXPECT_FALSE(fs::exists(folder() / "pictures" / "bones.png"));
}

TEST_F(Info, ReplacesPicturesOnlyWhenForced) {
  const std::string command = std::string(small_patch) + " --out pictures";
  EXPECT_EQ(facies(command).status, 0);
  const std::size_t n = n_pictures("pictures");
  const Outcome refused = facies(command);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.out, IsEmpty());
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("pictures: holds pictures of a face"), HasSubstr("--force")));
  EXPECT_EQ(n_pictures("pictures"), n);
  EXPECT_EQ(facies(command + " --force").status, 0);
  write("pictures/mine.txt", "x");
  const Outcome foreign = facies(command + " --force");
  EXPECT_EQ(foreign.status, 2);
  EXPECT_THAT(foreign.err, HasSubstr("mine.txt"));
  EXPECT_EQ(n_pictures("pictures"), n + 1);
}

TEST_F(Info, LeavesNothingBehindWhereTheFaceIsWrong) {
  for (const char* face : {"artisynth:/nonexistent", "nosuch", "'builtin:mouth_width=99 mm'",
                           "'builtin:mouth_width=50'"}) {
    const Outcome outcome = facies(std::string("info --out pictures --face ") + face);
    EXPECT_NE(outcome.status, 0) << face;
    EXPECT_THAT(outcome.out, IsEmpty()) << face;
    EXPECT_FALSE(fs::exists(folder() / "pictures")) << face;
  }
}

TEST_F(Info, NeedsAFolderToForce) {
  const Outcome outcome = facies(std::string(small_patch) + " --force");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--out"));
}

TEST_F(Info, NamesEveryLengthOfTheBuiltinFaceThatIsWrong) {
  const Outcome outcome =
      facies("info --face 'builtin:mouth_width=99 mm,nose_with=30 mm,face_height=120'");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("builtin:mouth_width: 99 mm; expected 40 mm to 62 mm"),
                    HasSubstr("did you mean 'nose_width'?"), HasSubstr("builtin:face_height")));
}

TEST_F(Info, HasAListOfWhatOneMayAskFor) {
  EXPECT_THAT(facies("list faces").out,
              AllOf(HasSubstr("builtin:size=standard,preset=male,KEY=N mm"),
                    HasSubstr("facies list measures")));
  const Outcome outcome = facies("list measures");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(ContainsRegex("mouth_width +52 +49 +40 to 62"),
                                 ContainsRegex("chin_height +follows +follows +20 to 40"),
                                 ContainsRegex("depth_nasion +as drawn +as drawn +5 to 8")));
}

}  // namespace
}  // namespace facies::cli
