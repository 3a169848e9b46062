// SPDX-License-Identifier: Apache-2.0
// `facies study` on a small sheet of skin: its table, what it leaves alone the second time, how it ends.
#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace facies::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

namespace fs = std::filesystem;

const std::string sheet = " --threads 1 --face patch:width=30,height=30,ny=4,nz=4 ";

const std::string two =
    "title: Two skins\nscenarios: [patch-stretch]\nvariants:\n"
    "  - {name: normal, about: as it ships}\n"
    "  - {name: stiff, set: {skin.preset: flynn2015_stiff}}\n";

class StudyCommand : public ProgramTest {
 protected:
  [[nodiscard]] fs::file_time_type time_of(const std::string& path) const {
    return fs::last_write_time(folder() / path);
  }
  [[nodiscard]] std::string text_of(const std::string& path) const {
    return read_file(folder() / path);
  }
};

TEST_F(StudyCommand, MeasuresWhatSingleRunsMeasure) {
  write("two.yaml", two);
  const Outcome outcome = facies("study two.yaml --out here" + sheet);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("CENTER"), HasSubstr("\nnormal "), HasSubstr("\nstiff ")));
  EXPECT_THAT(outcome.err, HasSubstr("2/2 stiff/patch-stretch: done after"));
  EXPECT_THAT(text_of("here/study.md"), AllOf(HasSubstr("# Two skins"), HasSubstr("as it ships")));
  EXPECT_EQ(text_of("here/study.yaml"), two);
  const std::string set = "--set skin.preset=flynn2015_stiff";
  ASSERT_EQ(facies("run patch-stretch --no-pictures --out one " + set + sheet).status, 0);
  EXPECT_EQ(text_of("here/stiff/patch-stretch/landmarks.csv"), text_of("one/landmarks.csv"));
  const std::string csv = text_of("here/study.csv");
  const std::size_t at = csv.find("stiff,patch-stretch,displacement CENTER,mm,");
  ASSERT_NE(at, std::string::npos);
  const std::string value = csv.substr(at + 43, csv.find(',', at + 43) - at - 43);
  EXPECT_THAT(text_of("one/landmarks.csv"), HasSubstr(',' + value + '\n'));
}

TEST_F(StudyCommand, KeepsWhatIsFinishedAndRunsWhatWasKilledOrIsSaidDifferently) {
  write("two.yaml", two);
  ASSERT_EQ(facies("study two.yaml --out here" + sheet).status, 0);
  const std::string table = text_of("here/study.csv");
  const std::string kept = "here/normal/patch-stretch/fields/03-express.vtu";
  const std::string killed = "here/stiff/patch-stretch/fields/03-express.vtu";
  const auto kept_time = time_of(kept);
  const auto killed_time = time_of(killed);
  const std::string summary = "here/stiff/patch-stretch/summary.json";
  std::string text = text_of(summary);
  text.replace(text.find("\"done\""), 6, "\"running\"");  // as a killed run leaves it
  write(summary, text);
  const Outcome outcome = facies("study two.yaml --out here" + sheet);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("normal/patch-stretch: finished before"),
                                 HasSubstr("stiff/patch-stretch: done after")));
  EXPECT_EQ(time_of(kept), kept_time);
  EXPECT_GT(time_of(killed), killed_time);
  EXPECT_EQ(text_of("here/study.csv"), table);
  std::string changed = two;
  changed.replace(changed.find("flynn2015_stiff"), 15, "flynn2015_soft");
  write("two.yaml", changed);
  EXPECT_THAT(facies("study two.yaml --out here" + sheet).err,
              AllOf(HasSubstr("normal/patch-stretch: finished before"),
                    HasSubstr("stiff/patch-stretch: done after")));
  EXPECT_EQ(time_of(kept), kept_time);
}

TEST_F(StudyCommand, MarksWhatDoesNotConvergeAndEndsWithStatus5) {
  write("three.yaml",
        "scenarios: [patch-stretch]\nvariants:\n  - name: torn\n"
        "    set: {tension.tsf: 2, muscle.sigma_max: 5000 kPa, solver.max_iterations: 4,\n"
        "          solver.smallest_increment: 0.5}\n  - name: whole\n");
  const Outcome outcome = facies("study three.yaml --out here" + sheet);
  EXPECT_EQ(outcome.status, 5);
  EXPECT_THAT(outcome.out, HasSubstr("\ntorn     failed  failed"));
  EXPECT_LT(outcome.out.find("\nwhole"), outcome.out.find("\ntorn"));
  EXPECT_THAT(outcome.err, HasSubstr("error: torn/patch-stretch: tension did not converge"));
  EXPECT_THAT(text_of("here/study.md"),
              HasSubstr("- `torn/patch-stretch`: tension did not converge"));
}

TEST_F(StudyCommand, WritesNothingWhereTheStudyIsWrong) {
  write("bad.yaml",
        "scenarios: [patch-stretch]\nvariants:\n  - {name: a, set: {express.STRAP: 0.5}}\n"
        "  - {name: b, set: {muscle.leave_out: STRIP.2}}\n");
  const Outcome outcome = facies("study bad.yaml --out here" + sheet);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad.yaml:3:21: this face has no muscle 'STRAP'"),
                                 HasSubstr("bad.yaml:4:39: this face has no fibre 'STRIP.2'")));
  EXPECT_FALSE(fs::exists(folder() / "here"));
}

TEST_F(StudyCommand, TakesAnotherFolderThanItsOwnOnlyWhenForced) {
  write("two.yaml", two);
  ASSERT_EQ(facies("run patch-stretch --no-pictures --out here" + sheet).status, 0);
  const Outcome refused = facies("study two.yaml --out here" + sheet);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  ASSERT_EQ(facies("study two.yaml --force --out here" + sheet).status, 0);
  EXPECT_FALSE(fs::exists(folder() / "here/landmarks.csv"));
  EXPECT_FALSE(fs::exists(folder() / "here/fields"));
  write("mine", "");
  EXPECT_EQ(facies("study two.yaml --force --out ." + sheet).status, 2);
}

}  // namespace
}  // namespace facies::cli
