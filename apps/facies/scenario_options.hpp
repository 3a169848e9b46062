// SPDX-License-Identifier: Apache-2.0
// What every command that takes a scenario has in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facies/scenario/read_scenario.hpp"

namespace CLI {
class App;
}

namespace facies::cli {

struct ScenarioOptions {
  std::string scenario;  ///< path, or name of one that ships
  std::optional<std::string> face;
  std::vector<std::string> changes;  ///< "key=value"
};

/// Adds SCENARIO, --face and --set to a command.
void add_scenario_options(CLI::App& command, ScenarioOptions& options);

/// Reads the scenario with everything that the command line changes in it. Throws UsageError and ScenarioError for
/// what makes the file impossible to find; all else is among the problems.
[[nodiscard]] scenario::Reading read_reporting(const ScenarioOptions& options);

}  // namespace facies::cli
