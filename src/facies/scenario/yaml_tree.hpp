// SPDX-License-Identifier: Apache-2.0
// A YAML (or JSON) document as a tree in which everything knows where it was written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "facies/base/error.hpp"

namespace facies::scenario {

struct YamlEntry;

/// A value of the document.
struct YamlNode {
  enum class Kind { nothing, scalar, sequence, mapping };

  Kind kind = Kind::nothing;
  std::string text;                ///< of a scalar
  std::vector<YamlNode> items;     ///< of a sequence
  std::vector<YamlEntry> entries;  ///< of a mapping, in the order of the document, keys unique
  std::string where;               ///< "smile.yaml:12:7" or "--set skin.c"

  /// The entry with that key; nullptr where there is none or this is no mapping.
  [[nodiscard]] const YamlEntry* find(std::string_view key) const;
  [[nodiscard]] YamlEntry* find(std::string_view key);
};

/// A key and its value.
struct YamlEntry {
  std::string key;
  std::string where;  ///< of the key
  YamlNode value;
};

/// "nothing", "the value 'x'", "a list", "a mapping": how messages call a node.
[[nodiscard]] std::string describe(const YamlNode& node);

/// Where places in a text are reported.
struct Origin {
  std::string name;         ///< "smile.yaml", "--set skin.c"
  bool count_lines = true;  ///< append :line:column
};

/// Reads one document. What cannot be read (not YAML, repeated keys, anchors, tags, several documents, more than
/// 16 levels) is added to `problems`; the tree is then what could be made of the rest. An empty text gives `nothing`.
[[nodiscard]] YamlNode parse_yaml(const std::string& text, const Origin& origin,
                                  Problems& problems);

}  // namespace facies::scenario
