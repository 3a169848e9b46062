// SPDX-License-Identifier: Apache-2.0
// Values in place of those of the file: from the command line (--set skin.c="21.3 kPa") or from a variant of a study.
#pragma once

#include <string>

#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// The key is a path of the file with steps counted from 1 ("steps.1.tension.tsf"), or begins with the kind of a step
/// that the scenario has once ("tension.tsf", "express.ZYG").
struct Override {
  std::string key;
  std::string where;  ///< "--set skin.c" or "my-study.yaml:12:7"
  YamlNode value;
  std::vector<Problem> problems = {};  ///< why the value is no YAML; none otherwise
};

/// Cuts "key=value" at its first "="; the value is YAML. Throws UsageError where there is none or no key before it.
[[nodiscard]] Override parse_override(const std::string& text);

/// Puts the value in its place of the document; what it replaces is gone. Problems point to where the change was written.
void apply_override(YamlNode& root, const Override& change, Problems& problems);

}  // namespace facies::scenario
