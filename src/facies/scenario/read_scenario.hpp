// SPDX-License-Identifier: Apache-2.0
// From a scenario file to a validated Scenario, or to everything that is wrong with the file at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "facies/scenario/overrides.hpp"
#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

/// What a text says, and what is wrong with it. With problems, the scenario holds defaults in their places.
struct Reading {
  Scenario scenario;
  std::vector<Problem> problems;
};

/// Reads a YAML or JSON text. `source` names it in messages; `name` is the scenario's where the text gives none.
[[nodiscard]] Reading read_text(const std::string& text, const std::string& source,
                                const std::string& name, const std::vector<Override>& changes = {});

/// Reads a file of at most 1 MB.
[[nodiscard]] Reading read_file_reporting(const std::filesystem::path& path,
                                          const std::vector<Override>& changes = {});

/// Reads a file. Throws ScenarioError with every problem.
[[nodiscard]] Scenario read_scenario(const std::filesystem::path& path,
                                     const std::vector<Override>& changes = {});

/// What steps may name on a face.
struct NamesOnFace {
  std::vector<std::string> muscles;  ///< of expression: groups and sides
  std::vector<std::string> jaw;      ///< exciters and muscles of the jaw
};

/// Names in steps that the face does not have, each with where it was written.
[[nodiscard]] std::vector<Problem> check_against_face(const Scenario& scenario,
                                                      const NamesOnFace& names);

}  // namespace facies::scenario
