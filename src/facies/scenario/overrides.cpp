// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/overrides.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/scenario/schema.hpp"

namespace facies::scenario {

namespace {

bool is_step_kind(const std::string& word) {
  const auto kinds = step_kinds();
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const StepKind& kind) { return kind.name == word; });
}

bool is_step_of_kind(const YamlNode& step, const std::string& kind) {
  if (step.kind == YamlNode::Kind::scalar) return step.text == kind;
  return step.find(kind) != nullptr;
}

/// "tension.tsf" -> "steps.1.tension.tsf", cut at its points. Empty and a problem where that is not possible.
std::vector<std::string> full_path(const YamlNode& root, const Override& change,
                                   Problems& problems) {
  std::vector<std::string> path;
  for (const std::string_view part : split(change.key, '.'))
    path.emplace_back(part);
  if (path.size() > 8) {
    problems.add({change.where, fmt::format("a key of {} parts", path.size()), "at most 8", ""});
    return {};
  }
  if (!is_step_kind(path.front())) return path;
  const YamlEntry* steps = root.find("steps");
  std::vector<std::size_t> found;
  for (std::size_t i = 0; steps != nullptr && i < steps->value.items.size(); ++i) {
    if (is_step_of_kind(steps->value.items[i], path.front())) found.push_back(i + 1);
  }
  if (found.size() != 1) {
    problems.add({change.where,
                  fmt::format("the scenario has {} {} steps", found.size(), path.front()),
                  "exactly one for this short form",
                  fmt::format("write steps.N.{}, N counted from 1", change.key)});
    return {};
  }
  path.insert(path.begin(), {"steps", std::to_string(found.front())});
  return path;
}

/// The part of a list that `word` counts, from 1; nullptr and a problem where there is none.
YamlNode* item_of(YamlNode& list, const std::string& word, const std::string& where,
                  Problems& problems) {
  const auto number = parse_integer(word);
  if (number && *number >= 1 && static_cast<std::size_t>(*number) <= list.items.size()) {
    return &list.items[static_cast<std::size_t>(*number - 1)];
  }
  problems.add({where,
                fmt::format("there is no number {} in a list of {}", word, list.items.size()),
                fmt::format("1 to {}", list.items.size()), ""});
  return nullptr;
}

/// The value at `word` below `node`, made where it is missing; nullptr and a problem where nothing can be below.
YamlNode* descend(YamlNode& node, const std::string& word, const std::string& where,
                  Problems& problems) {
  if (node.kind == YamlNode::Kind::sequence) return item_of(node, word, where, problems);
  if (node.kind == YamlNode::Kind::scalar &&
      node.text == word) {  // the step "- tension" in short form
    node.entries.push_back(
        {node.text, node.where, {YamlNode::Kind::nothing, {}, {}, {}, node.where}});
    node.kind = YamlNode::Kind::mapping;
  }
  if (node.kind == YamlNode::Kind::nothing) node.kind = YamlNode::Kind::mapping;
  if (node.kind != YamlNode::Kind::mapping) {
    problems.add({where, fmt::format("nothing can stand below {} ({})", describe(node), node.where),
                  "", ""});
    return nullptr;
  }
  if (YamlEntry* entry = node.find(word)) {
    entry->where = where;
    return &entry->value;
  }
  node.entries.push_back({word, where, {YamlNode::Kind::nothing, {}, {}, {}, where}});
  return &node.entries.back().value;
}

}  // namespace

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  Override change;
  change.key = std::string(trim(text.substr(0, equals)));
  if (equals == std::string::npos || change.key.empty()) {
    throw UsageError({{"--set " + text, "no key and value", "--set key=value",
                       "such as --set skin.preset=flynn2015_stiff"}});
  }
  change.where = "--set " + change.key;
  Problems problems;
  change.value = parse_yaml(text.substr(equals + 1), {change.where, false}, problems);
  change.problems = problems.list();
  return change;
}

void apply_override(YamlNode& root, const Override& change, Problems& problems) {
  Problems wrong;
  wrong.add(change.problems);
  const std::vector<std::string> path = full_path(root, change, wrong);
  problems.add(wrong.list());
  if (!wrong.empty()) return;
  YamlNode* place = &root;
  for (const std::string& word : path) {
    place = descend(*place, word, change.where, problems);
    if (place == nullptr) return;
  }
  *place = change.value;
}

}  // namespace facies::scenario
