// SPDX-License-Identifier: Apache-2.0
// The command line as a whole: help, version, which command, exit status.
#include <algorithm>
#include <iostream>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include "apps/facies/version.hpp"
#include <CLI/CLI.hpp>

#include "facies/base/text.hpp"

namespace facies::cli {

namespace {

const char* const description =
    "facies: soft-tissue mechanics of the human face\n\n"
    "Examples:\n"
    "  facies run patch-stretch                         a sheet of skin, in seconds\n"
    "  facies run smile-open --face artisynth:DIR       the paper's open-mouth smile\n"
    "  facies run smile-open --face artisynth:DIR --set skin.preset=flynn2015_stiff --set "
    "tension.tsf=1.05\n"
    "  facies study open-choices --face artisynth:DIR --out DIR    variants beside each other\n"
    "  facies check my-smile.yaml                       everything that is wrong with it, at once\n"
    "  facies info --face artisynth:DIR                 what is in a face\n";

const char* const footer =
    "Exit status: 0 done, 1 a defect of facies, 2 usage, 3 bad scenario, 4 bad geometry or data,\n"
    "5 not converged, 130 interrupted.";

/// A command that does not exist, before the parser calls it "an argument that was not expected".
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.push_back(command->get_name());
  if (word.empty() || word.front() == '-') return;
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  throw UsageError({{"facies " + word, "no such command", "", did_you_mean(word, names)}});
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    CLI::App app(description, "facies");
    app.footer(footer);
    app.set_version_flag("--version", "facies " + version());
    app.require_subcommand(1);
    Action action;
    for (auto* add : {add_run, add_study, add_check, add_info, add_list, add_schema, add_doctor})
      add(app, action);
    if (argc > 1) refuse_unknown_command(app, argv[1]);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? exit_status::done : exit_status::usage;
    }
    const int status = action();
    std::cout.flush();
    if (!std::cout) throw UsageError({{"standard output", "cannot be written to", "", ""}});
    return status;
  } catch (...) {
    return report_current_exception(std::cerr);
  }
}

}  // namespace facies::cli
