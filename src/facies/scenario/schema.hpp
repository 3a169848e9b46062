// SPDX-License-Identifier: Apache-2.0
// What a scenario file may say: one list of fields. Reading, writing, `facies schema` and docs/scenario-reference.md
// all follow from it; the defaults are those of scenario.hpp, the parameters of laws those of the material catalog.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

/// What a value may be.
struct Rule {
  std::string doc;  ///< one or two sentences
  std::string unit =
      {};  ///< a unit of its dimension, used in messages and files; empty: a plain number
  double minimum = -std::numeric_limits<double>::infinity();  ///< in `unit`
  double maximum = std::numeric_limits<double>::infinity();   ///< in `unit`
  bool exclusive_minimum = false;         ///< the minimum itself is not admissible
  std::vector<std::string> choices = {};  ///< of a text; empty: any
};

/// Where a scenario keeps a value; its type is the type of the field.
using Slot = std::variant<std::string* (*)(Scenario&), double* (*)(Scenario&), int* (*)(Scenario&),
                          bool* (*)(Scenario&), Vec3* (*)(Scenario&)>;

/// One value of a scenario file.
struct Field {
  std::string path;  ///< "solver.threads"
  Rule rule;
  Slot slot;
};

/// A mapping at the top of a scenario file.
struct Section {
  std::string name;  ///< "solver"
  std::string doc;
};

/// One kind of step.
struct StepKind {
  std::string name;  ///< "tension"
  std::string doc;
  std::string example;  ///< "tension: {tsf: 1.10}"
};

/// A section that chooses laws of the catalog: their parameters are keys of it beside its fields.
struct MaterialSection {
  std::string name;  ///< "skin"
  TissueChoice* (*tissue)(Scenario&) =
      nullptr;  ///< where it is kept; nullptr for the muscles' section
};

/// In the order in which files are written.
[[nodiscard]] std::span<const Field> fields();
[[nodiscard]] std::span<const Section> sections();
[[nodiscard]] std::span<const MaterialSection> material_sections();
[[nodiscard]] std::span<const StepKind> step_kinds();

/// What `tsf` of a tension step and an activation of an express step may be.
[[nodiscard]] const Rule& tsf_rule();
[[nodiscard]] const Rule& activation_rule();

/// What the keys of a move step may be; every other key of it is a name with a curve.
struct MoveRules {
  Rule duration, method, frames, curves;
};
[[nodiscard]] const MoveRules& move_rules();
[[nodiscard]] bool is_move_key(const std::string& key);

/// The section of a path: "solver" of "solver.threads", empty for "density".
[[nodiscard]] std::string section_of(const std::string& path);

/// The field at `path`; nullptr where there is none.
[[nodiscard]] const Field* find_field(const std::string& path);

/// What a rule admits, in words: "more than 0.5 and at most 3", "from 0 kg/m^3 to 20000 kg/m^3".
[[nodiscard]] std::string range_in_words(const Rule& rule);

/// The rule of a law's parameter.
[[nodiscard]] Rule rule_of(const material::ParamSpec& parameter);

/// The parameters of every law that a section may name, each name once.
[[nodiscard]] std::vector<material::ParamSpec> every_parameter(const MaterialSection& section);

/// Names of the presets of one law.
[[nodiscard]] std::vector<std::string> presets_of(const std::string& law);

}  // namespace facies::scenario
