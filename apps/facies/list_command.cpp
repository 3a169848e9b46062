// SPDX-License-Identifier: Apache-2.0
// facies list: what can be named in a scenario or on the command line.
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/sources.hpp"
#include "facies/material/catalog.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"
#include "facies/scenario/study.hpp"

namespace facies::cli {

namespace {

void list_scenarios() {
  for (const auto& file : scenario::shipped_scenarios(scenario::home_folder())) {
    const scenario::Reading reading = scenario::read_file_reporting(file);
    std::cout << fmt::format("{:<20} {}\n", file.stem().string(), reading.scenario.title);
  }
}

void list_studies() {
  const std::filesystem::path home = scenario::home_folder();
  for (const auto& file : scenario::shipped_studies(home)) {
    const scenario::StudyReading reading = scenario::read_study_reporting(file, home);
    std::cout << fmt::format("{:<20} {}\n", file.stem().string(), reading.study.title);
  }
}

template <class Spec>
void list_law(const Spec& law, const char* kind) {
  std::cout << fmt::format("{} ({}): {}\n  {}\n", law.name, kind, law.summary, law.source);
  for (const material::ParamSpec& parameter : law.parameters) {
    const std::string unit = parameter.unit.empty() ? "" : fmt::format(" [{}]", parameter.unit);
    const std::string standard =
        parameter.default_value ? fmt::format(", without it {:g}", *parameter.default_value) : "";
    std::cout << fmt::format("  {:<20} {}{}\n", parameter.name + unit, parameter.meaning, standard);
  }
}

void list_laws() {
  for (const auto& law : material::laws())
    list_law(law, "skin, hypodermis");
  for (const auto& law : material::volumetric_laws())
    list_law(law, "volume");
  for (const auto& law : material::fibre_laws())
    list_law(law, "muscle");
}

void list_presets() {
  for (const material::Preset& preset : material::presets()) {
    std::cout << fmt::format("{} ({}): {}\n ", preset.name, preset.law, preset.source);
    for (const auto& [name, value] : preset.values)
      std::cout << fmt::format(" {} {:g}", name, value);
    std::cout << '\n';
    if (!preset.note.empty()) std::cout << "  " << preset.note << '\n';
  }
}

void list_faces() {
  for (const anatomy::SourceSpec& source : anatomy::sources()) {
    std::cout << fmt::format("{}\n  {}\n", source.usage, source.summary);
  }
}

/// What one may ask for of the built-in face.
void list_measures() {
  const anatomy::Drawings drawings = anatomy::read_drawings(scenario::data_folder() / "builtin");
  std::cout << fmt::format("{:<28} {:>9} {:>11} {:>16}   meaning\n", "--face builtin:KEY=N mm",
                           "male [mm]", "female [mm]", "range [mm]");
  const auto row = [](const std::string& key, const std::string& male, const std::string& female,
                      double smallest, double largest, const std::string& meaning) {
    std::cout << fmt::format("{:<28} {:>9} {:>11} {:>16}   {}\n", key, male, female,
                             fmt::format("{:g} to {:g}", smallest, largest), meaning);
  };
  for (const anatomy::FaceMeasure& measure : drawings.measures.measures) {
    const bool follows = !measure.rest_of.empty();
    row(measure.key, follows ? "follows" : fmt::format("{:g}", measure.male),
        follows ? "follows" : fmt::format("{:g}", measure.female), measure.smallest,
        measure.largest, measure.meaning);
  }
  for (const anatomy::DepthSite& site : drawings.depths)
    row(site.key, "as drawn", "as drawn", site.smallest, site.largest, site.meaning);
}

}  // namespace

void add_list(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "list",
      "List scenarios and studies that ship, laws, presets, faces or the measures of the "
      "built-in face.\n\n"
      "Examples:\n"
      "  facies list scenarios\n"
      "  facies list presets\n");
  auto what = std::make_shared<std::string>();
  sub->add_option("what", *what, "scenarios, studies, laws, presets, faces or measures")
      ->required()
      ->type_name("WHAT")
      ->check(CLI::IsMember({"scenarios", "studies", "laws", "presets", "faces", "measures"}));
  sub->callback([what, &action] {
    action = [what] {
      if (*what == "scenarios") list_scenarios();
      if (*what == "studies") list_studies();
      if (*what == "laws") list_laws();
      if (*what == "presets") list_presets();
      if (*what == "faces") list_faces();
      if (*what == "measures") list_measures();
      return exit_status::done;
    };
  });
}

}  // namespace facies::cli
