// SPDX-License-Identifier: Apache-2.0
// The lists of laws. A line below names the function name() at the end of name.cpp that describes the law.
#include "facies/material/catalog.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "facies/base/text.hpp"

// clang-format off
#define FACIES_LAWS(ENTRY) \
  ENTRY(fung_orthotropic) \
  ENTRY(mooney_rivlin)

#define FACIES_VOLUMETRIC_LAWS(ENTRY) \
  ENTRY(volumetric_log) \
  ENTRY(volumetric_quadratic)

#define FACIES_FIBRE_LAWS(ENTRY) \
  ENTRY(fibre_blemker2005)
// clang-format on

namespace facies::material {

#define FACIES_DECLARE_LAW(name) LawSpec name();
#define FACIES_DECLARE_VOLUMETRIC_LAW(name) VolumetricSpec name();
#define FACIES_DECLARE_FIBRE_LAW(name) FibreSpec name();
FACIES_LAWS(FACIES_DECLARE_LAW)
FACIES_VOLUMETRIC_LAWS(FACIES_DECLARE_VOLUMETRIC_LAW)
FACIES_FIBRE_LAWS(FACIES_DECLARE_FIBRE_LAW)

#define FACIES_DESCRIBE(name) name(),

std::span<const LawSpec> laws() {
  static const std::vector<LawSpec> all = {FACIES_LAWS(FACIES_DESCRIBE)};
  return all;
}

std::span<const VolumetricSpec> volumetric_laws() {
  static const std::vector<VolumetricSpec> all = {FACIES_VOLUMETRIC_LAWS(FACIES_DESCRIBE)};
  return all;
}

std::span<const FibreSpec> fibre_laws() {
  static const std::vector<FibreSpec> all = {FACIES_FIBRE_LAWS(FACIES_DESCRIBE)};
  return all;
}

namespace {

template <class Entry>
const Entry* find(std::span<const Entry> entries, const std::string& name) {
  const auto match =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  return match == entries.end() ? nullptr : &*match;
}

std::string in_words(const ParamSpec& spec) {
  const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
  return fmt::format("a number {} {:g}{} and at most {:g}{} ({})",
                     spec.exclusive_minimum ? "above" : "from", spec.minimum, unit, spec.maximum,
                     unit, spec.meaning);
}

bool in_range(const ParamSpec& spec, double value) {
  return std::isfinite(value) && value <= spec.maximum &&
         (spec.exclusive_minimum ? value > spec.minimum : value >= spec.minimum);
}

}  // namespace

const LawSpec* find_law(const std::string& name) {
  return find(laws(), name);
}
const VolumetricSpec* find_volumetric_law(const std::string& name) {
  return find(volumetric_laws(), name);
}
const FibreSpec* find_fibre_law(const std::string& name) {
  return find(fibre_laws(), name);
}
const Preset* find_preset(const std::string& name) {
  return find(presets(), name);
}

std::vector<Problem> check_parameters(std::span<const ParamSpec> specs, const Parameters& values) {
  std::vector<Problem> problems;
  std::vector<std::string> known;
  for (const ParamSpec& spec : specs) {
    known.push_back(spec.name);
    const auto given = values.find(spec.name);
    if (given == values.end()) {
      if (!spec.default_value) problems.push_back({"/" + spec.name, "missing", in_words(spec), ""});
    } else if (!in_range(spec, given->second)) {
      problems.push_back(
          {"/" + spec.name, fmt::format("{} is out of range", given->second), in_words(spec), ""});
    }
  }
  for (const auto& [name, value] : values) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      problems.push_back({"/" + name, "unknown parameter", "", did_you_mean(name, known)});
    }
  }
  return problems;
}

std::vector<Problem> check_parameters(const LawSpec& law, const Parameters& values) {
  std::vector<Problem> problems = check_parameters(law.parameters, values);
  if (problems.empty() && law.check) problems = law.check(with_defaults(law.parameters, values));
  return problems;
}

Parameters with_defaults(std::span<const ParamSpec> specs, Parameters values) {
  for (const ParamSpec& spec : specs) {
    if (spec.default_value) values.emplace(spec.name, *spec.default_value);
  }
  return values;
}

}  // namespace facies::material
