// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/schema.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace facies::scenario {

namespace {

template <class Spec>
std::vector<std::string> names_of(std::span<const Spec> specs) {
  std::vector<std::string> names;
  for (const Spec& spec : specs)
    names.push_back(spec.name);
  return names;
}

/// Presets of any of `laws`, and the word for none.
std::vector<std::string> preset_choices(const std::vector<std::string>& laws) {
  std::vector<std::string> names;
  for (const std::string& law : laws) {
    for (const std::string& preset : presets_of(law))
      names.push_back(preset);
  }
  names.emplace_back(no_preset);
  return names;
}

std::vector<std::string> passive_choices() {
  std::vector<std::string> names;
  for (const material::FibreSpec& law : material::fibre_laws()) {
    for (const std::string& choice : law.passive_choices) {
      if (std::find(names.begin(), names.end(), choice) == names.end()) names.push_back(choice);
    }
  }
  return names;
}

Rule law_rule(std::vector<std::string> choices) {
  return {
      .doc = "Law of the catalog (`facies list laws`); its parameters are keys of this section.",
      .choices = std::move(choices)};
}

Rule preset_rule(const std::vector<std::string>& laws) {
  return {.doc =
              "Published values to start from (`facies list presets`); values given beside it "
              "replace its own. `none`: every value is given. Without a preset a law other than "
              "the default one starts from `none`; a preset alone brings its law with it.",
          .choices = preset_choices(laws)};
}

Rule volumetric_rule() {
  return {.doc = "Law of the change of volume; its parameters are keys of this section.",
          .choices = names_of(material::volumetric_laws())};
}

std::vector<Field> general_fields() {
  return {
      {"name",
       {.doc = "Names the result folder. Without it: the name of the file."},
       [](Scenario& s) { return &s.name; }},
      {"title", {.doc = "One line for people."}, [](Scenario& s) { return &s.title; }},
      {"expression",
       {.doc = "The expression of the paper that results are compared with, where the face is the "
               "paper's. Without it: `name`."},
       [](Scenario& s) { return &s.expression; }},
      {"face",
       {.doc =
            "Whose face (`facies list faces`); `--face` replaces it. Paths count from the folder "
            "in which facies is started."},
       [](Scenario& s) { return &s.face; }},
      {"density",
       {.doc = "Mass density of all soft tissue.",
        .unit = "kg/m^3",
        .minimum = 0.0,
        .maximum = 20000.0},
       [](Scenario& s) { return &s.density; }},
      {"gravity.magnitude",
       {.doc = "Acceleration of gravity.", .unit = "m/s^2", .minimum = 0.0, .maximum = 1000.0},
       [](Scenario& s) { return &s.gravity.magnitude; }},
      {"gravity.direction",
       {.doc = "Where it points, of any length: -x is anterior, +y the subject's right, +z up."},
       [](Scenario& s) { return &s.gravity.direction; }},
      {"gravity.from",
       {.doc = "The kind of step that brings gravity on: release, so that the tensioned rest, from "
               "which displacements count, has sagged, or express, so that it has not "
               "(docs/decisions/gravity.md).",
        .choices = {"release", "express"}},
       [](Scenario& s) { return &s.gravity.from; }},
  };
}

std::vector<Field> contact_fields() {
  return {
      {"jaw",
       {.doc = "`free`: the mandible moves on its joints, pulled by its muscles, its weight and "
               "the tissue. `held`: it stays "
               "where it stands at rest. Means nothing for a face without a jaw.",
        .choices = {"free", "held"}},
       [](Scenario& s) { return &s.jaw; }},
      {"contact.bones",
       {.doc = "The inner surface does not pass mandible and maxilla, where the face has them."},
       [](Scenario& s) { return &s.contact.bones; }},
      {"contact.skull",
       {.doc = "What stands for bone whose surface is not given (forehead, orbit, nose, zygoma): "
               "the inner surface in its "
               "place in the face, from which tissue can slide and lift off but not sink in; or "
               "nothing. Means nothing for a face that does not say where it lies on such bone.",
        .choices = {"inner_surface", "none"}},
       [](Scenario& s) { return &s.contact.skull; }},
      {"contact.lips",
       {.doc = "The surface around the mouth does not pass through itself: lip against lip, folds "
               "at the corners. Means nothing for a face whose mouth corners are not known."},
       [](Scenario& s) { return &s.contact.lips; }},
      {"contact.distance",
       {.doc = "Surfaces feel each other from this distance on; they never touch.",
        .unit = "mm",
        .minimum = 0.001,
        .maximum = 5.0},
       [](Scenario& s) { return &s.contact.distance; }},
      {"contact.stiffness",
       {.doc = "Stiffness of the barrier between surfaces: pressure by distance.",
        .unit = "kPa/mm",
        .minimum = 0.1,
        .maximum = 1e6},
       [](Scenario& s) { return &s.contact.stiffness; }},
  };
}

std::vector<Field> material_fields() {
  const std::vector<std::string> laws = names_of(material::laws());
  const std::vector<std::string> fibre_laws = names_of(material::fibre_laws());
  return {
      {"skin.law", law_rule(laws), [](Scenario& s) { return &s.skin.law; }},
      {"skin.preset", preset_rule(laws), [](Scenario& s) { return &s.skin.preset; }},
      {"skin.volumetric", volumetric_rule(), [](Scenario& s) { return &s.skin.volumetric; }},
      {"hypodermis.law", law_rule(laws), [](Scenario& s) { return &s.hypodermis.law; }},
      {"hypodermis.preset", preset_rule(laws), [](Scenario& s) { return &s.hypodermis.preset; }},
      {"hypodermis.volumetric", volumetric_rule(),
       [](Scenario& s) { return &s.hypodermis.volumetric; }},
      {"muscle.law", law_rule(fibre_laws), [](Scenario& s) { return &s.muscle.law; }},
      {"muscle.preset", preset_rule(fibre_laws), [](Scenario& s) { return &s.muscle.preset; }},
      {"muscle.passive",
       {.doc = "What the passive fibre stress is measured in: `kPa` takes Eq. 6 of the paper "
               "literally, `sigma_max` reads it as normalised, `none` leaves it out.",
        .choices = passive_choices()},
       [](Scenario& s) { return &s.muscle.passive; }},
      {"muscle.radius",
       {.doc = "An element belongs to a muscle if its centroid lies closer than this to one of the "
               "muscle's fibres, at the stress-free size. Muscles of the built-in face have widths "
               "and "
               "thicknesses instead (data/builtin/muscles.csv).",
        .unit = "mm",
        .minimum = 0.0,
        .maximum = 100.0,
        .exclusive_minimum = true},
       [](Scenario& s) { return &s.muscle.radius; }},
      {"muscle.margin",
       {.doc = "Tissue this far around a muscle that has a width and a thickness belongs to it. "
               "With 3 mm the muscles of the built-in face have the cross-sections of the paper's, "
               "so that activations mean the same.",
        .unit = "mm",
        .minimum = 0.0,
        .maximum = 20.0},
       [](Scenario& s) { return &s.muscle.margin; }},
      {"muscle.leave_out",
       {.doc = "Fibres of the face that do not count, with blanks between: `LAO.1` is the first "
               "fibre of the levator anguli oris on each side "
               "(data/reference-face/muscle-fibres.csv)."},
       [](Scenario& s) { return &s.muscle.leave_out; }},
  };
}

std::vector<Field> run_fields() {
  return {
      {"solver.relative_tolerance",
       {.doc = "Equilibrium is reached when the residual is smaller than this part of the load.",
        .minimum = 1e-14,
        .maximum = 0.1},
       [](Scenario& s) { return &s.solver.relative_tolerance; }},
      {"solver.max_iterations",
       {.doc = "Newton iterations of one increment.", .minimum = 1, .maximum = 1000},
       [](Scenario& s) { return &s.solver.max_iterations; }},
      {"solver.max_increments",
       {.doc = "Increments of one step, failed ones counted.", .minimum = 1, .maximum = 100000},
       [](Scenario& s) { return &s.solver.max_increments; }},
      {"solver.first_increment",
       {.doc = "The part of a step that is tried first.", .minimum = 1e-6, .maximum = 1.0},
       [](Scenario& s) { return &s.solver.first_increment; }},
      {"solver.smallest_increment",
       {.doc =
            "The part of a step below which an increment is not cut again: the run then ends with "
            "exit status 5.",
        .minimum = 1e-6,
        .maximum = 1.0},
       [](Scenario& s) { return &s.solver.smallest_increment; }},
      {"solver.parts",
       {.doc = "Steps `express` and `open_jaw` go in at least this many equal parts, each to its "
               "equilibrium. Tissue that folds can come to rest in more than one place; the finer "
               "the parts, the surer it is the one that slowly driven muscles lead to.",
        .minimum = 1,
        .maximum = 240},
       [](Scenario& s) { return &s.solver.parts; }},
      {"solver.threads",
       {.doc = "Threads; 0 takes all of the machine. Results do not depend on it.",
        .minimum = 0,
        .maximum = 1024},
       [](Scenario& s) { return &s.solver.threads; }},
      {"output.pictures",
       {.doc = "Draw pictures."},
       [](Scenario& s) { return &s.output.pictures; }},
      {"output.fields",
       {.doc = "Field files for ParaView: none, of the last state, or after all steps.",
        .choices = {"none", "last", "steps"}},
       [](Scenario& s) { return &s.output.fields; }},
      {"output.frames",
       {.doc = "Steps `express` and `open_jaw` go in at least this many equal parts. Each ends in "
               "equilibrium and is "
               "a frame of an animation and, with `fields: steps`, a field file. 0: no frames.",
        .minimum = 0,
        .maximum = 240},
       [](Scenario& s) { return &s.output.frames; }},
  };
}

std::vector<Field> dynamics_fields() {
  return {
      {"dynamics.rayleigh_alpha",
       {.doc = "Damping of the tissue by its mass: force alpha M v.",
        .unit = "1/s",
        .minimum = 0.0,
        .maximum = 1e6},
       [](Scenario& s) { return &s.dynamics.rayleigh_alpha; }},
      {"dynamics.rayleigh_beta",
       {.doc = "Damping of the tissue by its stiffness: force beta K v.",
        .unit = "s",
        .minimum = 0.0,
        .maximum = 100.0},
       [](Scenario& s) { return &s.dynamics.rayleigh_beta; }},
      {"dynamics.rho_inf",
       {.doc = "What one time step leaves of an oscillation that is much faster than the steps; 1 "
               "leaves all of it.",
        .minimum = 0.0,
        .maximum = 1.0},
       [](Scenario& s) { return &s.dynamics.rho_inf; }},
      {"dynamics.tolerance",
       {.doc = "Error that one time step may have anywhere; steps are as long as it allows.",
        .unit = "mm",
        .minimum = 1e-9,
        .maximum = 10.0},
       [](Scenario& s) { return &s.dynamics.tolerance; }},
      {"dynamics.first_step",
       {.doc = "The time step that is tried first.",
        .unit = "s",
        .minimum = 1e-9,
        .maximum = 100.0},
       [](Scenario& s) { return &s.dynamics.first_step; }},
      {"dynamics.smallest_step",
       {.doc = "The time step below which the run is given up, with exit status 5.",
        .unit = "s",
        .minimum = 1e-12,
        .maximum = 100.0},
       [](Scenario& s) { return &s.dynamics.smallest_step; }},
  };
}

std::vector<Field> all_fields() {
  std::vector<Field> all = general_fields();
  for (auto* more : {contact_fields, material_fields, run_fields, dynamics_fields}) {
    for (Field& field : more())
      all.push_back(std::move(field));
  }
  return all;
}

}  // namespace

std::span<const Field> fields() {
  static const std::vector<Field> all = all_fields();
  return all;
}

std::span<const Section> sections() {
  static const std::vector<Section> all = {
      {"gravity", "Weight of the tissue."},
      {"contact", "What tissue may not pass."},
      {"skin", "The outer layer: epidermis and dermis."},
      {"hypodermis", "The layers below the skin."},
      {"muscle", "What fibres add to the tissue that they run through."},
      {"solver", "How equilibrium is looked for."},
      {"dynamics", "How things move in time: for steps `move` (docs/theory/dynamics.md)."},
      {"output", "What is written beside tables and summary."},
  };
  return all;
}

std::span<const MaterialSection> material_sections() {
  static const std::vector<MaterialSection> all = {
      {"skin", [](Scenario& s) { return &s.skin; }},
      {"hypodermis", [](Scenario& s) { return &s.hypodermis; }},
      {"muscle"},
  };
  return all;
}

std::span<const StepKind> step_kinds() {
  static const std::vector<StepKind> all = {
      {"tension",
       "Puts the living tension into the tissue: the stress-free size is the face divided by "
       "`tsf`, and the inner surface is taken to its place in the face. At most one, and the first "
       "step.",
       "tension: {tsf: 1.10}"},
      {"release",
       "Takes the forces that held the inner surface back to zero. At most one, after a tension "
       "step. Displacements are measured from where it ends.",
       "release: {}"},
      {"express",
       "Takes the muscles from where they are to these activations, by muscle (`ZYG`: both sides) "
       "or by side (`ZYG_L`, `ZYG_R`; goes before `ZYG`). A muscle that is not named goes to zero.",
       "express: {ZYG: 0.5, RIS: 0.6}"},
      {"open_jaw",
       "Takes muscles of the jaw from where they are to these excitations, by exciter (`bi_open`) "
       "or muscle "
       "(`lad`; goes before exciters); the others, and the muscles of expression, stay as they "
       "are.",
       "open_jaw: {bi_open: 1}"},
      {"move",
       "Muscles follow curves in time, for a `duration`. Every key but `duration`, `method`, "
       "`frames` and `curves` names a muscle of expression (`ZYG`: both sides; `ZYG_L` goes before "
       "it), a muscle of the jaw or an exciter; its value is a number, or points `[time, value]` "
       "with straight lines between them: before the first point its value, after the last that of "
       "the last. What has no curve stays as it is. Over the first tenth of the duration "
       "everything "
       "goes from where it was before the step to its curve, so that nothing jumps. A move begins "
       "at "
       "rest.",
       "move:\n    duration: 0.5 s\n    ZYG: [[0 s, 0], [0.2 s, 0.5], [0.5 s, 0.3]]\n    RIS_L: "
       "0.4"},
  };
  return all;
}

const Rule& tsf_rule() {
  static const Rule rule = {.doc = "Tension scaling factor of the paper.",
                            .minimum = 0.5,
                            .maximum = 3.0,
                            .exclusive_minimum = true};
  return rule;
}

const Rule& activation_rule() {
  static const Rule rule = {.doc = "Activation of a muscle.", .minimum = 0.0, .maximum = 1.0};
  return rule;
}

const MoveRules& move_rules() {
  static const MoveRules rules = {
      .duration = {.doc = "How long it takes. Needed.",
                   .unit = "s",
                   .minimum = 0.0,
                   .maximum = 1000.0,
                   .exclusive_minimum = true},
      .method =
          {.doc = "`dynamic`: with mass and damping. `quasi_static`: as if infinitely slowly, one "
                  "equilibrium for each frame.",
           .choices = {"dynamic", "quasi_static"}},
      .frames = {.doc = "States that are recorded, evenly in time.",
                 .minimum = 1,
                 .maximum = 10000},
      .curves = {.doc =
                     "A table of curves: comma separated, the column `time_s`, then one for each "
                     "name. Its path counts from the folder of the scenario."}};
  return rules;
}

bool is_move_key(const std::string& key) {
  return key == "duration" || key == "method" || key == "frames" || key == "curves";
}

std::string section_of(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? std::string() : path.substr(0, dot);
}

const Field* find_field(const std::string& path) {
  for (const Field& field : fields()) {
    if (field.path == path) return &field;
  }
  return nullptr;
}

std::string range_in_words(const Rule& rule) {
  const auto bound = [&rule](double value) {
    return rule.unit.empty() ? fmt::format("{:g}", value)
                             : fmt::format("{:g} {}", value, rule.unit);
  };
  const bool has_minimum = std::isfinite(rule.minimum);
  const bool has_maximum = std::isfinite(rule.maximum);
  std::string from = (rule.exclusive_minimum ? "more than " : "at least ") + bound(rule.minimum);
  const std::string to = "at most " + bound(rule.maximum);
  if (has_minimum && has_maximum) return from + " and " + to;
  if (has_minimum) return from;
  return has_maximum ? to : std::string();
}

Rule rule_of(const material::ParamSpec& parameter) {
  return {.doc = parameter.meaning,
          .unit = parameter.unit,
          .minimum = parameter.minimum,
          .maximum = parameter.maximum,
          .exclusive_minimum = parameter.exclusive_minimum};
}

std::vector<material::ParamSpec> every_parameter(const MaterialSection& section) {
  std::vector<material::ParamSpec> all;
  const auto append = [&all](const auto& laws) {
    for (const auto& law : laws) {
      for (const material::ParamSpec& spec : law.parameters) {
        const bool listed = std::any_of(all.begin(), all.end(),
                                        [&](const auto& other) { return other.name == spec.name; });
        if (!listed) all.push_back(spec);
      }
    }
  };
  if (section.tissue == nullptr) {
    append(material::fibre_laws());
  } else {
    append(material::laws());
    append(material::volumetric_laws());
  }
  return all;
}

std::vector<std::string> presets_of(const std::string& law) {
  std::vector<std::string> names;
  for (const material::Preset& preset : material::presets()) {
    if (preset.law == law) names.push_back(preset.name);
  }
  return names;
}

}  // namespace facies::scenario
