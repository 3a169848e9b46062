// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

std::string step_name(const Step& step) {
  struct Name {
    std::string operator()(const TensionStep&) const { return "tension"; }
    std::string operator()(const ReleaseStep&) const { return "release"; }
    std::string operator()(const ExpressStep&) const { return "express"; }
    std::string operator()(const OpenJawStep&) const { return "open_jaw"; }
    std::string operator()(const MoveStep&) const { return "move"; }
  };
  return std::visit(Name{}, step);
}

double activation_of(const ExpressStep& step, const std::string& muscle, const std::string& group) {
  if (const auto own = step.activations.find(muscle); own != step.activations.end())
    return own->second;
  const auto of_group = step.activations.find(group);
  return of_group == step.activations.end() ? 0.0 : of_group->second;
}

const std::string& expression_of(const Scenario& scenario) {
  return scenario.expression.empty() ? scenario.name : scenario.expression;
}

std::string where_of(const Scenario& scenario, std::string path) {
  while (true) {
    const auto entry = scenario.written_at.find(path);
    if (entry != scenario.written_at.end()) return entry->second;
    if (path.empty()) return {};
    const std::size_t dot = path.rfind('.');
    path.resize(dot == std::string::npos ? 0 : dot);
  }
}

}  // namespace facies::scenario
