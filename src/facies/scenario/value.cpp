// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/value.hpp"

#include <algorithm>
#include <cmath>

#include <climits>
#include <fmt/format.h>

#include "facies/base/quantity.hpp"
#include "facies/base/text.hpp"

namespace facies::scenario {

namespace {

/// Adds "found; expected" at the node.
void add(Problems& problems, const YamlNode& node, std::string found, std::string expected,
         std::string hint = "") {
  problems.add({node.where, std::move(found), std::move(expected), std::move(hint)});
}

/// Bounds are converted, not the value: an admitted bound stays admitted whatever unit it is written in.
bool in_range(double value, const Rule& rule) {
  const Unit in = unit(rule.unit);
  const double minimum = rule.minimum * in.numerator / in.denominator;
  const double maximum = rule.maximum * in.numerator / in.denominator;
  return value <= maximum && (rule.exclusive_minimum ? value > minimum : value >= minimum);
}

struct ReadInto {
  const YamlNode& node;
  const Field& field;
  Scenario& scenario;
  Problems& problems;

  template <class T>
  void store(T* slot, std::optional<T> value) const {
    if (value) *slot = std::move(*value);
  }
  void operator()(std::string* (*slot)(Scenario&)) const {
    store(slot(scenario), read_text(node, field.rule, problems));
  }
  void operator()(double* (*slot)(Scenario&)) const {
    store(slot(scenario), read_number(node, field.rule, problems));
  }
  void operator()(int* (*slot)(Scenario&)) const {
    store(slot(scenario), read_integer(node, field.rule, problems));
  }
  void operator()(bool* (*slot)(Scenario&)) const {
    store(slot(scenario), read_boolean(node, problems));
  }
  void operator()(Vec3* (*slot)(Scenario&)) const {
    store(slot(scenario), read_direction(node, problems));
  }
};

}  // namespace

std::optional<double> read_number(const YamlNode& node, const Rule& rule, Problems& problems) {
  if (node.kind != YamlNode::Kind::scalar) {
    const Dimension dimension = unit(rule.unit).dimension;
    add(problems, node, describe(node),
        rule.unit.empty() ? "a number" : fmt::format("a {} in {}", name_of(dimension), rule.unit));
    return std::nullopt;
  }
  const auto parsed = parse_quantity(node.text, unit(rule.unit));
  if (const auto* problem = std::get_if<Problem>(&parsed)) {
    add(problems, node, problem->found, problem->expected, problem->hint);
    return std::nullopt;
  }
  const double value = std::get<double>(parsed);
  if (!in_range(value, rule)) {
    add(problems, node, fmt::format("{} is out of range", node.text), range_in_words(rule));
    return std::nullopt;
  }
  return value;
}

std::optional<int> read_integer(const YamlNode& node, const Rule& rule, Problems& problems) {
  const auto value = node.kind == YamlNode::Kind::scalar ? parse_integer(node.text) : std::nullopt;
  if (!value) {
    add(problems, node, describe(node), "a whole number, " + range_in_words(rule));
    return std::nullopt;
  }
  if (!in_range(static_cast<double>(*value), rule) || *value > INT_MAX || *value < INT_MIN) {
    add(problems, node, fmt::format("{} is out of range", node.text), range_in_words(rule));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<bool> read_boolean(const YamlNode& node, Problems& problems) {
  if (node.kind == YamlNode::Kind::scalar) {
    if (node.text == "true" || node.text == "on" || node.text == "yes") return true;
    if (node.text == "false" || node.text == "off" || node.text == "no") return false;
  }
  add(problems, node, describe(node), "true or false");
  return std::nullopt;
}

std::optional<std::string> read_text(const YamlNode& node, const Rule& rule, Problems& problems) {
  if (node.kind != YamlNode::Kind::scalar) {
    add(problems, node, describe(node), rule.choices.empty() ? "a text" : "one word");
    return std::nullopt;
  }
  const auto& choices = rule.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), node.text) == choices.end()) {
    add(problems, node, fmt::format("'{}' is unknown", node.text), "",
        did_you_mean(node.text, choices));
    return std::nullopt;
  }
  return node.text;
}

std::optional<Vec3> read_direction(const YamlNode& node, Problems& problems) {
  if (node.kind != YamlNode::Kind::sequence || node.items.size() != 3) {
    const std::string found = node.kind == YamlNode::Kind::sequence
                                  ? fmt::format("a list of {}", node.items.size())
                                  : describe(node);
    add(problems, node, found, "a list of three numbers such as [0, 0, -1]");
    return std::nullopt;
  }
  Vec3 direction = Vec3::Zero();
  bool complete = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value =
        read_number(node.items[i], {.doc = "", .minimum = -1e6, .maximum = 1e6}, problems);
    complete = complete && value.has_value();
    direction[static_cast<Eigen::Index>(i)] = value.value_or(0.0);
  }
  if (!complete) return std::nullopt;
  if (direction.norm() < 1e-6) {
    add(problems, node, "a direction of no length", "at least one number that is not zero");
    return std::nullopt;
  }
  return direction;
}

void read_field(const YamlNode& node, const Field& field, Scenario& scenario, Problems& problems) {
  std::visit(ReadInto{node, field, scenario, problems}, field.slot);
}

bool expect_mapping(const YamlNode& node, const std::string& wanted, Problems& problems) {
  if (node.kind == YamlNode::Kind::mapping) return true;
  add(problems, node, describe(node), wanted);
  return false;
}

}  // namespace facies::scenario
