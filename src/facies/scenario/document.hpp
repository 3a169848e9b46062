// SPDX-License-Identifier: Apache-2.0
// What scenario and study files have in common: a short YAML text with a mapping at its top.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// What messages call a document.
struct DocumentKind {
  std::string name;      ///< "a scenario"
  std::string main_key;  ///< the key that it cannot do without: "steps"
  std::string hint;      ///< where to see one
};

/// The text of a file of at most 1 MB; nothing, and a problem, where it cannot be read.
[[nodiscard]] std::optional<std::string> read_document(const std::filesystem::path& path,
                                                       const DocumentKind& kind,
                                                       Problems& problems);

/// The mapping that a text holds; nothing, and problems, where it holds none. `source` names the text in messages.
[[nodiscard]] std::optional<YamlNode> parse_document(const std::string& text,
                                                     const std::string& source,
                                                     const DocumentKind& kind, Problems& problems);

/// In the order of the file: people mend it from top to bottom.
[[nodiscard]] std::vector<Problem> in_order(std::vector<Problem> problems);

}  // namespace facies::scenario
