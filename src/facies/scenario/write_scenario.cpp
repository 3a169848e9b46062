// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/write_scenario.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/quantity.hpp"
#include "facies/base/text.hpp"
#include "facies/scenario/read_parts.hpp"

namespace facies::scenario {

namespace {

/// As it stands where no YAML reader can take it for something else, else in double quotes.
std::string text_value(const std::string& text) {
  const bool plain =
      !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
      std::all_of(text.begin(), text.end(), [](unsigned char letter) {
        return std::isalnum(letter) != 0 || letter == '_' || letter == '-' || letter == '.';
      });
  static const std::vector<std::string> words = {"true", "false", "yes", "no",  "on",  "off",
                                                 "null", "y",     "n",   "inf", "nan", "infinity"};
  const bool means_something =
      std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return word.size() == text.size() &&
               std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
                 return a == std::tolower(static_cast<unsigned char>(b));
               });
      });
  if (plain && !means_something) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') quoted += '\\';
    if (code < 0x20 || code == 0x7f) {
      quoted += fmt::format("\\x{:02x}", code);
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

/// "1.0e-06" for 1e-06: YAML 1.1 takes that for a text.
std::string number_text(double value, const Unit& in = {}) {
  std::string text = format_quantity(value, in);
  const std::size_t exponent = text.find_first_of(".e");
  if (exponent != std::string::npos && text[exponent] == 'e') text.insert(exponent, ".0");
  return text;
}

struct ValueText {
  const Rule& rule;
  Scenario& scenario;

  std::string operator()(std::string* (*slot)(Scenario&)) const {
    return text_value(*slot(scenario));
  }
  std::string operator()(double* (*slot)(Scenario&)) const {
    return number_text(*slot(scenario), unit(rule.unit));
  }
  std::string operator()(int* (*slot)(Scenario&)) const {
    return fmt::format("{}", *slot(scenario));
  }
  std::string operator()(bool* (*slot)(Scenario&)) const {
    return *slot(scenario) ? "true" : "false";
  }
  std::string operator()(Vec3* (*slot)(Scenario&)) const {
    const Vec3& v = *slot(scenario);
    return fmt::format("[{}, {}, {}]", number_text(v.x()), number_text(v.y()), number_text(v.z()));
  }
};

std::string parameters_text(const MaterialSection& section, Scenario& scenario) {
  material::Parameters values =
      section.tissue == nullptr ? scenario.muscle.values : section.tissue(scenario)->values;
  if (section.tissue != nullptr)
    values.merge(material::Parameters(section.tissue(scenario)->volumetric_values));
  std::string text;
  for (const material::ParamSpec& spec : parameters_of(section, scenario)) {
    const auto value = values.find(spec.name);
    if (value == values.end()) continue;
    const Unit in = unit(spec.unit);
    text += fmt::format("  {}: {}\n", spec.name,
                        number_text(value->second * in.numerator / in.denominator, in));
  }
  return text;
}

struct StepText {
  std::string operator()(const TensionStep& step) const {
    return fmt::format("tension: {{tsf: {}}}", number_text(step.tsf));
  }
  std::string operator()(const ReleaseStep&) const { return "release: {}"; }
  std::string operator()(const ExpressStep& step) const {
    return "express: " + levels(step.activations);
  }
  std::string operator()(const OpenJawStep& step) const {
    return "open_jaw: " + levels(step.excitations);
  }
  /// Curves of a table stand here like the others: the text is all that it takes to repeat a run.
  std::string operator()(const MoveStep& step) const {
    std::string text = fmt::format("move:\n      duration: {}\n      method: {}\n      frames: {}",
                                   number_text(step.duration, unit("s")), step.method, step.frames);
    for (const auto& [name, curve] : step.levels)
      text += fmt::format("\n      {}: {}", text_value(name), points(curve));
    return text;
  }

 private:
  static std::string points(const Curve& curve) {
    std::string inside;
    for (const CurvePoint& point : curve.points) {
      inside += fmt::format("{}[{}, {}]", inside.empty() ? "" : ", ",
                            number_text(point.time, unit("s")), number_text(point.value));
    }
    return "[" + inside + "]";
  }

  static std::string levels(const std::map<std::string, double>& of) {
    std::string inside;
    for (const auto& [name, alpha] : of) {
      if (!inside.empty()) inside += ", ";
      inside += fmt::format("{}: {}", text_value(name), number_text(alpha));
    }
    return "{" + inside + "}";
  }
};

}  // namespace

std::string value_text(const Field& field, const Scenario& scenario) {
  Scenario copy = scenario;
  return std::visit(ValueText{field.rule, copy}, field.slot);
}

std::string to_yaml(const Scenario& scenario) {
  Scenario copy = scenario;
  std::string text;
  for (const Field& field : fields()) {
    if (!section_of(field.path).empty()) continue;
    text += fmt::format("{}: {}\n", field.path, value_text(field, copy));
  }
  for (const Section& section : sections()) {
    text += fmt::format("\n{}:\n", section.name);
    for (const Field& field : fields()) {
      if (section_of(field.path) != section.name) continue;
      text += fmt::format("  {}: {}\n", field.path.substr(section.name.size() + 1),
                          value_text(field, copy));
    }
    for (const MaterialSection& materials : material_sections()) {
      if (materials.name == section.name) text += parameters_text(materials, copy);
    }
  }
  text += "\nsteps:\n";
  for (const Step& step : scenario.steps)
    text += "  - " + std::visit(StepText{}, step) + '\n';
  return text;
}

}  // namespace facies::scenario
