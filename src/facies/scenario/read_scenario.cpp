// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/read_scenario.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/scenario/document.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_parts.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

const MaterialSection* find_material_section(const std::string& name) {
  for (const MaterialSection& section : material_sections()) {
    if (section.name == name) return &section;
  }
  return nullptr;
}

/// Keys that may stand in a section ("" is the top of the file), parameters of laws left out.
std::vector<std::string> keys_of(const std::string& section) {
  std::vector<std::string> keys;
  for (const Field& field : fields()) {
    if (section_of(field.path) != section) continue;
    keys.push_back(section.empty() ? field.path : field.path.substr(section.size() + 1));
  }
  if (section.empty()) {
    for (const Section& known : sections())
      keys.push_back(known.name);
    keys.emplace_back("steps");
  }
  return keys;
}

/// Reads every field of one mapping and remembers where each entry was written. Keys that are no fields are left to
/// the caller.
void read_fields(const YamlNode& node, const std::string& section, Scenario& scenario,
                 Problems& problems) {
  for (const YamlEntry& entry : node.entries) {
    const std::string path = section.empty() ? entry.key : section + "." + entry.key;
    scenario.written_at[path] = entry.value.where;
    if (const Field* field = find_field(path)) read_field(entry.value, *field, scenario, problems);
  }
}

/// Adds a problem for every key of the mapping that is not known, and a guess at what was meant.
void refuse_unknown(const YamlNode& node, const std::string& section,
                    const std::vector<std::string>& known, Problems& problems) {
  for (const YamlEntry& entry : node.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    const std::string in = section.empty() ? "" : " in " + section;
    problems.add({entry.where, fmt::format("unknown key '{}'{}", entry.key, in), "",
                  did_you_mean(entry.key, known)});
  }
}

void read_section(const YamlNode* node, const std::string& section, Scenario& scenario,
                  Problems& problems) {
  if (node != nullptr && !expect_mapping(*node, "a mapping", problems)) return;
  if (node != nullptr) read_fields(*node, section, scenario, problems);
  std::vector<std::string> known = keys_of(section);
  if (const MaterialSection* materials = find_material_section(section)) {
    const bool settled = read_material(node, *materials, scenario, problems);
    for (const material::ParamSpec& spec :
         settled ? parameters_of(*materials, scenario) : every_parameter(*materials)) {
      known.push_back(spec.name);
    }
  }
  if (node != nullptr) refuse_unknown(*node, section, known, problems);
}

/// The name makes a folder.
void check_name(const Scenario& scenario, Problems& problems) {
  if (can_name_folder(scenario.name)) return;
  problems.add({where_of(scenario, "name"), fmt::format("'{}' cannot name a folder", scenario.name),
                "a name of at most 100 letters without '/' and not beginning with '.'", ""});
}

/// Muscles do not open a jaw that is held.
void check_jaw(const Scenario& scenario, Problems& problems) {
  if (scenario.jaw == "free") return;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    if (!std::holds_alternative<OpenJawStep>(scenario.steps[i])) continue;
    problems.add({where_of(scenario, fmt::format("steps.{}.open_jaw", i + 1)),
                  "the step open_jaw where the jaw is held", "a jaw that can move",
                  "say 'jaw: free' in the scenario, or --set jaw=free"});
  }
}

void read_root(const YamlNode& root, Scenario& scenario, Problems& problems) {
  read_fields(root, "", scenario, problems);
  for (const Section& section : sections()) {
    const YamlEntry* entry = root.find(section.name);
    read_section(entry == nullptr ? nullptr : &entry->value, section.name, scenario, problems);
  }
  refuse_unknown(root, "", keys_of(""), problems);
  if (const YamlEntry* steps = root.find("steps")) {
    read_steps(steps->value, scenario, problems);
  } else {
    problems.add(
        {root.where, "no steps", "steps: a list of tension, release, express, open_jaw", ""});
  }
  check_jaw(scenario, problems);
  check_name(scenario, problems);
}

const DocumentKind& document_kind() {
  static const DocumentKind scenario{"a scenario", "steps", "see `facies list scenarios`"};
  return scenario;
}

}  // namespace

Reading read_text(const std::string& text, const std::string& source, const std::string& name,
                  const std::vector<Override>& changes) {
  Reading reading;
  reading.scenario.name = name;
  reading.scenario.written_at[""] = source;
  Problems problems;
  if (std::optional<YamlNode> root = parse_document(text, source, document_kind(), problems)) {
    for (const Override& change : changes)
      apply_override(*root, change, problems);
    read_root(*root, reading.scenario, problems);
  }
  reading.problems = in_order(problems.list());
  return reading;
}

Reading read_file_reporting(const std::filesystem::path& path,
                            const std::vector<Override>& changes) {
  Problems problems;
  const std::optional<std::string> text = read_document(path, document_kind(), problems);
  if (!text) return {{}, problems.list()};
  return read_text(*text, path.string(), path.stem().string(), changes);
}

Scenario read_scenario(const std::filesystem::path& path, const std::vector<Override>& changes) {
  Reading reading = read_file_reporting(path, changes);
  if (!reading.problems.empty()) throw ScenarioError(std::move(reading.problems));
  return std::move(reading.scenario);
}

std::vector<Problem> check_against_face(const Scenario& scenario, const NamesOnFace& names) {
  std::vector<Problem> problems;
  std::vector<std::string> both = names.muscles;
  both.insert(both.end(), names.jaw.begin(), names.jaw.end());
  const auto check = [&](std::size_t step, const auto& levels,
                         const std::vector<std::string>& known, const std::string& kind) {
    for (const auto& [name, level] : levels) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      problems.push_back(
          {where_of(scenario,
                    fmt::format("steps.{}.{}.{}", step + 1, step_name(scenario.steps[step]), name)),
           fmt::format("this face has no {} '{}'", kind, name), "",
           did_you_mean(name, known) + "\n    --face chooses another face (`facies list faces`)"});
    }
  };
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    if (const auto* express = std::get_if<ExpressStep>(&scenario.steps[i]))
      check(i, express->activations, names.muscles, "muscle");
    if (const auto* open = std::get_if<OpenJawStep>(&scenario.steps[i]))
      check(i, open->excitations, names.jaw, "muscle of the jaw");
    if (const auto* move = std::get_if<MoveStep>(&scenario.steps[i]))
      check(i, move->levels, both, "muscle");
  }
  return in_order(std::move(problems));
}

}  // namespace facies::scenario
