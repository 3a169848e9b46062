// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "facies/base/quantity.hpp"
#include "facies/scenario/describe_schema.hpp"
#include "facies/scenario/write_scenario.hpp"

namespace facies::scenario {

namespace {

const char* const introduction = R"(# Scenario files

<!-- Written by `facies schema --markdown`; a test keeps it so. Change src/facies/scenario/schema.cpp instead. -->

A scenario is a YAML file (JSON is YAML too) that says what is simulated. Everything but `steps` may be left out.

```yaml
name: smile-open
skin: {preset: flynn2015_stiff, c: 21.3 kPa}
steps:
  - tension: {tsf: 1.10}
  - release: {}
  - express: {ZYG: 0.5, RIS: 0.6}
```

* A value with a dimension has a unit: `21.3 kPa`, `9.8 m/s^2`, `1040 kg/m^3`. A bare number there is an error.
* A key that is not known is an error, and so is a key that is given twice. Anchors, aliases and tags are refused.
* `facies check SCENARIO` reports everything that is wrong, at once, each with file:line:column.
* `--set KEY=VALUE` replaces a value from the command line: `--set skin.preset=flynn2015_stiff`. Steps count from 1
  (`--set steps.1.tension.tsf=1.05`); where the scenario has only one step of a kind, its name is enough
  (`--set tension.tsf=1.05`, `--set express.ZYG=0.3`).
* Editors complete and check scenarios with the JSON Schema that `facies schema` prints.
)";

struct TypeName {
  const Rule& rule;
  std::string operator()(std::string* (*)(Scenario&)) const {
    return rule.choices.empty() ? "text" : "one of";
  }
  std::string operator()(double* (*)(Scenario&)) const {
    return name_of(unit(rule.unit).dimension);
  }
  std::string operator()(int* (*)(Scenario&)) const { return "whole number"; }
  std::string operator()(bool* (*)(Scenario&)) const { return "true or false"; }
  std::string operator()(Vec3* (*)(Scenario&)) const { return "list of three numbers"; }
};

std::string admitted(const Field& field) {
  std::string text = std::visit(TypeName{field.rule}, field.slot);
  if (const std::string range = range_in_words(field.rule); !range.empty()) text += ", " + range;
  for (const std::string& choice : field.rule.choices)
    text += " `" + choice + '`';
  return text;
}

std::string field_rows(const std::string& section) {
  const Scenario defaults;
  std::string text = "| key | default | may be | meaning |\n|---|---|---|---|\n";
  for (const Field& field : fields()) {
    if (section_of(field.path) != section) continue;
    std::string standard = value_text(field, defaults);
    standard = standard == "\"\"" ? "" : fmt::format("`{}`", standard);
    text += fmt::format("| `{}` | {} | {} | {} |\n",
                        section.empty() ? field.path : field.path.substr(section.size() + 1),
                        standard, admitted(field), field.rule.doc);
  }
  return text;
}

template <class Spec>
std::string law_text(const Spec& law) {
  std::string text = fmt::format("\n### {}\n\n{} ({}).\n\n", law.name, law.summary, law.source);
  text += "| parameter | unit | may be | meaning |\n|---|---|---|---|\n";
  for (const material::ParamSpec& parameter : law.parameters) {
    const Rule rule = rule_of(parameter);
    std::string range = range_in_words(rule);
    if (parameter.default_value) range += fmt::format("; without it {}", *parameter.default_value);
    text += fmt::format("| `{}` | {} | {} | {} |\n", parameter.name, parameter.unit, range,
                        parameter.meaning);
  }
  return text;
}

std::string laws_text() {
  std::string text =
      "\n## Laws and their parameters\n\nParameters are keys of `skin`, `hypodermis` or `muscle` "
      "beside `law` and `preset`.\n";
  for (const material::LawSpec& law : material::laws())
    text += law_text(law);
  for (const material::VolumetricSpec& law : material::volumetric_laws())
    text += law_text(law);
  for (const material::FibreSpec& law : material::fibre_laws())
    text += law_text(law);
  return text;
}

std::string presets_text() {
  std::string text =
      "\n## Presets\n\n| preset | law | values | source | what is doubtful "
      "|\n|---|---|---|---|---|\n";
  for (const material::Preset& preset : material::presets()) {
    std::string values;
    for (const auto& [name, value] : preset.values) {
      values += fmt::format("{}{} {}", values.empty() ? "" : ", ", name, value);
    }
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", preset.name, preset.law, values,
                        preset.source, preset.note);
  }
  return text;
}

std::string steps_text() {
  std::string text = "\n## steps\n\nA list; each step begins where the one before it ended.\n";
  for (const StepKind& kind : step_kinds()) {
    text +=
        fmt::format("\n### {}\n\n{}\n\n```yaml\n- {}\n```\n", kind.name, kind.doc, kind.example);
  }
  const MoveRules& move = move_rules();
  text += "\n| key of move | may be | meaning |\n|---|---|---|\n";
  text += fmt::format("| `duration` | time, {} | {} |\n", range_in_words(move.duration),
                      move.duration.doc);
  text += fmt::format("| `method` | `dynamic` `quasi_static`; without it `{}` | {} |\n",
                      MoveStep{}.method, move.method.doc);
  text += fmt::format("| `frames` | whole number, {}; without it {} | {} |\n",
                      range_in_words(move.frames), MoveStep{}.frames, move.frames.doc);
  text += fmt::format("| `curves` | path of a file | {} |\n", move.curves.doc);
  text += fmt::format("\n`tsf`: {}. Without it {}. Activations: {}.\n", range_in_words(tsf_rule()),
                      TensionStep{}.tsf, range_in_words(activation_rule()));
  return text;
}

}  // namespace

std::string reference_page() {
  std::string text = introduction;
  text += "\n## At the top of the file\n\n" + field_rows("");
  for (const Section& section : sections()) {
    text += fmt::format("\n## {}\n\n{}\n\n{}", section.name, section.doc, field_rows(section.name));
  }
  return text + steps_text() + laws_text() + presets_text();
}

}  // namespace facies::scenario
