// SPDX-License-Identifier: Apache-2.0
#include "apps/facies/scenario_options.hpp"

#include <CLI/CLI.hpp>

#include "facies/scenario/folders.hpp"

namespace facies::cli {

void add_scenario_options(CLI::App& command, ScenarioOptions& options) {
  command
      .add_option("scenario", options.scenario,
                  "file, or name of a scenario that ships (facies list scenarios)")
      ->required()
      ->type_name("SCENARIO");
  command
      .add_option("--face", options.face,
                  "whose face (facies list faces); replaces that of the scenario")
      ->type_name("SPEC");
  command.add_option("--set", options.changes, "replace a value of the scenario; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
}

scenario::Reading read_reporting(const ScenarioOptions& options) {
  std::vector<scenario::Override> changes;
  for (const std::string& change : options.changes)
    changes.push_back(scenario::parse_override(change));
  const auto path = scenario::find_scenario(options.scenario, scenario::home_folder());
  scenario::Reading reading = scenario::read_file_reporting(path, changes);
  if (options.face) {
    reading.scenario.face = *options.face;
    reading.scenario.written_at["face"] = "--face";
  }
  return reading;
}

}  // namespace facies::cli
