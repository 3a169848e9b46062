// SPDX-License-Identifier: Apache-2.0
// What people get wrong, and exactly what they are told.
#include <gmock/gmock.h>

#include "scenario/reading.hpp"
#include <gtest/gtest.h>

namespace facies::scenario {
namespace {

struct Case {
  const char* name;
  std::string text;
  std::string message;  ///< the whole of what is reported
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class BadScenario : public testing::TestWithParam<Case> {};

TEST_P(BadScenario, IsRefusedWithPlaceAndRemedy) {
  EXPECT_EQ(problems_of(GetParam().text), GetParam().message);
}

const Case values[] = {
    {"BareNumber", relax + "skin: {c: 21.3}\n",
     "x.yaml:2:11: 21.3 has no unit; expected a pressure such as 21.3 kPa\n"},
    {"WrongDimension", relax + "density: 6 mm\n",
     "x.yaml:2:10: '6 mm' is a length; expected a density such as 6 kg/m^3\n"},
    {"UnknownUnit", relax + "skin: {c: 21.3 kpa}\n",
     "x.yaml:2:11: unknown unit 'kpa' in '21.3 kpa'; expected a pressure such as 21.3 kPa\n"
     "    did you mean 'kPa'?\n"},
    {"NotFinite", relax + "density: .nan kg/m^3\n",
     "x.yaml:2:10: '.nan kg/m^3' is not a number; expected a density such as 1 kg/m^3\n"},
    {"NegativeModulus", relax + "skin: {mu1: -3 kPa}\n",
     "x.yaml:2:13: -3 kPa is out of range; expected more than 0 kPa and at most 1e+12 kPa\n"},
    {"TsfZero", "steps: [tension: {tsf: 0}]\n",
     "x.yaml:1:24: 0 is out of range; expected more than 0.5 and at most 3\n"},
    {"TsfAbsurd", "steps: [tension: {tsf: 110}]\n",
     "x.yaml:1:24: 110 is out of range; expected more than 0.5 and at most 3\n"},
    {"ActivationAboveOne", "steps: [express: {ZYG: 1.5}]\n",
     "x.yaml:1:24: 1.5 is out of range; expected at least 0 and at most 1\n"},
    {"ActivationNegative", "steps: [express: {ZYG: -0.1}]\n",
     "x.yaml:1:24: -0.1 is out of range; expected at least 0 and at most 1\n"},
    {"ActivationIsAText", "steps: [express: {ZYG: strong}]\n",
     "x.yaml:1:24: 'strong' is not a number; expected a number without a unit\n"},
    {"NotWhole", relax + "solver: {threads: 1.5}\n",
     "x.yaml:2:19: the value '1.5'; expected a whole number, at least 0 and at most 1024\n"},
    {"NotBoolean", relax + "output: {pictures: perhaps}\n",
     "x.yaml:2:20: the value 'perhaps'; expected true or false\n"},
    {"NoDirection", relax + "gravity: {direction: [0, 0, 0]}\n",
     "x.yaml:2:22: a direction of no length; expected at least one number that is not zero\n"},
    {"ShortDirection", relax + "gravity: {direction: [0, 1]}\n",
     "x.yaml:2:22: a list of 2; expected a list of three numbers such as [0, 0, -1]\n"},
    {"ListForANumber", relax + "density: [1 kg/m^3]\n",
     "x.yaml:2:10: a list; expected a density in kg/m^3\n"},
    {"NoValue", relax + "density:\n", "x.yaml:2:1: nothing; expected a density in kg/m^3\n"},
    {"NameWithSlash", relax + "name: ../smile\n",
     "x.yaml:2:7: '../smile' cannot name a folder; expected a name of at most 100 letters without "
     "'/' and not beginning with '.'\n"},
    {"EmptyName", relax + "name: ''\n",
     "x.yaml:2:7: '' cannot name a folder; expected a name of at most 100 letters without '/' and "
     "not beginning with '.'\n"},
};
INSTANTIATE_TEST_SUITE_P(Values, BadScenario, testing::ValuesIn(values),
                         [](const auto& c) { return std::string(c.param.name); });

const Case words[] = {
    {"UnknownKey", relax + "skinn: {}\n",
     "x.yaml:2:1: unknown key 'skinn'\n    did you mean 'skin'?\n"},
    {"UnknownParameter", relax + "skin: {mu4: 1 kPa}\n",
     "x.yaml:2:8: unknown key 'mu4' in skin\n    did you mean 'mu1'?\n"},
    {"ParameterOfAnotherLaw", relax + "hypodermis: {mu1: 1 kPa}\n",
     "x.yaml:2:14: unknown key 'mu1' in hypodermis\n    known: law, preset, volumetric, C10, C01, "
     "C20, "
     "kappa\n"},
    {"UnknownPreset", relax + "skin: {preset: flynn2015_norma}\n",
     "x.yaml:2:16: 'flynn2015_norma' is unknown\n    did you mean 'flynn2015_normal'?\n"},
    {"UnknownLaw", relax + "skin: {law: fung, c: 3 kPa}\n",
     "x.yaml:2:13: 'fung' is unknown\n    known: fung_orthotropic, mooney_rivlin\n"},
    {"PresetOfAnotherLaw", relax + "skin: {law: mooney_rivlin, preset: flynn2015_stiff}\n",
     "x.yaml:2:36: 'flynn2015_stiff' is a preset of fung_orthotropic, not of mooney_rivlin\n"
     "    presets of mooney_rivlin: nazari2010_skin, nazari2010_skin_kappa25, "
     "flynn2015_hypodermis, "
     "none\n"},
    {"MusclePresetForSkin", relax + "hypodermis: {preset: flynn2015_muscle}\n",
     "x.yaml:2:22: 'flynn2015_muscle' is unknown\n    did you mean 'flynn2015_soft'?\n"},
    {"UnknownStep", "steps: [tensions: {tsf: 1.1}]\n",
     "x.yaml:1:9: unknown step 'tensions'\n    did you mean 'tension'?\n"},
    {"UnknownKeyOfAStep", "steps: [tension: {tfs: 1.1}]\n",
     "x.yaml:1:19: unknown key 'tfs'\n    did you mean 'tsf'?\n"},
    {"KeyOfARelease", "steps: [tension, release: {time: 3}]\n",
     "x.yaml:1:28: unknown key 'time'\n    a release step has no keys: release: {}\n"},
    {"RepeatedKey", relax + "name: a\nname: b\n",
     "x.yaml:3:1: 'name' is given twice\n    the first one is at x.yaml:2:1\n"},
    {"RepeatedMuscle", "steps: [express: {ZYG: 0.1, ZYG: 0.2}]\n",
     "x.yaml:1:29: 'ZYG' is given twice\n    the first one is at x.yaml:1:19\n"},
    {"UnknownFieldsChoice", relax + "output: {fields: step}\n",
     "x.yaml:2:18: 'step' is unknown\n    did you mean 'steps'?\n"},
};
INSTANTIATE_TEST_SUITE_P(Words, BadScenario, testing::ValuesIn(words),
                         [](const auto& c) { return std::string(c.param.name); });

const Case steps[] = {
    {"NoSteps", "name: a\n",
     "x.yaml:1:1: no steps; expected steps: a list of tension, release, express, open_jaw\n"},
    {"EmptySteps", "steps: []\n",
     "x.yaml:1:8: no steps; expected a list of steps, each of them one of: tension, release, "
     "express, open_jaw, move\n"},
    {"StepsAreAMapping", "steps: {tension: {tsf: 1.1}}\n",
     "x.yaml:1:8: a mapping; expected a list of steps, each of them one of: tension, release, "
     "express, open_jaw, move\n"},
    {"TwoNamesInOneStep", "steps:\n  - tension: {tsf: 1.1}\n    release: {}\n",
     "x.yaml:2:5: a step with 2 names; expected a step such as 'tension: {tsf: 1.10}'\n"
     "    each step begins with its own '-'\n"},
    {"ReleaseWithoutTension", "steps: [release]\n",
     "x.yaml:1:9: a release without a tension before it\n"
     "    begin with - tension: {tsf: 1.10}, or leave the release out\n"},
    {"TensionComesLate", "steps:\n  - express: {ZYG: 1}\n  - tension: {tsf: 1.1}\n",
     "x.yaml:3:5: tension is step 2; expected the first step\n"
     "    it sets the size at which the tissue is free of stress\n"},
    {"TwoTensions", "steps: [tension, tension]\n",
     "x.yaml:1:18: a second tension step; expected one\n"},
    {"TwoReleases", "steps: [tension, release, release]\n",
     "x.yaml:1:27: a second release step; expected one\n"},
    {"ExpressWithoutMuscles", "steps: [express: {}]\n",
     "x.yaml:1:18: an express step without muscles; expected activations such as {ZYG: 0.5}\n"
     "    to relax a muscle, give it the activation 0\n"},
    {"TensionIsANumber", "steps: [tension: 1.1]\n",
     "x.yaml:1:18: the value '1.1'; expected a mapping such as {}\n"},
};
INSTANTIATE_TEST_SUITE_P(Steps, BadScenario, testing::ValuesIn(steps),
                         [](const auto& c) { return std::string(c.param.name); });

const Case documents[] = {
    {"Empty", "",
     "x.yaml: is empty; expected a scenario with steps\n    see `facies list scenarios`\n"},
    {"OnlyComments", "# nothing\n",
     "x.yaml: is empty; expected a scenario with steps\n    see `facies list scenarios`\n"},
    {"Binary", std::string("name: a\0b", 9),
     "x.yaml: is not a text file; expected a scenario in YAML\n"},
    {"AList", "- tension\n",
     "x.yaml:1:1: a list; expected a scenario: a mapping of keys such as 'steps'\n"},
    {"AWord", "hello\n",
     "x.yaml:1:1: the value 'hello'; expected a scenario: a mapping of keys such as 'steps'\n"},
    {"TwoDocuments", relax + "---\n" + relax,
     "x.yaml:3:1: a second document; expected one document per file\n"},
    {"Anchor", "skin: &a {}\nhypodermis: *a\n" + relax,
     "x.yaml:1:7: an anchor or alias; expected a value written out\n    scenarios have none\n"},
    {"AliasBomb", "a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n",
     "x.yaml:1:4: an anchor or alias; expected a value written out\n    scenarios have none\n"},
    {"Tag", "name: !!python/object:os.system ls\n" + relax,
     "x.yaml:1:7: the tag 'tag:yaml.org,2002:python/object:os.system'; expected a value without a "
     "tag\n"},
};
INSTANTIATE_TEST_SUITE_P(Documents, BadScenario, testing::ValuesIn(documents),
                         [](const auto& c) { return std::string(c.param.name); });

TEST(BadScenario, ThatIsNotYamlIsRefusedAtItsPlace) {
  EXPECT_THAT(problems_of("steps: [express: {ZYG: 0.5}\nname: a\n"),
              testing::StartsWith("x.yaml:2:1: not YAML: "));
  EXPECT_THAT(problems_of("name: a\n\tface: b\n"), testing::StartsWith("x.yaml:2:1: not YAML: "));
  EXPECT_THAT(problems_of("name: \"a\"b\n"), testing::StartsWith("x.yaml:1:10: not YAML: "));
}

TEST(BadScenario, IsToldAllProblemsAtOnceInTheOrderOfTheFile) {
  const Reading reading = read(
      "steps:\n  - express: {ZYG: 3}\n  - release: {}\n"
      "solver: {thread: 2}\nskin: {preset: nosuch}\ndensity: 6 mm\n");
  std::vector<std::string> places;
  for (const Problem& problem : reading.problems)
    places.push_back(problem.where);
  EXPECT_THAT(places, testing::ElementsAre("x.yaml:2:20", "x.yaml:3:5", "x.yaml:4:10",
                                           "x.yaml:5:16", "x.yaml:6:10"));
}

TEST(BadScenario, NamesEveryParameterThatIsMissing) {
  const Reading reading = read(relax + "skin: {preset: none, c: 1 kPa}\n");
  EXPECT_EQ(reading.problems.size(), 10u);  // nine moduli and kappa
  EXPECT_THAT(problems_of(relax + "skin: {preset: none, c: 1 kPa}\n"),
              testing::HasSubstr("x.yaml:2:7: 'skin.mu1' is missing"));
}

TEST(BadScenario, OfCombinedParametersIsJudgedByTheLaw) {
  EXPECT_THAT(problems_of(relax + "skin: {lambda12: 1000 kPa}\n"),
              testing::StartsWith("x.yaml:2:18: too large beside mu"));
}

TEST(BadScenario, InAnOverridePointsToTheCommandLine) {
  EXPECT_EQ(problems_of(relax, {"skin.c=21.3"}),
            "--set skin.c: 21.3 has no unit; expected a pressure such as 21.3 kPa\n");
  EXPECT_EQ(problems_of(relax, {"skni.c=21.3 kPa"}),
            "--set skni.c: unknown key 'skni'\n    did you mean 'skin'?\n");
  EXPECT_EQ(problems_of(relax, {"steps.4.tension.tsf=1"}),
            "--set steps.4.tension.tsf: there is no number 4 in a list of 1; expected 1 to 1\n");
  EXPECT_THAT(problems_of(relax, {"tension.tsf=1"}),
              testing::StartsWith("--set tension.tsf: the scenario has 0 tension steps"));
  EXPECT_THAT(problems_of(relax, {"name.first=a"}), testing::StartsWith("--set name.first: "));
  EXPECT_THAT(problems_of(relax, {"skin={c: ["}), testing::StartsWith("--set skin: not YAML"));
}

TEST(BadScenario, ThatNestsWithoutEndIsRefused) {
  EXPECT_THAT(problems_of("a: " + std::string(500000, '[')),
              testing::HasSubstr("more than 16 levels"));
  EXPECT_NE(problems_of("a: " + std::string(500000, '{')), "");
  std::string ladder;
  for (int i = 0; i < 900; ++i)
    ladder += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(problems_of(ladder), testing::HasSubstr("more than 16 levels"));
  EXPECT_THAT(problems_of(relax, {std::string("a") + ".a.a.a.a.a.a.a.a.a=1"}),
              testing::HasSubstr("a key of 10 parts"));
}

}  // namespace
}  // namespace facies::scenario
