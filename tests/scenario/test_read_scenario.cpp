// SPDX-License-Identifier: Apache-2.0
#include "scenario/reading.hpp"
#include <gtest/gtest.h>

#include "facies/scenario/read_scenario.hpp"

namespace facies::scenario {
namespace {

const std::string smile = R"(
name: my-smile
title: "A smile: mine"
face: artisynth:../models
skin: {preset: flynn2015_stiff, c: 21300 Pa}
density: 1.1 g/cm^3
gravity:
  magnitude: 9.81 m/s^2
  direction: [1, 0, 0]
muscle: {passive: none, radius: 0.5 cm, sigma_max: 5000 kPa}
steps:
  - tension: {tsf: 2}
  - release
  - express: {ZYG: 0.5, RIS_L: 0.25}
solver: {threads: 3, relative_tolerance: 1e-8}
output: {pictures: off, fields: last}
)";

TEST(ReadScenario, TakesEveryValueOfTheFile) {
  const Reading reading = read(smile);
  ASSERT_TRUE(reading.problems.empty()) << problems_of(smile);
  const Scenario& s = reading.scenario;
  EXPECT_EQ(s.name, "my-smile");
  EXPECT_EQ(s.title, "A smile: mine");
  EXPECT_EQ(s.face, "artisynth:../models");
  EXPECT_EQ(s.skin.values.at("c"), 21.3);
  EXPECT_DOUBLE_EQ(s.density, 1.1e-6);
  EXPECT_EQ(s.gravity.vector(), Vec3(9810.0, 0.0, 0.0));
  EXPECT_EQ(s.muscle.passive, "none");
  EXPECT_EQ(s.muscle.radius, 5.0);
  EXPECT_EQ(s.muscle.values.at("sigma_max"), 5000.0);
  EXPECT_EQ(s.solver.threads, 3);
  EXPECT_EQ(s.solver.relative_tolerance, 1e-8);
  EXPECT_FALSE(s.output.pictures);
  EXPECT_EQ(s.output.fields, "last");
  ASSERT_EQ(s.steps.size(), 3u);
  EXPECT_EQ(std::get<TensionStep>(s.steps[0]).tsf, 2.0);
  EXPECT_TRUE(std::holds_alternative<ReleaseStep>(s.steps[1]));
  EXPECT_EQ(std::get<ExpressStep>(s.steps[2]).activations,
            (std::map<std::string, double>{{"ZYG", 0.5}, {"RIS_L", 0.25}}));
}

TEST(ReadScenario, FillsWhatTheFileDoesNotSayFromThePaper) {
  const Scenario s = read(relax).scenario;
  EXPECT_EQ(s.name, "x");  // that of the file
  // Tables 1, 2 and 4 and "9.8 ms-2" of Flynn et al. 2015.
  EXPECT_EQ(s.skin.values.at("c"), 21.3);
  EXPECT_EQ(s.skin.values.at("mu1"), 17.8);
  EXPECT_EQ(s.skin.volumetric_values.at("kappa"), 250.0);
  EXPECT_EQ(s.hypodermis.values.at("C10"), 0.4);
  EXPECT_EQ(s.hypodermis.values.at("C20"), 1.4);
  EXPECT_EQ(s.hypodermis.volumetric_values.at("kappa"), 50.0);
  EXPECT_EQ(s.muscle.values.at("sigma_max"), 100.0);
  EXPECT_EQ(s.gravity.vector(), Vec3(0.0, 0.0, -9800.0));
}

TEST(ReadScenario, GivesEachTissueTheParametersOfItsLawAndNoOthers) {
  const Scenario s = read(relax + "skin: {preset: nazari2010_skin}\n").scenario;
  EXPECT_EQ(s.skin.law, "mooney_rivlin");
  EXPECT_EQ(s.skin.values.size(), material::find_law("mooney_rivlin")->parameters.size());
  EXPECT_EQ(s.skin.values.at("C10"), 2.5);
}

TEST(ReadScenario, TakesALawWithoutAPresetWhenEveryValueIsGiven) {
  const Reading reading = read(relax + "skin: {law: mooney_rivlin, C10: 2 kPa, kappa: 100 kPa}\n");
  ASSERT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.scenario.skin.preset, no_preset);
  EXPECT_EQ(reading.scenario.skin.values.at("C10"), 2.0);
}

TEST(ReadScenario, TakesJson) {
  const Reading reading = read(
      "{\"name\": \"j\",\n\t\"steps\": [{\"tension\": {\"tsf\": 1.05}}, {\"release\": {}}],\n"
      "\t\"density\": \"1000 kg/m^3\"}\n");
  ASSERT_TRUE(reading.problems.empty()) << to_string(reading.problems.front());
  EXPECT_EQ(std::get<TensionStep>(reading.scenario.steps[0]).tsf, 1.05);
}

TEST(ReadScenario, KnowsWhereEachEntryWasWritten) {
  const Scenario s = read(smile, {"skin.mu1=20 kPa"}).scenario;
  EXPECT_EQ(where_of(s, "density"), "x.yaml:6:10");
  EXPECT_EQ(where_of(s, "steps.3.express.RIS_L"), "x.yaml:14:25");
  EXPECT_EQ(where_of(s, "skin.mu1"), "--set skin.mu1");
  EXPECT_EQ(where_of(s, "skin.mu2"), "x.yaml:5:7");  // nearest entry around it
  EXPECT_EQ(where_of(s, "hypodermis.C10"), "x.yaml");
}

TEST(CheckAgainstFace, PointsToEachMuscleThatTheFaceDoesNotHave) {
  const Scenario s = read("steps:\n  - express: {ZIG: 0.5, RIS_L: 0.1, OOP_L: 0.2}\n").scenario;
  const auto problems = check_against_face(s, {{"OOP", "RIS", "RIS_L", "RIS_R", "ZYG"}, {}});
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[1].where, "x.yaml:2:37");
  EXPECT_EQ(problems[1].found, "this face has no muscle 'OOP_L'");
  EXPECT_NE(problems[0].hint.find("did you mean 'ZYG'?"), std::string::npos);
  EXPECT_EQ(problems[0].where, "x.yaml:2:15");
}

TEST(ExpressStep, GivesASideItsOwnActivationBeforeThatOfTheMuscle) {
  const ExpressStep step{{{"ZYG", 0.5}, {"ZYG_L", 0.1}}};
  EXPECT_EQ(activation_of(step, "ZYG_L", "ZYG"), 0.1);
  EXPECT_EQ(activation_of(step, "ZYG_R", "ZYG"), 0.5);
  EXPECT_EQ(activation_of(step, "RIS_R", "RIS"), 0.0);
}

TEST(Override, ReplacesValuesOfTheFile) {
  const Reading reading =
      read(smile, {"skin.preset=flynn2015_soft", "steps.1.tension.tsf=1.15", "express.ZYG=0.3",
                   "gravity={magnitude: 1 m/s^2}", "title=", "output.pictures=yes"});
  ASSERT_EQ(reading.problems.size(), 1u);  // a title without text
  EXPECT_EQ(reading.problems[0].where, "--set title");
  const Scenario& s = reading.scenario;
  EXPECT_EQ(s.skin.values.at("mu1"), 8.9);
  EXPECT_EQ(std::get<TensionStep>(s.steps[0]).tsf, 1.15);
  EXPECT_EQ(std::get<ExpressStep>(s.steps[2]).activations.at("ZYG"), 0.3);
  EXPECT_EQ(s.gravity.vector(), Vec3(0.0, 0.0, -1000.0));
  EXPECT_TRUE(s.output.pictures);
}

TEST(Override, ReachesAStepInShortForm) {
  const Scenario s = read("steps: [tension, release]\n", {"tension.tsf=1.2"}).scenario;
  EXPECT_EQ(std::get<TensionStep>(s.steps.at(0)).tsf, 1.2);
}

TEST(Override, WithoutKeyAndValueIsAMistakeOfTheCommandLine) {
  EXPECT_THROW((void)parse_override("skin.c"), UsageError);
  EXPECT_THROW((void)parse_override("=3"), UsageError);
}

}  // namespace
}  // namespace facies::scenario
