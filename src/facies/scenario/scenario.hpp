// SPDX-License-Identifier: Apache-2.0
// One simulation as plain, validated data: what a scenario file says once it is read. The values that stand here are
// the defaults of the file; what each may be is said in schema.cpp, once.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "facies/material/catalog.hpp"
#include "facies/scenario/curve.hpp"

namespace facies::scenario {

/// The preset's name where every value is given one by one.
inline constexpr const char* no_preset = "none";

/// What a layer of tissue is made of. `values` and `volumetric_values` are complete, in the units of the catalog.
struct TissueChoice {
  std::string law;                              ///< a material::LawSpec
  std::string preset;                           ///< a material::Preset of that law, or no_preset
  material::Parameters values = {};             ///< of the law: preset, then what the file changes
  std::string volumetric = "volumetric_log";    ///< a material::VolumetricSpec
  material::Parameters volumetric_values = {};  ///< of the volumetric law: "kappa"

  friend bool operator==(const TissueChoice&, const TissueChoice&) = default;
};

/// What muscle fibres add to the tissue that they run through.
struct MuscleChoice {
  std::string law = "fibre_blemker2005";    ///< a material::FibreSpec
  std::string preset = "flynn2015_muscle";  ///< a material::Preset of that law, or no_preset
  material::Parameters values = {};         ///< complete, in the units of the catalog
  std::string passive = "kPa";  ///< what the passive stress is measured in: none, kPa or sigma_max
  double radius =
      6.0;  ///< elements whose centroid lies closer to a fibre belong to its muscle [mm]
  double margin = 3.0;         ///< how far beyond a muscle that is a band tissue belongs to it [mm]
  std::string leave_out = {};  ///< fibres that do not count, with blanks between: "LAO.1"

  friend bool operator==(const MuscleChoice&, const MuscleChoice&) = default;
};

struct Gravity {
  double magnitude = 9800.0;          ///< [mm/s^2]
  Vec3 direction = {0.0, 0.0, -1.0};  ///< of any length but zero; +z is up
  std::string from = "release";  ///< the kind of step that brings it on: "release" or "express"

  /// The acceleration [mm/s^2].
  [[nodiscard]] Vec3 vector() const { return magnitude * direction.normalized(); }

  friend bool operator==(const Gravity&, const Gravity&) = default;
};

/// What tissue may not pass.
struct ContactChoice {
  bool bones = true;  ///< mandible and maxilla, where the face has them
  std::string skull =
      "inner_surface";      ///< what stands for bone that is not given: "inner_surface" or "none"
  bool lips = true;         ///< the surface around the mouth against itself
  double distance = 1.0;    ///< from which on a surface is felt [mm]
  double stiffness = 20.0;  ///< of the barrier [kPa/mm]

  friend bool operator==(const ContactChoice&, const ContactChoice&) = default;
};

/// Stress-free tissue is the face divided by `tsf`; the held nodes are taken to their places in the face
/// (paper, "Imposition of an in vivo skin tension"). Always the first step.
struct TensionStep {
  double tsf = 1.10;  ///< tension scaling factor

  friend bool operator==(const TensionStep&, const TensionStep&) = default;
};

/// The reactions that hold the inner surface are taken back to zero. Follows a tension step.
struct ReleaseStep {
  friend bool operator==(const ReleaseStep&, const ReleaseStep&) = default;
};

/// Muscles go from where they are to these activations; a muscle that is not named goes to zero.
struct ExpressStep {
  std::map<std::string, double>
      activations;  ///< by group ("ZYG": both sides) or muscle ("ZYG_L"), 0..1

  friend bool operator==(const ExpressStep&, const ExpressStep&) = default;
};

/// Muscles of the jaw go from where they are to these excitations; the others stay as they are.
struct OpenJawStep {
  std::map<std::string, double> excitations;  ///< by exciter ("bi_open") or muscle ("lad"), 0..1

  friend bool operator==(const OpenJawStep&, const OpenJawStep&) = default;
};

/// Muscles follow curves in time, from rest; those without a curve stay as they are.
struct MoveStep {
  double duration = 0.0;           ///< [s]
  std::string method = "dynamic";  ///< or "quasi_static": one equilibrium after the other
  int frames = 25;                 ///< states that are recorded after the beginning, evenly in time
  std::string curves = {};  ///< path of a table whose columns are among `levels`; empty: none
  std::map<std::string, Curve> levels =
      {};  ///< by muscle of expression or of the jaw, or exciter, 0..1

  friend bool operator==(const MoveStep&, const MoveStep&) = default;
};

using Step = std::variant<TensionStep, ReleaseStep, ExpressStep, OpenJawStep, MoveStep>;

/// "tension", "release", "express", "open_jaw" or "move".
[[nodiscard]] std::string step_name(const Step& step);

/// The activation that `step` gives to a muscle: its own entry, else that of its group, else zero.
[[nodiscard]] double activation_of(const ExpressStep& step, const std::string& muscle,
                                   const std::string& group);

struct SolverChoice {
  double relative_tolerance = 1e-6;        ///< |r| over the free unknowns, relative to the load
  int max_iterations = 200;                ///< Newton iterations of one increment
  int max_increments = 400;                ///< increments of one step, failed ones counted
  double first_increment = 1.0;            ///< part of a step that is tried first
  double smallest_increment = 1.0 / 32.0;  ///< part of a step below which it is given up
  int parts = 1;    ///< that steps express and open_jaw go in, each to its equilibrium
  int threads = 0;  ///< 0: as many as the machine has; results do not depend on it

  friend bool operator==(const SolverChoice&, const SolverChoice&) = default;
};

/// How things move in time.
struct DynamicsChoice {
  double rayleigh_alpha = 80.0;  ///< damping by mass [1/s]
  double rayleigh_beta = 0.02;   ///< damping by stiffness [s]
  double rho_inf = 0.8;          ///< what a time step leaves of oscillations much faster than it
  double tolerance = 0.01;       ///< error of one time step [mm]
  double first_step = 1e-3;      ///< [s]
  double smallest_step = 1e-7;   ///< [s]

  friend bool operator==(const DynamicsChoice&, const DynamicsChoice&) = default;
};

struct OutputChoice {
  bool pictures = true;
  std::string fields = "steps";  ///< field files: "none", of the "last" state, or after all "steps"
  int frames = 0;  ///< equal parts that express and open_jaw steps go in, each a frame; 0: none

  friend bool operator==(const OutputChoice&, const OutputChoice&) = default;
};

struct Scenario {
  std::string name;            ///< names the result folder; the file's name where it does not say
  std::string title;           ///< one line for people
  std::string expression;      ///< of the publication that it is compared with; empty: `name`
  std::string face = "patch";  ///< what anatomy::load_face understands
  TissueChoice skin = {.law = "fung_orthotropic", .preset = "flynn2015_normal"};
  TissueChoice hypodermis = {.law = "mooney_rivlin", .preset = "flynn2015_hypodermis"};
  MuscleChoice muscle;
  double density = 1040e-9;  ///< of all tissue [kg/mm^3]
  Gravity gravity;
  ContactChoice contact;
  std::string jaw = "free";  ///< or "held" where it stands at rest
  std::vector<Step> steps;
  SolverChoice solver;
  DynamicsChoice dynamics;
  OutputChoice output;

  /// Where each entry was written: "skin.c" -> "smile.yaml:12:6" or "--set skin.c". Steps count from 1.
  std::map<std::string, std::string> written_at;

  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// The expression of the publication that results are compared with: what the scenario says, else its name.
[[nodiscard]] const std::string& expression_of(const Scenario& scenario);

/// Where `path` ("steps.3.express.ZYG") or the nearest entry around it was written; empty where nobody knows.
[[nodiscard]] std::string where_of(const Scenario& scenario, std::string path);

}  // namespace facies::scenario
