// SPDX-License-Identifier: Apache-2.0
// facies run: one simulation.
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/console_observer.hpp"
#include "apps/facies/errors.hpp"
#include "apps/facies/scenario_options.hpp"
#include "apps/facies/signals.hpp"
#include "apps/facies/version.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/scenario/folders.hpp"
#include "facies/scenario/run.hpp"
#include "facies/solve/session.hpp"

namespace facies::cli {

namespace {

struct RunCommand {
  ScenarioOptions scenario;
  std::string out;
  bool force = false;
  bool no_pictures = false;
  std::optional<int> threads;
  bool verbose = false;
  bool quiet = false;
};

Verbosity verbosity_of(const RunCommand& command) {
  if (command.quiet) return Verbosity::quiet;
  return command.verbose ? Verbosity::verbose : Verbosity::normal;
}

constexpr const char* standard_folder = "out";

scenario::RunOptions options_of(const RunCommand& command, const scenario::Scenario& scenario) {
  scenario::RunOptions options;
  options.out = command.out;
  if (command.out.empty()) options.out = std::filesystem::path(standard_folder) / scenario.name;
  options.data = scenario::data_folder();
  options.version = version();
  options.force = command.force;
  options.pictures = scenario.output.pictures;
  options.threads = scenario.solver.threads;
  return options;
}

/// Runs with the folder for results made, where nobody named one, and taken away if nothing came into it.
scenario::RunSummary run_into_folder(const scenario::Scenario& scenario,
                                     const scenario::RunOptions& options, bool is_standard,
                                     ConsoleObserver& observer) {
  // A failure is told when the folder of the scenario cannot be made in it.
  std::error_code failure;
  if (is_standard) std::filesystem::create_directory(standard_folder, failure);
  try {
    scenario::RunSummary summary = scenario::run(scenario, options, observer);
    observer.clear();
    return summary;
  } catch (...) {
    observer.clear();
    if (is_standard) std::filesystem::remove(standard_folder, failure);
    throw;
  }
}

int carry_out(const RunCommand& command) {
  scenario::Reading reading = read_reporting(command.scenario);
  if (!reading.problems.empty()) throw ScenarioError(std::move(reading.problems));
  scenario::Scenario& scenario = reading.scenario;
  if (command.threads) scenario.solver.threads = *command.threads;
  if (command.no_pictures) scenario.output.pictures = false;

  const solve::Session session;
  listen_for_stop();
  ConsoleObserver observer(std::cerr, error_terminal(), verbosity_of(command));
  const scenario::RunOptions options = options_of(command, scenario);
  scenario::RunSummary summary;
  try {
    summary = run_into_folder(scenario, options, command.out.empty(), observer);
  } catch (const Interrupted&) {
    std::cerr << "interrupted; what was reached is in " << options.out.string() << '\n';
    return exit_status::interrupted;
  }
  if (!command.quiet) {
    std::cout << summary.table
              << fmt::format("{} in {:.1f} s: {}\n", summary.converged ? "done" : "stopped",
                             summary.seconds, summary.out.string());
  }
  if (summary.converged) return exit_status::done;
  print_problems(std::cerr, {{scenario.name, summary.failure, "", ""}});
  return exit_status::not_converged;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto command = std::make_shared<RunCommand>();
  CLI::App* sub = app.add_subcommand(
      "run",
      "Run one simulation.\n\n"
      "Examples:\n"
      "  facies run patch-stretch\n"
      "  facies run smile-open --face artisynth:DIR --out out/smile\n"
      "  facies run my-smile.yaml --set tension.tsf=1.05 --set express.ZYG=0.3 --force\n");
  add_scenario_options(*sub, command->scenario);
  sub->add_option("--out", command->out, "result folder; without it out/NAME of the scenario")
      ->type_name("DIR");
  sub->add_flag("--force", command->force, "replace the results that are there");
  sub->add_option("--threads", command->threads, "threads; 0: all (results do not depend on it)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--no-pictures", command->no_pictures, "draw no pictures");
  CLI::Option* verbose =
      sub->add_flag("-v,--verbose", command->verbose, "print the convergence table");
  sub->add_flag("-q,--quiet", command->quiet, "print errors only")->excludes(verbose);
  sub->callback([command, &action] { action = [command] { return carry_out(*command); }; });
}

}  // namespace facies::cli
