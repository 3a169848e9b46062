// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "facies/base/text.hpp"
#include "facies/scenario/document.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"
#include "facies/scenario/study.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

namespace fs = std::filesystem;

const DocumentKind& document_kind() {
  static const DocumentKind study{"a study", "variants", "see `facies list studies`"};
  return study;
}

/// A scenario of the study and the file that its name stands for.
struct NamedFile {
  std::string name;
  std::string where;
  fs::path path;
};

struct VariantText {
  Variant variant;
  std::string where;  ///< of its name
  std::vector<Override> changes;
  std::vector<NamedFile> scenarios;
};

void refuse_unknown(const YamlNode& node, const std::vector<std::string>& known,
                    const std::string& in, Problems& problems) {
  for (const YamlEntry& entry : node.entries) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    problems.add({entry.where, fmt::format("unknown key '{}'{}", entry.key, in), "",
                  did_you_mean(entry.key, known)});
  }
}

/// The text at a key; empty where there is none.
std::string text_at(const YamlNode& node, const char* key, Problems& problems) {
  const YamlEntry* entry = node.find(key);
  if (entry == nullptr) return {};
  return read_text(entry->value, {.doc = ""}, problems).value_or("");
}

/// A list with something in it; nullptr and a problem for anything else.
const std::vector<YamlNode>* items_of(const YamlNode& node, const std::string& expected,
                                      Problems& problems) {
  if (node.kind == YamlNode::Kind::sequence && !node.items.empty()) return &node.items;
  const bool is_list = node.kind == YamlNode::Kind::sequence;
  problems.add({node.where, is_list ? "an empty list" : describe(node), expected, ""});
  return nullptr;
}

/// The file of a scenario: that of a name that ships, or a path from the folder of the study.
std::optional<fs::path> file_of(const std::string& name, const std::string& where,
                                const fs::path& folder, const fs::path& home, Problems& problems) {
  const bool is_path = name.find('/') != std::string::npos || fs::path(name).has_extension();
  try {
    return find_scenario(is_path ? (folder / name).string() : name, home);
  } catch (const ScenarioError& error) {
    for (const Problem& problem : error.problems())
      problems.add(
          {where, fmt::format("'{}': {}", problem.where, problem.found), "", problem.hint});
    return std::nullopt;
  }
}

std::vector<NamedFile> read_scenarios(const YamlNode& node, const fs::path& folder,
                                      const fs::path& home, Problems& problems) {
  std::vector<NamedFile> files;
  const auto* items = items_of(node, "a list of scenarios such as [smile-open, purse]", problems);
  if (items == nullptr) return files;
  for (const YamlNode& item : *items) {
    const auto name = read_text(item, {.doc = ""}, problems);
    if (!name) continue;
    if (const auto path = file_of(*name, item.where, folder, home, problems))
      files.push_back({*name, item.where, *path});
  }
  return files;
}

std::vector<Override> read_changes(const YamlEntry* set, Problems& problems) {
  std::vector<Override> changes;
  if (set == nullptr || !expect_mapping(set->value, "KEY: VALUE as for --set", problems))
    return changes;
  for (const YamlEntry& entry : set->value.entries)
    changes.push_back({entry.key, entry.where, entry.value});
  return changes;
}

/// Names of variants are folders of the results, beside the tables.
bool is_variant_name(const std::string& name) {
  return can_name_folder(name) && !name.starts_with("study.") &&
         std::ranges::all_of(name, [](unsigned char letter) {
           return std::isalnum(letter) != 0 ||
                  std::string_view("-_.+=").find(static_cast<char>(letter)) !=
                      std::string_view::npos;
         });
}

void check_variant_name(const VariantText& read, const std::vector<VariantText>& before,
                        Problems& problems) {
  const std::string& name = read.variant.name;
  if (!is_variant_name(name)) {
    problems.add({read.where, fmt::format("'{}' cannot name a variant's folder", name),
                  "at most 100 letters, digits and - _ . + =, not beginning with '.' or 'study.'",
                  ""});
  }
  for (const VariantText& other : before) {
    if (other.variant.name != name) continue;
    problems.add({read.where, fmt::format("the variant '{}' is given twice", name), "",
                  "the first one is at " + other.where});
    return;
  }
}

std::vector<VariantText> read_variants(const YamlEntry* entry, const std::vector<NamedFile>& all,
                                       const fs::path& folder, const fs::path& home,
                                       Problems& problems) {
  std::vector<VariantText> variants;
  const auto* items =
      entry == nullptr ? nullptr : items_of(entry->value, "a list of variants", problems);
  for (std::size_t i = 0; items != nullptr && i < items->size(); ++i) {
    const YamlNode& node = (*items)[i];
    if (!expect_mapping(node, "a variant: {name: ..., set: {KEY: VALUE}}", problems)) continue;
    refuse_unknown(node, {"name", "about", "set", "scenarios"}, " in a variant", problems);
    VariantText read;
    const YamlEntry* name = node.find("name");
    read.where = name == nullptr ? node.where : name->value.where;
    read.variant = {text_at(node, "name", problems), text_at(node, "about", problems)};
    if (name == nullptr) {
      problems.add({node.where, "a variant without a name", "name: ...", ""});
    } else if (name->value.kind == YamlNode::Kind::scalar) {
      check_variant_name(read, variants, problems);
    }
    read.changes = read_changes(node.find("set"), problems);
    const YamlEntry* own = node.find("scenarios");
    read.scenarios = own == nullptr ? all : read_scenarios(own->value, folder, home, problems);
    variants.push_back(std::move(read));
  }
  return variants;
}

/// Two runs of a variant must not meet in one folder, nor in one column of the table.
void check_apart(const NamedFile& file, const Scenario& scenario,
                 const std::vector<Scenario>& before, Problems& problems) {
  for (const Scenario& other : before) {
    if (other.name == scenario.name) {
      problems.add(
          {file.where, fmt::format("a second scenario called '{}'", scenario.name), "", ""});
    } else if (expression_of(other) == expression_of(scenario)) {
      problems.add({file.where,
                    fmt::format("'{}' and '{}' are both compared with the expression '{}'",
                                other.name, scenario.name, expression_of(scenario)),
                    "one of them in a variant", ""});
    }
  }
}

/// A problem and the scenarios of a variant that have it.
struct Shared {
  Problem problem;
  std::vector<std::string> scenarios;
};

/// Every problem once. One of what the variant sets names its scenarios where not all of them have it.
std::vector<Problem> merge(const std::map<std::string, Shared>& found, const VariantText& read) {
  std::vector<Problem> all;
  for (const auto& [text, shared] : found) {
    Problem& problem = all.emplace_back(shared.problem);
    const bool is_ours = std::ranges::any_of(
        read.changes, [&](const Override& change) { return change.where == problem.where; });
    if (is_ours && shared.scenarios.size() < read.scenarios.size())
      problem.found += fmt::format(" (in {})", fmt::join(shared.scenarios, ", "));
  }
  return all;
}

/// Reads the scenarios of a variant, which become runs of the study.
void add_runs(const VariantText& read, const std::optional<std::string>& face, Study& study,
              Problems& problems) {
  std::map<std::string, Shared> found;
  std::vector<Scenario> scenarios;
  for (const NamedFile& file : read.scenarios) {
    Reading reading = read_file_reporting(file.path, read.changes);
    for (const Problem& problem : reading.problems) {
      Shared& shared = found[to_string(problem)];
      shared.problem = problem;
      shared.scenarios.push_back(file.name);
    }
    if (face) {
      reading.scenario.face = *face;
      reading.scenario.written_at["face"] = "--face";
    }
    if (reading.problems.empty()) check_apart(file, reading.scenario, scenarios, problems);
    scenarios.push_back(std::move(reading.scenario));
  }
  problems.add(merge(found, read));
  for (Scenario& scenario : scenarios)
    study.runs.push_back({read.variant.name, std::move(scenario)});
}

/// Without what is said twice: variants share scenario files and what is wrong with them.
std::vector<Problem> each_once(const std::vector<Problem>& problems) {
  std::vector<Problem> once;
  std::set<std::string> said;
  for (const Problem& problem : problems) {
    if (said.insert(to_string(problem)).second) once.push_back(problem);
  }
  return once;
}

}  // namespace

StudyReading read_study_reporting(const fs::path& path, const fs::path& home,
                                  const std::optional<std::string>& face) {
  Problems problems;
  StudyReading reading;
  Study& study = reading.study;
  study.name = path.stem().string();
  if (const auto text = read_document(path, document_kind(), problems)) {
    study.text = *text;
    if (const auto root = parse_document(*text, path.string(), document_kind(), problems)) {
      refuse_unknown(*root, {"title", "scenarios", "variants"}, "", problems);
      study.title = text_at(*root, "title", problems);
      const YamlEntry* scenarios = root->find("scenarios");
      const YamlEntry* variants = root->find("variants");
      if (scenarios == nullptr)
        problems.add({path.string(), "no scenarios", "scenarios: a list", ""});
      if (variants == nullptr) problems.add({path.string(), "no variants", "variants: a list", ""});
      const fs::path folder = path.parent_path();
      std::vector<NamedFile> files;
      if (scenarios != nullptr) files = read_scenarios(scenarios->value, folder, home, problems);
      for (const VariantText& read : read_variants(variants, files, folder, home, problems)) {
        study.variants.push_back(read.variant);
        add_runs(read, face, study, problems);
      }
    }
  }
  reading.problems = in_order(each_once(problems.list()));
  return reading;
}

}  // namespace facies::scenario
