// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "facies/base/quantity.hpp"
#include "facies/base/text.hpp"
#include "facies/scenario/describe_schema.hpp"
#include "facies/scenario/schema.hpp"

namespace facies::scenario {

namespace {

using Json = nlohmann::ordered_json;

/// A quantity is a text; the pattern asks for a number and a unit of the right dimension where one word spells it.
Json quantity_schema(const Rule& rule) {
  const std::vector<std::string> symbols = symbols_of(unit(rule.unit).dimension);
  std::string units;
  for (const std::string& symbol : symbols)
    units += (units.empty() ? "" : "|") + symbol;
  if (units.empty()) units = "[A-Za-z1][A-Za-z0-9*/^ -]*";
  const std::string pattern =
      fmt::format("^\\s*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?\\s*({})\\s*$", units);
  return {{"type", "string"}, {"pattern", pattern}, {"examples", {"1 " + rule.unit}}};
}

Json number_schema(const Rule& rule, const char* type) {
  if (!rule.unit.empty()) return quantity_schema(rule);
  Json schema = {{"type", type}};
  if (std::isfinite(rule.minimum)) {
    schema[rule.exclusive_minimum ? "exclusiveMinimum" : "minimum"] = rule.minimum;
  }
  if (std::isfinite(rule.maximum)) schema["maximum"] = rule.maximum;
  return schema;
}

struct FieldSchema {
  const Rule& rule;
  Scenario& defaults;

  Json operator()(std::string* (*slot)(Scenario&)) const {
    Json schema = {{"type", "string"}};
    if (!rule.choices.empty()) schema["enum"] = rule.choices;
    if (!slot(defaults)->empty()) schema["default"] = *slot(defaults);
    return schema;
  }
  Json operator()(double* (*slot)(Scenario&)) const {
    Json schema = number_schema(rule, "number");
    const double value = *slot(defaults);
    schema["default"] =
        rule.unit.empty() ? Json(value) : Json(format_quantity(value, unit(rule.unit)));
    return schema;
  }
  Json operator()(int* (*slot)(Scenario&)) const {
    Json schema = number_schema(rule, "integer");
    schema["default"] = *slot(defaults);
    return schema;
  }
  Json operator()(bool* (*slot)(Scenario&)) const {
    return {{"type", "boolean"}, {"default", *slot(defaults)}};
  }
  Json operator()(Vec3* (*slot)(Scenario&)) const {
    const Vec3& v = *slot(defaults);
    return {{"type", "array"},
            {"items", {{"type", "number"}}},
            {"minItems", 3},
            {"maxItems", 3},
            {"default", {v.x(), v.y(), v.z()}}};
  }
};

Json closed_object(Json properties) {
  return {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

Json described(Json schema, const Rule& rule) {
  schema["description"] = rule.doc;
  return schema;
}

Json move_schema() {
  const MoveRules& rules = move_rules();
  const MoveStep defaults;
  const Json level = number_schema(activation_rule(), "number");
  const Json point = {{"type", "array"},
                      {"items", {quantity_schema(rules.duration), level}},
                      {"minItems", 2},
                      {"maxItems", 2}};
  Json method = {{"type", "string"}, {"enum", rules.method.choices}, {"default", defaults.method}};
  Json frames = number_schema(rules.frames, "integer");
  frames["default"] = defaults.frames;
  return {{"type", "object"},
          {"required", {"duration"}},
          {"properties",
           {{"duration", described(quantity_schema(rules.duration), rules.duration)},
            {"method", described(std::move(method), rules.method)},
            {"frames", described(std::move(frames), rules.frames)},
            {"curves", described({{"type", "string"}}, rules.curves)}}},
          {"additionalProperties",
           {{"oneOf", {level, {{"type", "array"}, {"minItems", 1}, {"items", point}}}}}}};
}

Json step_schema(const StepKind& kind) {
  Json content = closed_object(Json::object());
  if (kind.name == "tension") {
    Json tsf = number_schema(tsf_rule(), "number");
    tsf["description"] = tsf_rule().doc;
    tsf["default"] = TensionStep{}.tsf;
    content["properties"]["tsf"] = tsf;
  }
  if (kind.name == "express" || kind.name == "open_jaw") {
    content = {{"type", "object"},
               {"minProperties", 1},
               {"additionalProperties", number_schema(activation_rule(), "number")}};
  }
  if (kind.name == "move") content = move_schema();
  content["description"] = kind.doc;
  Json step = closed_object({{kind.name, content}});
  step["required"] = {kind.name};
  return step;
}

Json steps_schema() {
  Json kinds = Json::array();
  for (const StepKind& kind : step_kinds())
    kinds.push_back(step_schema(kind));
  kinds.push_back({{"enum", {"tension", "release"}}});
  return {{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", kinds}}}};
}

}  // namespace

std::string json_schema() {
  Scenario defaults;
  Json top = Json::object();
  for (const Section& section : sections()) {
    top[section.name] = closed_object(Json::object());
    top[section.name]["description"] = section.doc;
  }
  for (const Field& field : fields()) {
    Json schema = std::visit(FieldSchema{field.rule, defaults}, field.slot);
    schema["description"] = field.rule.doc;
    const std::string section = section_of(field.path);
    if (section.empty()) {
      top[field.path] = schema;
    } else {
      top[section]["properties"][field.path.substr(section.size() + 1)] = schema;
    }
  }
  for (const MaterialSection& section : material_sections()) {
    for (const material::ParamSpec& parameter : every_parameter(section)) {
      Json schema = number_schema(rule_of(parameter), "number");
      schema["description"] = parameter.meaning;
      top[section.name]["properties"][parameter.name] = schema;
    }
  }
  top["steps"] = steps_schema();
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "facies scenario"}};
  schema.update(closed_object(std::move(top)));
  schema["required"] = {"steps"};
  return schema.dump(2) + '\n';
}

}  // namespace facies::scenario
