// SPDX-License-Identifier: Apache-2.0
// Study files: what they give, and exactly what people are told who get them wrong.
#include <filesystem>
#include <gmock/gmock.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/study.hpp"

namespace facies::scenario {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

class ReadStudy : public testing::Test {
 public:
  ReadStudy(const ReadStudy&) = delete;
  ReadStudy& operator=(const ReadStudy&) = delete;
  ReadStudy(ReadStudy&&) = delete;
  ReadStudy& operator=(ReadStudy&&) = delete;

 protected:
  ReadStudy()
      : folder_(fs::path(testing::TempDir()) /
                ("facies-study-" + std::to_string(::getpid()) + "-" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
    write_file(folder_ / "pull.yaml", "steps: [tension, release, express: {STRIP: 0.5}]\n");
    write_file(folder_ / "relax.yaml", "steps: [tension, release]\n");
  }
  ~ReadStudy() override { fs::remove_all(folder_); }

  [[nodiscard]] StudyReading read(const std::string& text,
                                  const std::optional<std::string>& face = {}) const {
    write_file(folder_ / "x.yaml", text);
    return read_study_reporting(folder_ / "x.yaml", FACIES_SOURCE_DIR, face);
  }

  /// Every problem, one below the other, places without the folder.
  [[nodiscard]] std::string problems_of(const std::string& text) const {
    std::string all;
    for (const Problem& problem : read(text).problems)
      all += to_string(problem) + '\n';
    const std::string folder = folder_.string() + '/';
    for (std::size_t at = all.find(folder); at != std::string::npos; at = all.find(folder))
      all.erase(at, folder.size());
    return all;
  }

  fs::path folder_;
};

const std::string two = "scenarios: [pull.yaml, relax.yaml]\n";

TEST_F(ReadStudy, MakesARunOfEveryVariantAndScenario) {
  const StudyReading reading =
      read("title: Two\n" + two +
           "variants:\n"
           "  - {name: as-is, about: nothing changed}\n"
           "  - {name: soft, set: {skin.c: 2 kPa, tension.tsf: 1.2}}\n"
           "  - {name: weak, set: {express.STRIP: 0.1}, scenarios: [pull.yaml]}\n");
  ASSERT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
  const Study& study = reading.study;
  EXPECT_EQ(study.title, "Two");
  EXPECT_EQ(study.name, "x");
  EXPECT_EQ(study.variants.at(0).about, "nothing changed");
  std::vector<std::string> runs;
  for (const StudyRun& run : study.runs)
    runs.push_back(run.variant + "/" + run.scenario.name);
  EXPECT_THAT(runs,
              ElementsAre("as-is/pull", "as-is/relax", "soft/pull", "soft/relax", "weak/pull"));
  EXPECT_EQ(study.runs[0].scenario.skin.values.at("c"), 21.3);
  EXPECT_EQ(study.runs[3].scenario.skin.values.at("c"), 2.0);
  EXPECT_EQ(std::get<TensionStep>(study.runs[2].scenario.steps[0]).tsf, 1.2);
  EXPECT_EQ(std::get<ExpressStep>(study.runs[4].scenario.steps[2]).activations.at("STRIP"), 0.1);
}

TEST_F(ReadStudy, TakesScenariosThatShipByName) {
  const StudyReading reading =
      read("scenarios: [patch-stretch]\nvariants: [{name: a}]\n", "patch:width=30");
  ASSERT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
  EXPECT_EQ(reading.study.runs.at(0).scenario.name, "patch-stretch");
  EXPECT_EQ(reading.study.runs.at(0).scenario.face, "patch:width=30");
}

TEST_F(ReadStudy, NamesEveryProblemAtOnceWithItsPlace) {
  EXPECT_EQ(
      problems_of("titel: Two\n"
                  "scenarios: [pull.yaml, relax.yaml, pul.yaml]\n"
                  "variants:\n"
                  "  - name: a\n"
                  "    set: {skin.c: 3, skni.c: 3 kPa, express.STRIP: 2}\n"
                  "  - {name: a, abuot: x}\n"
                  "  - {name: ../b, scenarios: []}\n"
                  "  - set: [skin.c]\n"
                  "  - c\n"),
      "x.yaml:1:1: unknown key 'titel'\n    did you mean 'title'?\n"
      "x.yaml:2:36: 'pul.yaml': no such file\n    known: lips-down, mouth-open, "
      "patch-stretch, patch-twitch, purse, smile-closed, smile-open\n"
      "x.yaml:5:19: 3 has no unit; expected a pressure such as 3 kPa\n"
      "x.yaml:5:22: unknown key 'skni'\n    did you mean 'skin'?\n"
      "x.yaml:5:37: the scenario has 0 express steps (in relax.yaml); expected exactly one for "
      "this short form\n    write steps.N.express.STRIP, N counted from 1\n"
      "x.yaml:5:52: 2 is out of range; expected at least 0 and at most 1\n"
      "x.yaml:6:12: the variant 'a' is given twice\n    the first one is at x.yaml:4:11\n"
      "x.yaml:6:15: unknown key 'abuot' in a variant\n    did you mean 'about'?\n"
      "x.yaml:7:12: '../b' cannot name a variant's folder; expected at most 100 letters, "
      "digits and - _ . + =, not beginning with '.' or 'study.'\n"
      "x.yaml:7:29: an empty list; expected a list of scenarios such as [smile-open, purse]\n"
      "x.yaml:8:5: a variant without a name; expected name: ...\n"
      "x.yaml:8:10: a list; expected KEY: VALUE as for --set\n"
      "x.yaml:9:5: the value 'c'; expected a variant: {name: ..., set: {KEY: VALUE}}\n");
}

TEST_F(ReadStudy, TellsOfABadScenarioOnce) {
  write_file(folder_ / "pull.yaml", "density: 3\nsteps: [tension]\n");
  EXPECT_EQ(problems_of("scenarios: [pull.yaml]\nvariants: [{name: a}, {name: b}]\n"),
            "pull.yaml:1:10: 3 has no unit; expected a density such as 3 kg/m^3\n");
}

TEST_F(ReadStudy, WantsScenariosAndVariants) {
  EXPECT_EQ(problems_of("title: none\n"),
            "x.yaml: no scenarios; expected scenarios: a list\n"
            "x.yaml: no variants; expected variants: a list\n");
  EXPECT_THAT(problems_of(""), StartsWith("x.yaml: is empty; expected a study with variants"));
  EXPECT_EQ(problems_of("- a\n"),
            "x.yaml:1:1: a list; expected a study: a mapping of keys such as 'variants'\n");
  EXPECT_THAT(problems_of("scenarios: [\n"), HasSubstr("not YAML"));
}

TEST_F(ReadStudy, KeepsRunsOfAVariantApart) {
  write_file(folder_ / "again.yaml", "expression: pull\nsteps: [tension]\n");
  EXPECT_EQ(problems_of("scenarios: [pull.yaml, pull.yaml]\nvariants: [{name: a}]\n"),
            "x.yaml:1:24: a second scenario called 'pull'\n");
  EXPECT_EQ(
      problems_of("scenarios: [pull.yaml, again.yaml]\nvariants: [{name: a}]\n"),
      "x.yaml:1:24: 'pull' and 'again' are both compared with the expression 'pull'; expected "
      "one of them in a variant\n");
}

TEST(ShippedStudy, IsReadWithoutAProblem) {
  const auto files = shipped_studies(FACIES_SOURCE_DIR);
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const StudyReading reading = read_study_reporting(file, FACIES_SOURCE_DIR);
    EXPECT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
    EXPECT_FALSE(reading.study.title.empty());
    EXPECT_EQ(find_study(file.stem().string(), FACIES_SOURCE_DIR), file);
  }
}

}  // namespace
}  // namespace facies::scenario
