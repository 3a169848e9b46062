// SPDX-License-Identifier: Apache-2.0
// Values given on the command line in place of those of the file: --set skin.c="21.3 kPa".
#pragma once

#include <string>

#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// "key=value". The key is a path of the file with steps counted from 1 ("steps.1.tension.tsf"), or begins with the
/// kind of a step that the scenario has once ("tension.tsf", "express.ZYG"). The value is YAML.
struct Override {
  std::string key;
  std::string value;
};

/// Cuts "key=value" at its first "=". Throws UsageError where there is none or no key before it.
[[nodiscard]] Override parse_override(const std::string& text);

/// Puts the value in its place of the document; what it replaces is gone. Problems point to "--set key".
void apply_override(YamlNode& root, const Override& change, Problems& problems);

}  // namespace facies::scenario
