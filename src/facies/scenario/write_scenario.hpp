// SPDX-License-Identifier: Apache-2.0
// A scenario as a file again, with every default written out.
#pragma once

#include <string>

#include "facies/scenario/schema.hpp"

namespace facies::scenario {

/// The scenario as YAML. Reading it back gives the same scenario, to the last bit.
[[nodiscard]] std::string to_yaml(const Scenario& scenario);

/// The value of one field as to_yaml writes it: "1040 kg/m^3", "[0, 0, -1]".
[[nodiscard]] std::string value_text(const Field& field, const Scenario& scenario);

}  // namespace facies::scenario
