// SPDX-License-Identifier: Apache-2.0
// One value of a document, read by its rule.
#pragma once

#include <optional>
#include <string>

#include "facies/scenario/schema.hpp"
#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// Each adds what is wrong to `problems` and then answers nothing.

/// A number in mm-kg-s units: with a unit where the rule has one, without where it has none.
[[nodiscard]] std::optional<double> read_number(const YamlNode& node, const Rule& rule,
                                                Problems& problems);
[[nodiscard]] std::optional<int> read_integer(const YamlNode& node, const Rule& rule,
                                              Problems& problems);
/// true, false, on, off, yes, no.
[[nodiscard]] std::optional<bool> read_boolean(const YamlNode& node, Problems& problems);
[[nodiscard]] std::optional<std::string> read_text(const YamlNode& node, const Rule& rule,
                                                   Problems& problems);
/// A list of three numbers that are not all zero.
[[nodiscard]] std::optional<Vec3> read_direction(const YamlNode& node, Problems& problems);

/// Reads `node` into the slot of `field`; leaves it as it was where something is wrong.
void read_field(const YamlNode& node, const Field& field, Scenario& scenario, Problems& problems);

/// True for a mapping; adds a problem for anything else. `wanted` is what stands in it.
[[nodiscard]] bool expect_mapping(const YamlNode& node, const std::string& wanted,
                                  Problems& problems);

}  // namespace facies::scenario
