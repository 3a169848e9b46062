// SPDX-License-Identifier: Apache-2.0
// A study: named variants of scenarios, one file. Reading it gives every run that it takes, ready to be carried out in
// any order.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

/// One choice that the study tries.
struct Variant {
  std::string name;   ///< names a folder of the study's results
  std::string about;  ///< one or two sentences; may be empty
};

/// One simulation of a study. Its results belong into VARIANT/NAME of the scenario.
struct StudyRun {
  std::string variant;
  Scenario scenario;
};

struct Study {
  std::string name;  ///< of its file
  std::string title;
  std::string text;  ///< the file as it was read
  std::vector<Variant> variants;
  std::vector<StudyRun> runs;  ///< variant after variant, in the order of the file
};

/// What a file says, and what is wrong with it.
struct StudyReading {
  Study study;
  std::vector<Problem> problems;
};

/// Reads a study and, once for every variant, its scenarios with what the variant sets. Scenarios are names of those that
/// ship below `home`, or paths from the folder of the study. `face`, where given, replaces that of every scenario.
[[nodiscard]] StudyReading read_study_reporting(const std::filesystem::path& path,
                                                const std::filesystem::path& home,
                                                const std::optional<std::string>& face = {});

}  // namespace facies::scenario
