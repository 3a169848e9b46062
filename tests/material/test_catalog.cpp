// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "facies/material/catalog.hpp"

namespace facies::material {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<ParamSpec> specs_of(const std::string& law) {
  if (const LawSpec* spec = find_law(law)) return spec->parameters;
  if (const VolumetricSpec* spec = find_volumetric_law(law)) return spec->parameters;
  if (const FibreSpec* spec = find_fibre_law(law)) return spec->parameters;
  return {};
}

/// Calls check(name, parameters, example) for every law of every kind.
template <class Check>
void for_every_law(const Check& check) {
  for (const LawSpec& spec : laws())
    check(spec.name, spec.parameters, spec.example);
  for (const VolumetricSpec& spec : volumetric_laws())
    check(spec.name, spec.parameters, spec.example);
  for (const FibreSpec& spec : fibre_laws())
    check(spec.name, spec.parameters, spec.example);
}

TEST(Catalog, NamesEveryEntryOnceAndFindsIt) {
  std::set<std::string> names;
  for (const LawSpec& spec : laws())
    EXPECT_EQ(find_law(spec.name), &spec);
  for (const VolumetricSpec& spec : volumetric_laws())
    EXPECT_EQ(find_volumetric_law(spec.name), &spec);
  for (const FibreSpec& spec : fibre_laws())
    EXPECT_EQ(find_fibre_law(spec.name), &spec);
  for_every_law([&](const std::string& name, const auto&, const auto&) {
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  });
  for (const Preset& preset : presets()) {
    EXPECT_EQ(find_preset(preset.name), &preset);
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name << " twice";
  }
  EXPECT_EQ(find_law("no such law"), nullptr);
  EXPECT_EQ(find_preset(""), nullptr);
}

TEST(Catalog, SaysWhereEveryEntryComesFrom) {
  for (const LawSpec& spec : laws())
    EXPECT_FALSE(spec.source.empty() || spec.summary.empty()) << spec.name;
  for (const VolumetricSpec& spec : volumetric_laws())
    EXPECT_FALSE(spec.source.empty() || spec.summary.empty()) << spec.name;
  for (const FibreSpec& spec : fibre_laws())
    EXPECT_FALSE(spec.source.empty() || spec.summary.empty()) << spec.name;
  for (const Preset& preset : presets())
    EXPECT_FALSE(preset.source.empty()) << preset.name;
}

TEST(Catalog, AcceptsEveryExample) {
  for_every_law([](const std::string& name, const auto& specs, const Parameters& example) {
    EXPECT_THAT(check_parameters(specs, example), IsEmpty()) << name;
  });
  for (const LawSpec& spec : laws())
    EXPECT_THAT(check_parameters(spec, spec.example), IsEmpty()) << spec.name;
}

TEST(Catalog, AcceptsEveryPreset) {
  const std::vector<ParamSpec> volumetric = specs_of("volumetric_log");
  for (const Preset& preset : presets()) {
    const std::vector<ParamSpec> specs = specs_of(preset.law);
    ASSERT_FALSE(specs.empty()) << preset.name << " names the unknown law " << preset.law;
    Parameters values = preset.values;
    if (const auto kappa = values.extract("kappa")) {
      EXPECT_THAT(check_parameters(volumetric, {{"kappa", kappa.mapped()}}), IsEmpty())
          << preset.name;
    }
    EXPECT_THAT(check_parameters(specs, values), IsEmpty()) << preset.name;
    if (const LawSpec* law = find_law(preset.law)) {
      EXPECT_THAT(check_parameters(*law, values), IsEmpty()) << preset.name;
    }
  }
}

TEST(Catalog, RefusesValuesOutOfRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for_every_law(
      [&](const std::string& name, const std::vector<ParamSpec>& specs, const Parameters& example) {
        for (const ParamSpec& spec : specs) {
          std::vector<double> bad = {spec.minimum - 1.0, 2.0 * spec.maximum, infinity, -infinity,
                                     std::nan("")};
          if (spec.exclusive_minimum) bad.push_back(spec.minimum);
          for (const double value : bad) {
            Parameters values = example;
            values[spec.name] = value;
            const std::vector<Problem> problems = check_parameters(specs, values);
            ASSERT_EQ(problems.size(), 1U) << name << " " << spec.name << " = " << value;
            EXPECT_EQ(problems[0].where, "/" + spec.name);
          }
        }
      });
}

TEST(Catalog, RefusesNegativeModuli) {
  for_every_law(
      [](const std::string& name, const std::vector<ParamSpec>& specs, Parameters values) {
        for (auto& [parameter, value] : values)
          value = -1.0;
        EXPECT_EQ(check_parameters(specs, values).size(), values.size()) << name;
      });
}

TEST(Catalog, MissesEveryParameterWithoutADefault) {
  for_every_law(
      [](const std::string& name, const std::vector<ParamSpec>& specs, const Parameters&) {
        std::size_t needed = 0;
        for (const ParamSpec& spec : specs)
          needed += spec.default_value ? 0 : 1;
        EXPECT_EQ(check_parameters(specs, {}).size(), needed) << name;
      });
}

TEST(Catalog, TellsAllProblemsAtOnce) {
  const std::vector<ParamSpec> specs = specs_of("mooney_rivlin");
  const std::vector<Problem> problems = check_parameters(specs, {{"C20", -1.4}, {"C1O", 0.4}});
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(to_string(problems[0]),
            "/C10: missing; expected a number above 0 kPa and at most 1e+12 kPa "
            "(coefficient of I1_bar - 3; the shear modulus at rest is 2 (C10 + C01))");
  EXPECT_THAT(to_string(problems[1]),
              HasSubstr("/C20: -1.4 is out of range; expected a number from 0 kPa"));
  EXPECT_EQ(to_string(problems[2]), "/C1O: unknown parameter\n    did you mean 'C10'?");
}

TEST(Catalog, RefusesModuliThatGiveEnergyTogether) {
  const LawSpec& fung = *find_law("fung_orthotropic");
  Parameters values = fung.example;
  values["lambda12"] = 1000.0;
  EXPECT_THAT(check_parameters(fung.parameters, values), IsEmpty()) << "in range one by one";
  const std::vector<Problem> problems = check_parameters(fung, values);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(to_string(problems[0]), HasSubstr("lambda12"));
  values["mu1"] = -1.0;
  EXPECT_EQ(check_parameters(fung, values)[0].where, "/mu1");
}

TEST(Catalog, FillsInDefaultsOnly) {
  const Parameters values = with_defaults(specs_of("mooney_rivlin"), {{"C10", 0.4}, {"C20", 1.4}});
  EXPECT_EQ(values, (Parameters{{"C01", 0.0}, {"C10", 0.4}, {"C20", 1.4}}));
}

TEST(Presets, SayWhatIsDoubtful) {
  for (const char* name : {"flynn2015_normal", "flynn2015_stiff", "flynn2015_stiff_as_printed",
                           "nazari2010_skin", "nazari2010_skin_kappa25", "flynn2015_muscle"}) {
    ASSERT_NE(find_preset(name), nullptr) << name;
    EXPECT_FALSE(find_preset(name)->note.empty()) << name;
  }
}

TEST(Presets, StiffSkinIsTwiceTheNormalOne) {
  for (const char* family : {"flynn2015", "artisynth"}) {
    const Preset* normal = find_preset(std::string(family) + "_normal");
    const Preset* stiff = find_preset(std::string(family) + "_stiff");
    for (const auto& [name, value] : normal->values) {
      const double factor = name == "kappa" ? 1.0 : 2.0;
      EXPECT_NEAR(stiff->values.at(name), factor * value, 1e-12) << family << " " << name;
    }
  }
}

TEST(Presets, SoftSkinIsHalfTheNormalOneToTheDigitsPrinted) {
  for (const auto& [name, value] : find_preset("flynn2015_normal")->values) {
    const double factor = name == "kappa" ? 1.0 : 0.5;
    EXPECT_NEAR(find_preset("flynn2015_soft")->values.at(name), factor * value, 0.0501) << name;
  }
}

}  // namespace
}  // namespace facies::material
