// SPDX-License-Identifier: Apache-2.0
// Laws, presets and parameters of a section: the preset's values first, then those of the file, then the law's defaults.
#include <algorithm>

#include <fmt/format.h>

#include "facies/base/quantity.hpp"
#include "facies/base/text.hpp"
#include "facies/scenario/read_parts.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

using material::Parameters;
using material::ParamSpec;

/// The law and preset of a section, wherever they are kept.
struct Choice {
  std::string& law;
  std::string& preset;
};

Choice choice_of(const MaterialSection& section, Scenario& scenario) {
  if (section.tissue == nullptr) return {scenario.muscle.law, scenario.muscle.preset};
  TissueChoice& tissue = *section.tissue(scenario);
  return {tissue.law, tissue.preset};
}

/// True where the file names something else than what was kept: its value was refused, and a problem says so.
bool was_refused(const YamlNode* node, const char* key, const std::string& kept) {
  const YamlEntry* entry = node == nullptr ? nullptr : node->find(key);
  return entry != nullptr &&
         (entry->value.kind != YamlNode::Kind::scalar || entry->value.text != kept);
}

/// Settles which law and preset hold when one or both were given. False where they contradict each other.
bool settle(const YamlNode* node, const MaterialSection& section, Scenario& scenario,
            Problems& problems) {
  const Choice choice = choice_of(section, scenario);
  if (was_refused(node, "law", choice.law) || was_refused(node, "preset", choice.preset))
    return false;
  if (section.tissue != nullptr &&
      was_refused(node, "volumetric", section.tissue(scenario)->volumetric)) {
    return false;
  }
  const material::Preset* preset = material::find_preset(choice.preset);
  if (preset == nullptr || preset->law == choice.law) return true;
  const bool has_law = node != nullptr && node->find("law") != nullptr;
  const bool has_preset = node != nullptr && node->find("preset") != nullptr;
  if (has_law && has_preset) {
    std::string known;
    for (const std::string& name : presets_of(choice.law))
      known += name + ", ";
    problems.add(
        {where_of(scenario, section.name + ".preset"),
         fmt::format("'{}' is a preset of {}, not of {}", preset->name, preset->law, choice.law),
         "", fmt::format("presets of {}: {}{}", choice.law, known, no_preset)});
    return false;
  }
  if (has_law) {
    choice.preset = no_preset;
  } else {
    choice.law = preset->law;
  }
  return true;
}

/// Values of the preset and of the file for `specs`. Names whose value could not be read go into `unreadable`.
Parameters gather(const YamlNode* node, const Choice& choice, std::span<const ParamSpec> specs,
                  std::vector<std::string>& unreadable, Problems& problems) {
  Parameters values;
  const material::Preset* preset = material::find_preset(choice.preset);
  for (const ParamSpec& spec : specs) {
    if (preset != nullptr) {
      const auto of_preset = preset->values.find(spec.name);
      if (of_preset != preset->values.end()) values[spec.name] = of_preset->second;
    }
    const YamlEntry* entry = node == nullptr ? nullptr : node->find(spec.name);
    if (entry == nullptr) continue;
    const Unit in = unit(spec.unit);
    if (const auto value = read_number(entry->value, rule_of(spec), problems)) {
      values[spec.name] = *value / in.numerator * in.denominator;
    } else {
      unreadable.push_back(spec.name);
    }
  }
  return material::with_defaults(specs, std::move(values));
}

/// Adds what the catalog says about the values, pointing to where each was written.
void report(const std::vector<Problem>& found, const MaterialSection& section, const Choice& choice,
            const Scenario& scenario, const std::vector<std::string>& unreadable,
            Problems& problems) {
  for (Problem problem : found) {
    const std::string name = problem.where.substr(1, problem.where.find(',') - 1);
    if (std::find(unreadable.begin(), unreadable.end(), name) != unreadable.end()) continue;
    if (problem.found == "missing") {
      problem.found = fmt::format("'{}.{}' is missing", section.name, name);
      problem.hint = fmt::format("without a preset every parameter of {} is given", choice.law);
    }
    problem.where = where_of(scenario, section.name + "." + name);
    problems.add(std::move(problem));
  }
}

/// What a lookup in the catalog found under a name that has been checked.
template <class Spec>
const Spec& listed(const Spec* spec) {
  if (spec == nullptr) throw BugError("a law that was checked is not in the catalog");
  return *spec;
}

}  // namespace

std::vector<ParamSpec> parameters_of(const MaterialSection& section, Scenario& scenario) {
  std::vector<ParamSpec> all;
  const auto append = [&all](const auto& spec) {
    all.insert(all.end(), spec.parameters.begin(), spec.parameters.end());
  };
  if (section.tissue == nullptr) {
    append(listed(material::find_fibre_law(scenario.muscle.law)));
  } else {
    append(listed(material::find_law(section.tissue(scenario)->law)));
    append(listed(material::find_volumetric_law(section.tissue(scenario)->volumetric)));
  }
  return all;
}

bool read_material(const YamlNode* node, const MaterialSection& section, Scenario& scenario,
                   Problems& problems) {
  const std::size_t before = problems.size();
  if (!settle(node, section, scenario, problems)) return false;
  const Choice choice = choice_of(section, scenario);
  std::vector<std::string> unreadable;
  const auto values_for = [&](std::span<const ParamSpec> specs) {
    return gather(node, choice, specs, unreadable, problems);
  };
  const auto check = [&](const std::vector<Problem>& found) {
    report(found, section, choice, scenario, unreadable, problems);
  };
  if (section.tissue == nullptr) {
    const material::FibreSpec& law = listed(material::find_fibre_law(choice.law));
    scenario.muscle.values = values_for(law.parameters);
    check(material::check_parameters(law.parameters, scenario.muscle.values));
    return true;
  }
  TissueChoice& tissue = *section.tissue(scenario);
  const material::LawSpec& law = listed(material::find_law(tissue.law));
  const material::VolumetricSpec& volumetric =
      listed(material::find_volumetric_law(tissue.volumetric));
  tissue.values = values_for(law.parameters);
  tissue.volumetric_values = values_for(volumetric.parameters);
  check(material::check_parameters(volumetric.parameters, tissue.volumetric_values));
  // What the law says about all values together only makes sense when each of them could be read.
  check(problems.size() == before ? material::check_parameters(law, tissue.values)
                                  : material::check_parameters(law.parameters, tissue.values));
  return true;
}

}  // namespace facies::scenario
