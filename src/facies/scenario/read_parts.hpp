// SPDX-License-Identifier: Apache-2.0
// The parts of a scenario file that are more than a list of fields.
#pragma once

#include "facies/scenario/schema.hpp"
#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// Reads the presets and parameters of a section of material_sections(); `node` is nullptr where the file has no such
/// section. Its fields have been read before. False where law, preset or volumetric law are not settled; a problem says
/// why.
bool read_material(const YamlNode* node, const MaterialSection& section, Scenario& scenario,
                   Problems& problems);

/// The parameters of the laws that the section names.
[[nodiscard]] std::vector<material::ParamSpec> parameters_of(const MaterialSection& section,
                                                             Scenario& scenario);

/// Reads a move step that stands at `path` ("steps.3.move"), and its table of curves.
[[nodiscard]] MoveStep read_move(const YamlNode& content, const std::string& path,
                                 Scenario& scenario, Problems& problems);

/// Reads the list under "steps" and checks the order of the steps.
void read_steps(const YamlNode& node, Scenario& scenario, Problems& problems);

}  // namespace facies::scenario
