// SPDX-License-Identifier: Apache-2.0
// facies check: everything that can be known to be wrong before solving.
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include "apps/facies/scenario_options.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/anatomy/sources.hpp"
#include "facies/scenario/build_model.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/write_scenario.hpp"
#include "facies/solve/session.hpp"

namespace facies::cli {

namespace {

struct CheckCommand {
  ScenarioOptions scenario;
  bool resolved = false;
};

/// Adds what the face shows to be wrong; `status` becomes that of the first kind of problem, `about` describes the face.
void check_face(const scenario::Scenario& scenario, Problems& problems, int& status,
                std::string& about) {
  const auto add = [&](const std::vector<Problem>& found, int kind) {
    problems.add(found);
    if (status == exit_status::done && !found.empty()) status = kind;
  };
  try {
    const anatomy::FaceAnatomy face = anatomy::load_face(scenario.face, scenario::data_folder());
    const solve::Session session;
    add(scenario::check_model(face, scenario), exit_status::data);
    const auto muscles = scenario::choose_muscles(face, scenario);
    about = fmt::format("{}: {} nodes, {} elements, {} muscles", face.source, face.mesh.n_nodes(),
                        face.mesh.n_elements(), muscles.size());
    add(scenario::check_against_face(scenario, scenario::names_on_face(face, muscles)),
        exit_status::scenario);
  } catch (const ScenarioError& error) {
    add(error.problems(), exit_status::scenario);
  } catch (const UsageError& error) {
    add(error.problems(), exit_status::usage);
  } catch (const DataError& error) {
    add(error.problems(), exit_status::data);
  }
}

int carry_out(const CheckCommand& command) {
  const scenario::Reading reading = read_reporting(command.scenario);
  int status = reading.problems.empty() ? exit_status::done : exit_status::scenario;
  Problems problems;
  problems.add(reading.problems);
  std::string about;
  check_face(reading.scenario, problems, status, about);
  print_problems(std::cerr, problems.list());
  if (!problems.empty()) {
    std::cerr << fmt::format("{} problem{}\n", problems.size(), problems.size() == 1 ? "" : "s");
    return status;
  }
  if (command.resolved) {
    std::cout << scenario::to_yaml(reading.scenario);
  } else {
    std::cout << fmt::format("{}: no problem found ({})\n", reading.scenario.name, about);
  }
  return status;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto command = std::make_shared<CheckCommand>();
  CLI::App* sub = app.add_subcommand(
      "check",
      "Report everything that is wrong with a scenario and its face, without solving.\n\n"
      "Examples:\n"
      "  facies check my-smile.yaml --face artisynth:DIR\n"
      "  facies check patch-stretch --resolved         with every default written out\n");
  add_scenario_options(*sub, command->scenario);
  sub->add_flag("--resolved", command->resolved,
                "print the scenario with every default written out");
  sub->callback([command, &action] { action = [command] { return carry_out(*command); }; });
}

}  // namespace facies::cli
