// SPDX-License-Identifier: Apache-2.0
#include "scenario/reading.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/scenario/describe_schema.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/write_scenario.hpp"

namespace facies::scenario {
namespace {

void expect_same_after_writing(const Reading& reading) {
  ASSERT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
  Scenario written = reading.scenario;
  Reading again = read(to_yaml(written));
  ASSERT_TRUE(again.problems.empty()) << to_string(again.problems.front()) << to_yaml(written);
  written.written_at.clear();
  again.scenario.written_at.clear();
  EXPECT_EQ(again.scenario, written) << to_yaml(written);
}

TEST(WriteScenario, GivesTheSameScenarioWhenReadBack) {
  expect_same_after_writing(read(relax));
  expect_same_after_writing(read(R"(
name: "off"
title: "quote \" backslash \\ colon: hash # tab\t newline\n umlaut ä"
face: "patch:length=30,width=20"
density: 1033.3333333333333 kg/m^3
gravity: {magnitude: 9.80665 m/s^2, direction: [0.1, -0.3, 1e-3]}
skin: {law: fung_orthotropic, c: 0.1 MPa, kappa: 123.456789 kPa, volumetric: volumetric_quadratic}
hypodermis: {law: mooney_rivlin, preset: none, C10: 0.3333333333333333 kPa, kappa: 7 kPa}
muscle: {P1: 0.07, passive: sigma_max, radius: 0.123 cm}
solver: {relative_tolerance: 3.3e-7, smallest_increment: 0.01, threads: 2}
output: {pictures: no, fields: last}
steps: [tension: {tsf: 1.0999999999999999}, release, express: {"no": 0.1, ZYG_L: 0.3}, express: {ZYG: 1}]
)"));
}

TEST(WriteScenario, WritesEveryValueWithItsUnit) {
  const std::string yaml = to_yaml(read(relax).scenario);
  for (const char* line :
       {"\n  c: 21.3 kPa\n", "\n  kappa: 250 kPa\n", "\n  magnitude: 9.8 m/s^2\n",
        "\ndensity: 1040 kg/m^3\n", "\n  direction: [0, 0, -1]\n", "\n  radius: 6 mm\n",
        "\n  - express: {ZYG: 0}\n"}) {
    EXPECT_NE(yaml.find(line), std::string::npos) << line << yaml;
  }
}

TEST(ShippedScenario, IsReadWithoutAProblemAndWrittenBack) {
  const auto files = shipped_scenarios(FACIES_SOURCE_DIR);
  EXPECT_GE(files.size(), 5u);
  for (const auto& file : files) {
    const Reading reading = read_file_reporting(file);
    EXPECT_EQ(reading.scenario.name, file.stem()) << file;
    expect_same_after_writing(reading);
  }
}

TEST(ShippedScenario, HasTheActivationsOfThePapersTable3) {
  const std::map<std::string, std::map<std::string, double>> table3 = {
      {"smile-closed", {{"ZYG", 0.2}, {"LLSAN", 0.1}, {"LAO", 0.1}, {"RIS", 0.2}}},
      {"smile-open",
       {{"ZYG", 0.5}, {"LLSAN", 0.5}, {"LAO", 0.5}, {"RIS", 0.6}, {"DLI", 0.5}, {"DAO", 0.5}}},
      {"lips-down", {{"RIS", 0.6}, {"DAO", 1.0}, {"MENT", 0.15}}},
      {"purse", {{"OOP", 0.5}, {"OOM", 0.1}, {"BUC", 0.4}}}};
  for (const auto& [name, activations] : table3) {
    const Scenario s = read_scenario(find_scenario(name, FACIES_SOURCE_DIR));
    ASSERT_EQ(s.steps.size(), name == "smile-open" ? 4u : 3u);
    EXPECT_EQ(std::get<TensionStep>(s.steps[0]).tsf, 1.10);
    EXPECT_EQ(std::get<ExpressStep>(s.steps[2]).activations, activations) << name;
  }
}

TEST(FindScenario, GuessesWhatAMisspelledNameMeant) {
  try {
    (void)find_scenario("smile-opne", FACIES_SOURCE_DIR);
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(error.what(),
                 "smile-opne: no such file, and no scenario of that name ships\n    did you mean "
                 "'smile-open'?");
  }
}

TEST(ReadScenario, RefusesWhatIsNoFileOfReasonableSize) {
  const auto folder = std::filesystem::path(testing::TempDir());
  write_file(folder / "huge.yaml", std::string(2 << 20, '#'));
  EXPECT_THROW((void)read_scenario(folder / "huge.yaml"), ScenarioError);
  EXPECT_THROW((void)read_scenario(folder), ScenarioError);
  EXPECT_THROW((void)read_scenario("/dev/zero"), ScenarioError);
  EXPECT_THROW((void)read_scenario(folder / "nosuch.yaml"), ScenarioError);
  std::filesystem::remove(folder / "huge.yaml");
}

TEST(ReferencePage, IsUpToDate) {
  EXPECT_EQ(read_file(FACIES_SOURCE_DIR "/docs/scenario-reference.md"), reference_page())
      << "run: facies schema --markdown > docs/scenario-reference.md";
}

}  // namespace
}  // namespace facies::scenario
