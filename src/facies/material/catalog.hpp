// SPDX-License-Identifier: Apache-2.0
// Every law that a scenario can name, with its parameters, and every named set of parameters. A new law is one file
// and one line in catalog.cpp; the tests, `facies list laws` and the scenario schema follow from here.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "facies/base/error.hpp"
#include "facies/material/law.hpp"

namespace facies::material {

/// One parameter of a law.
struct ParamSpec {
  std::string name;  ///< as in scenario files: "c", "mu1", "lambda11"
  std::string unit;  ///< "kPa"; empty: dimensionless
  std::string meaning;
  std::optional<double> default_value;  ///< absent: has to be given (or come from a preset)
  double minimum = 0.0;                 ///< smallest admissible value, in `unit`
  bool exclusive_minimum = false;       ///< the minimum itself is not admissible
  double maximum = 1e12;
};

/// Values by parameter name, in the units of the ParamSpec.
using Parameters = std::map<std::string, double>;

/// A matrix law of the catalog.
struct LawSpec {
  std::string name;       ///< "fung_orthotropic"
  std::string summary;    ///< one line
  std::string source;     ///< paper and equation
  bool has_axes = false;  ///< uses the material axes; isotropic otherwise
  std::vector<ParamSpec> parameters;
  Parameters example;  ///< admissible values that tests use
  /// What is wrong with values that are each in range, taken together; empty where nothing can be.
  std::function<std::vector<Problem>(const Parameters&)> check;
  /// Builds the law for one orientation (columns of `axes` are a1, a2, a3). Parameters complete and in range.
  std::function<std::unique_ptr<const Law>(const Parameters&, const Mat3& axes)> make;
};

/// A volumetric law of the catalog.
struct VolumetricSpec {
  std::string name, summary, source;
  std::vector<ParamSpec> parameters;
  Parameters example;
  std::function<std::unique_ptr<const VolumetricLaw>(const Parameters&)> make;
};

/// A fibre law of the catalog. `passive` chooses what the passive stress is measured in: "none", "kPa" or "sigma_max";
/// the first of `passive_choices` is the one to take where nothing is said.
struct FibreSpec {
  std::string name, summary, source;
  std::vector<ParamSpec> parameters;
  std::vector<std::string> passive_choices;
  Parameters example;
  std::function<std::unique_ptr<const FibreLaw>(const Parameters&, const std::string& passive)>
      make;
};

/// A named set of parameter values with its source and what is doubtful about it.
struct Preset {
  std::string name;    ///< "flynn2015_normal"
  std::string law;     ///< name of a LawSpec, VolumetricSpec or FibreSpec
  Parameters values;   ///< of the law; may hold "kappa" for the volumetric law that goes with it
  std::string source;  ///< "Flynn et al. 2015, Table 1"
  std::string note;    ///< doubts and readings; may be empty
};

[[nodiscard]] std::span<const LawSpec> laws();
[[nodiscard]] std::span<const VolumetricSpec> volumetric_laws();
[[nodiscard]] std::span<const FibreSpec> fibre_laws();
[[nodiscard]] std::span<const Preset> presets();

/// Looked up by name; nullptr where there is none.
[[nodiscard]] const LawSpec* find_law(const std::string& name);
[[nodiscard]] const VolumetricSpec* find_volumetric_law(const std::string& name);
[[nodiscard]] const FibreSpec* find_fibre_law(const std::string& name);
[[nodiscard]] const Preset* find_preset(const std::string& name);

/// Every problem with these values for these parameters: missing, unknown, out of range ("/" + name as where).
[[nodiscard]] std::vector<Problem> check_parameters(std::span<const ParamSpec> specs,
                                                    const Parameters& values);

/// The same for a law, and what is wrong with the values taken together.
[[nodiscard]] std::vector<Problem> check_parameters(const LawSpec& law, const Parameters& values);

/// The values with the default of every parameter that is not given.
[[nodiscard]] Parameters with_defaults(std::span<const ParamSpec> specs, Parameters values);

}  // namespace facies::material
