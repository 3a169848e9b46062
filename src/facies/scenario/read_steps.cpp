// SPDX-License-Identifier: Apache-2.0
// The list of steps and the order in which they make sense.
#include <algorithm>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/scenario/read_parts.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const StepKind& kind : step_kinds())
    names.push_back(kind.name);
  return names;
}

/// One step while it is read.
struct StepReader {
  const YamlNode& content;
  const std::string& path;  ///< "steps.2.tension"
  Scenario& scenario;
  Problems& problems;

  void remember(const YamlEntry& entry) const {
    scenario.written_at[path + "." + entry.key] = entry.where;
  }

  void refuse_key(const YamlEntry& entry, const std::vector<std::string>& known) const {
    problems.add({entry.where, fmt::format("unknown key '{}'", entry.key), "",
                  known.empty() ? "a release step has no keys: release: {}"
                                : did_you_mean(entry.key, known)});
  }

  [[nodiscard]] Step tension() const {
    TensionStep step;
    for (const YamlEntry& entry : content.entries) {
      remember(entry);
      if (entry.key == "tsf") {
        step.tsf = read_number(entry.value, tsf_rule(), problems).value_or(step.tsf);
      } else {
        refuse_key(entry, {"tsf"});
      }
    }
    return step;
  }

  [[nodiscard]] Step release() const {
    for (const YamlEntry& entry : content.entries)
      refuse_key(entry, {});
    return ReleaseStep{};
  }

  [[nodiscard]] Step express() const {
    return ExpressStep{levels("an express step", "activations such as {ZYG: 0.5}")};
  }

  [[nodiscard]] Step open_jaw() const {
    return OpenJawStep{levels("an open_jaw step", "excitations such as {bi_open: 1}")};
  }

  /// What each muscle named is driven to.
  [[nodiscard]] std::map<std::string, double> levels(const std::string& kind,
                                                     const std::string& wanted) const {
    std::map<std::string, double> levels;
    if (content.entries.empty()) {
      problems.add({content.where, fmt::format("{} without muscles", kind), wanted,
                    "to relax a muscle, give it the activation 0"});
    }
    for (const YamlEntry& entry : content.entries) {
      remember(entry);
      levels[entry.key] = read_number(entry.value, activation_rule(), problems).value_or(0.0);
    }
    return levels;
  }
};

void read_step(const YamlNode& node, std::size_t number, Scenario& scenario, Problems& problems) {
  const std::string wanted = "a step such as 'tension: {tsf: 1.10}'";
  // "- release" is short for "- release: {}".
  const YamlEntry alone = {
      node.text, node.where, {YamlNode::Kind::nothing, {}, {}, {}, node.where}};
  const bool is_word = node.kind == YamlNode::Kind::scalar;
  if (!is_word && !expect_mapping(node, wanted, problems)) return;
  if (!is_word && node.entries.size() != 1) {
    problems.add({node.where, fmt::format("a step with {} names", node.entries.size()), wanted,
                  "each step begins with its own '-'"});
    return;
  }
  const YamlEntry& entry = is_word ? alone : node.entries.front();
  const std::vector<std::string> kinds = kind_names();
  if (std::find(kinds.begin(), kinds.end(), entry.key) == kinds.end()) {
    problems.add({entry.where, fmt::format("unknown step '{}'", entry.key), "",
                  did_you_mean(entry.key, kinds)});
    return;
  }
  const YamlNode& content = entry.value;
  if (content.kind != YamlNode::Kind::nothing &&
      !expect_mapping(content, "a mapping such as {}", problems)) {
    return;
  }
  const std::string path = fmt::format("steps.{}.{}", number, entry.key);
  scenario.written_at[fmt::format("steps.{}", number)] = entry.where;
  scenario.written_at[path] = entry.where;
  const StepReader reader{content, path, scenario, problems};
  if (entry.key == "tension") scenario.steps.push_back(reader.tension());
  if (entry.key == "release") scenario.steps.push_back(reader.release());
  if (entry.key == "express") scenario.steps.push_back(reader.express());
  if (entry.key == "open_jaw") scenario.steps.push_back(reader.open_jaw());
  if (entry.key == "move")
    scenario.steps.emplace_back(read_move(content, path, scenario, problems));
}

/// The tension sets the stress-free size of the whole run, so nothing can come before it.
void check_order(const Scenario& scenario, Problems& problems) {
  bool has_tension = false;
  bool has_release = false;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    const std::string where = where_of(scenario, fmt::format("steps.{}", i + 1));
    const Step& step = scenario.steps[i];
    if (std::holds_alternative<TensionStep>(step)) {
      if (has_tension) problems.add({where, "a second tension step", "one", ""});
      if (!has_tension && i > 0) {
        problems.add({where, fmt::format("tension is step {}", i + 1), "the first step",
                      "it sets the size at which the tissue is free of stress"});
      }
      has_tension = true;
    }
    if (std::holds_alternative<ReleaseStep>(step)) {
      if (has_release) problems.add({where, "a second release step", "one", ""});
      if (!has_tension) {
        problems.add({where, "a release without a tension before it", "",
                      "begin with - tension: {tsf: 1.10}, or leave the release out"});
      }
      has_release = true;
    }
  }
}

}  // namespace

void read_steps(const YamlNode& node, Scenario& scenario, Problems& problems) {
  if (node.kind != YamlNode::Kind::sequence || node.items.empty()) {
    const bool empty = node.kind == YamlNode::Kind::sequence;
    problems.add({node.where, empty ? "no steps" : describe(node),
                  "a list of steps, each of them one of: tension, release, express, open_jaw, move",
                  ""});
    return;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    read_step(node.items[i], i + 1, scenario, problems);
  }
  // The order is worth judging only where each step was understood.
  if (scenario.steps.size() == node.items.size()) check_order(scenario, problems);
}

}  // namespace facies::scenario
