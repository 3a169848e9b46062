// SPDX-License-Identifier: Apache-2.0
// The program as people use it: what it prints, where, and with which exit status it ends.
#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace facies::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Program : public ProgramTest {};

TEST_F(Program, TellsItsVersion) {
  const Outcome outcome = facies("--version");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "facies " FACIES_VERSION "\n");
}

TEST_F(Program, HelpsWithExamplesFirst) {
  for (const char* command : {"", "run ", "study ", "check ", "info ", "list ", "schema "}) {
    const Outcome outcome = facies(std::string(command) + "--help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_THAT(outcome.err, IsEmpty());
    const std::size_t examples = outcome.out.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << command;
    EXPECT_LT(examples, outcome.out.find("--help")) << command;
  }
}

TEST_F(Program, EndsWithStatus2ForACommandLineThatMakesNoSense) {
  for (const char* arguments :
       {"", "rnu patch-stretch", "run", "run patch-stretch --colour",
        "run patch-stretch --threads -1", "run patch-stretch --threads many",
        "run patch-stretch -v -q", "list", "list everything", "check patch-stretch --set skin.c",
        "check patch-stretch --face nosuch", "check a b"}) {
    const Outcome outcome = facies(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    EXPECT_THAT(outcome.err, Not(IsEmpty())) << arguments;
  }
  EXPECT_THAT(facies("rnu").err, HasSubstr("facies rnu: no such command\n    did you mean 'run'?"));
  EXPECT_THAT(facies("smile").err,
              HasSubstr("facies smile: no such command\n    known: run, study, check"));
}

TEST_F(Program, NamesEveryProblemOfAScenarioAtOnce) {
  write("bad.yaml", "steps:\n  - tension: {tsf: 0}\n  - express: {STRAP: 0.5}\nskin: {c: 21.3}\n");
  const Outcome outcome = facies("check bad.yaml --set nam=x");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err,
              HasSubstr("error: bad.yaml:2:20: 0 is out of range; expected more than 0.5"));
  EXPECT_THAT(
      outcome.err,
      HasSubstr("error: bad.yaml:4:11: 21.3 has no unit; expected a pressure such as 21.3 kPa"));
  EXPECT_THAT(outcome.err,
              HasSubstr("error: --set nam: unknown key 'nam'\n    did you mean 'name'?"));
  EXPECT_THAT(
      outcome.err,
      HasSubstr(
          "error: bad.yaml:3:15: this face has no muscle 'STRAP'\n    did you mean 'STRIP'?"));
  EXPECT_THAT(outcome.err, HasSubstr("4 problems"));
}

TEST_F(Program, DoesNotRunABadScenario) {
  write("bad.yaml", "steps: [release]\n");
  const Outcome outcome = facies("run bad.yaml");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err,
              StartsWith("error: bad.yaml:1:9: a release without a tension before it"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "out"));
}

TEST_F(Program, EndsWithStatus3ForAScenarioThatIsNotThere) {
  EXPECT_EQ(facies("check nosuch.yaml").status, 3);
  const Outcome outcome = facies("run patch-strech");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'patch-stretch'?"));
}

TEST_F(Program, EndsWithStatus4ForAFaceThatCannotBeRead) {
  EXPECT_EQ(facies("check patch-stretch --face artisynth:/nonexistent").status, 4);
  EXPECT_EQ(facies("info --face artisynth:/nonexistent").status, 4);
}

TEST_F(Program, ChecksAGoodScenario) {
  const Outcome outcome = facies("check patch-stretch");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("patch-stretch: no problem found (patch: 324 nodes"));
}

TEST_F(Program, TellsThatAnExpressionNeedsAFaceWithItsMuscles) {
  const Outcome outcome = facies("check smile-open");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err, HasSubstr("this face has no muscle 'ZYG'"));
  EXPECT_THAT(outcome.err, HasSubstr("--face"));
}

TEST_F(Program, PrintsAResolvedScenarioThatResolvesToItself) {
  const Outcome first = facies("check patch-stretch --resolved --set skin.c=0.03MPa");
  EXPECT_EQ(first.status, 0);
  EXPECT_THAT(first.out, HasSubstr("  c: 30 kPa\n"));
  write("again.yaml", first.out);
  const Outcome second = facies("check again.yaml --resolved");
  EXPECT_EQ(second.status, 0);
  EXPECT_EQ(second.out, first.out);
}

TEST_F(Program, TellsWhatIsInAFace) {
  const Outcome outcome = facies("info --face patch");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* part :
       {"hexahedra", "skin", "hypodermis_inner", "STRIP", "landmark", "thickness"}) {
    EXPECT_THAT(outcome.out, HasSubstr(part));
  }
}

TEST_F(Program, ListsWhatCanBeNamed) {
  EXPECT_THAT(facies("list scenarios").out, HasSubstr("smile-open"));
  EXPECT_THAT(facies("list studies").out, HasSubstr("open-choices"));
  EXPECT_THAT(facies("list laws").out, HasSubstr("fung_orthotropic"));
  EXPECT_THAT(facies("list presets").out, HasSubstr("flynn2015_stiff"));
  EXPECT_THAT(facies("list faces").out, HasSubstr("artisynth:DIR"));
}

TEST_F(Program, SaysThatEverythingIsInPlace) {
  const Outcome outcome = facies("doctor");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("PETSc"));
  EXPECT_THAT(outcome.out, HasSubstr("data folder"));
}

TEST_F(Program, FindsItsDataWhereTheEnvironmentSays) {
  EXPECT_EQ(facies("list scenarios", "FACIES_DATA=/nonexistent").status, 2);
  std::filesystem::create_directories(folder() / "home" / "data");
  std::filesystem::create_directories(folder() / "home" / "scenarios");
  write("home/scenarios/mine.yaml", "title: only mine\nsteps: [tension]\n");
  EXPECT_THAT(facies("list scenarios", "FACIES_DATA=home").out,
              testing::MatchesRegex("mine +only mine\n"));
}

TEST_F(Program, FindsItsDataBesideItselfWhereItIsInstalled) {
  std::filesystem::create_directories(folder() / "bin");
  std::filesystem::create_directories(folder() / "share" / "facies" / "data");
  std::filesystem::create_directories(folder() / "share" / "facies" / "scenarios");
  write("share/facies/scenarios/mine.yaml", "title: only mine\nsteps: [tension]\n");
  std::filesystem::copy_file(FACIES_PROGRAM, folder() / "bin" / "facies");
  const std::string command =
      "cd '" + folder().string() + "' && bin/facies list scenarios > list.txt";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(read_file(folder() / "list.txt"), testing::MatchesRegex("mine +only mine\n"));
}

TEST_F(Program, EndsWithStatus2WhenItsOutputCannotBeWritten) {
  const std::string command = "'" FACIES_PROGRAM "' list laws > /dev/full 2> /dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
}

}  // namespace
}  // namespace facies::cli
