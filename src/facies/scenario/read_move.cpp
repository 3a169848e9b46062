// SPDX-License-Identifier: Apache-2.0
// The step `move`: how long, by which method, along which curves.
#include <filesystem>

#include <fmt/format.h>

#include "facies/scenario/read_curves.hpp"
#include "facies/scenario/read_parts.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

/// Columns of a table become curves of the step, unless the step has a curve of that name itself.
void take_table(const std::filesystem::path& file, const std::string& path, MoveStep& step,
                Scenario& scenario, Problems& problems) {
  for (NamedCurve& column : read_curve_table(file, step.duration, problems)) {
    const std::string entry = path + "." + column.name;
    if (step.levels.contains(column.name)) {
      problems.add({column.where, fmt::format("'{}' has a curve in the step as well", column.name),
                    "one curve for each name", "the other is at " + where_of(scenario, entry)});
      continue;
    }
    scenario.written_at[entry] = column.where;
    step.levels[column.name] = std::move(column.curve);
  }
}

}  // namespace

MoveStep read_move(const YamlNode& content, const std::string& path, Scenario& scenario,
                   Problems& problems) {
  MoveStep step;
  const MoveRules& rules = move_rules();
  for (const YamlEntry& entry : content.entries)
    scenario.written_at[path + "." + entry.key] = entry.where;
  if (const YamlEntry* entry = content.find("duration")) {
    step.duration = read_number(entry->value, rules.duration, problems).value_or(0.0);
  } else {
    problems.add({content.where, "a move step without a duration", "duration: 0.5 s", ""});
  }
  if (const YamlEntry* entry = content.find("method"))
    step.method = read_text(entry->value, rules.method, problems).value_or(step.method);
  if (const YamlEntry* entry = content.find("frames"))
    step.frames = read_integer(entry->value, rules.frames, problems).value_or(step.frames);
  for (const YamlEntry& entry : content.entries) {
    if (is_move_key(entry.key)) continue;
    // Read or not, the name has a curve: a second one is a mistake.
    step.levels[entry.key] = read_curve(entry.value, step.duration, problems).value_or(Curve{});
  }
  if (const YamlEntry* entry = content.find("curves")) {
    if (const auto name = read_text(entry->value, rules.curves, problems)) {
      const std::filesystem::path beside =
          std::filesystem::path(where_of(scenario, "")).parent_path();
      step.curves = (beside / *name).string();
      take_table(step.curves, path, step, scenario, problems);
    }
  } else if (step.levels.empty()) {
    problems.add({content.where, "a move step without muscles",
                  "curves such as ZYG: [[0 s, 0], [0.2 s, 0.5]]",
                  "or a table of them: curves: smile.csv"});
  }
  return step;
}

}  // namespace facies::scenario
