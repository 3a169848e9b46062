// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/settings_json.hpp"

#include <nlohmann/json.hpp>

#include "facies/base/text.hpp"
#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

namespace {

using Json = nlohmann::ordered_json;

Json scalar(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  if (const auto integer = parse_integer(text)) return *integer;
  if (const auto number = parse_number(text)) return *number;
  return text;
}

Json to_json(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::scalar) return scalar(node.text);
  if (node.kind == YamlNode::Kind::sequence) {
    Json list = Json::array();
    for (const YamlNode& item : node.items)
      list.push_back(to_json(item));
    return list;
  }
  Json object = Json::object();
  for (const YamlEntry& entry : node.entries)
    object[entry.key] = to_json(entry.value);
  return object;
}

}  // namespace

std::string settings_json(const std::string& yaml) {
  Problems problems;
  const YamlNode root = parse_yaml(yaml, {"scenario.yaml"}, problems);
  require(problems.empty(), "a scenario that was written can be read");
  return to_json(root).dump();
}

}  // namespace facies::scenario
