// SPDX-License-Identifier: Apache-2.0
// facies doctor: is everything in place that a run needs?
#include <cstdlib>
#include <iostream>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include "apps/facies/version.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/base/parallel.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"

namespace facies::cli {

namespace {

namespace fs = std::filesystem;

/// Where the tests look for the paper's face: the environment, then beside the source tree.
std::string reference_face(const fs::path& home) {
  std::error_code ignored;
  const char* named = std::getenv("FACIES_REFERENCE_FACE");
  const fs::path folder = named != nullptr
                              ? fs::path(named)
                              : home.parent_path() / "shared" / "reference-face" / "upstream";
  if (fs::is_directory(folder / "face", ignored))
    return fmt::format("found, --face artisynth:{}", folder.string());
  if (named != nullptr)
    return fmt::format("FACIES_REFERENCE_FACE={}: no folder 'face' in it", named);
  return "not found; let FACIES_REFERENCE_FACE name src/artisynth/models of a clone of "
         "artisynth_models";
}

/// The scenarios that ship and cannot be read.
std::vector<Problem> broken_scenarios(const std::vector<fs::path>& files) {
  Problems problems;
  for (const fs::path& file : files)
    problems.add(scenario::read_file_reporting(file).problems);
  return problems.list();
}

void print_row(const std::string& name, const std::string& value) {
  std::cout << fmt::format("{:<16} {}\n", name, value);
}

int carry_out() {
  print_row("facies", version());
  for (const auto& [component, its_version] : built_with())
    print_row(component, its_version);
  print_row("threads", std::to_string(available_threads()));
  const fs::path home = scenario::home_folder();
  print_row("data folder", home.string());
  const std::vector<fs::path> shipped = scenario::shipped_scenarios(home);
  print_row("scenarios", std::to_string(shipped.size()));
  print_row("reference face", reference_face(home));
  const std::vector<Problem> problems = broken_scenarios(shipped);
  if (!problems.empty()) throw DataError(problems);
  return exit_status::done;
}

}  // namespace

void add_doctor(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "doctor", "Print versions and say whether everything that a run needs is there.");
  sub->callback([&action] { action = carry_out; });
}

}  // namespace facies::cli
