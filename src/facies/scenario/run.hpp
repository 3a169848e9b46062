// SPDX-License-Identifier: Apache-2.0
// A whole simulation: from a scenario to a result folder.
#pragma once

#include <filesystem>
#include <string>

#include "facies/scenario/scenario.hpp"
#include "facies/solve/observer.hpp"

namespace facies::scenario {

struct RunOptions {
  std::filesystem::path out;   ///< the result folder
  std::filesystem::path data;  ///< our own tables (data_folder())
  std::string version;         ///< of the program, for summary.json
  bool force = false;          ///< replace the results that `out` holds
  bool pictures = true;
  int threads = 0;  ///< 0: what the scenario says, and all there are where it says nothing
};

struct RunSummary {
  bool converged = false;
  std::string table;  ///< what was measured beside what the paper states, to be printed at the end
  std::string failure;  ///< what did not converge and where; empty otherwise
  std::filesystem::path out;
  double seconds = 0.0;
};

/// Loads the face, builds the model, takes the steps, and keeps the result folder readable all along. A step that does
/// not converge is a result: what was reached is written. Needs a solve::Session.
/// Throws UsageError (output folder), ScenarioError and DataError before anything is written; Interrupted after the last
/// converged state is written.
[[nodiscard]] RunSummary run(const Scenario& scenario, const RunOptions& options,
                             solve::Observer& observer);

/// Whether `options.out` holds a run of just this scenario by this version that came to its end, converged or not, from
/// files that have not changed since: running it again would give the same.
[[nodiscard]] bool is_finished(const Scenario& scenario, const RunOptions& options);

}  // namespace facies::scenario
