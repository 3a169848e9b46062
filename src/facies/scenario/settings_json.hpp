// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace facies::scenario {

/// A YAML document as JSON text; quantities with units stay texts.
[[nodiscard]] std::string settings_json(const std::string& yaml);

}  // namespace facies::scenario
