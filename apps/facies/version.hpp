// SPDX-License-Identifier: Apache-2.0
// What this program is and what it was built with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace facies::cli {

/// "0.1.0".
[[nodiscard]] std::string version();

/// Component and version: {"Eigen", "3.4.0"} ...
[[nodiscard]] std::vector<std::pair<std::string, std::string>> built_with();

}  // namespace facies::cli
