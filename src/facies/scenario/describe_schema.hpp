// SPDX-License-Identifier: Apache-2.0
// The schema for machines and for people, both made from the list of fields and the material catalog.
#pragma once

#include <string>

namespace facies::scenario {

/// JSON Schema (draft-07) of scenario files, for editors: completion, tool tips, checks while one types.
[[nodiscard]] std::string json_schema();

/// The reference page, docs/scenario-reference.md.
[[nodiscard]] std::string reference_page();

}  // namespace facies::scenario
