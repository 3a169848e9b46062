// SPDX-License-Identifier: Apache-2.0
// The commands of the program. Each add_... describes one to the parser of the command line and, when it is the one
// that was given, leaves in `action` what it does; an action returns the exit status.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace facies::cli {

using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_list(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);

/// Parses the command line, carries it out, reports what went wrong on standard error. The exit status: 0 done, 1 a
/// defect of ours, 2 usage, 3 bad scenario, 4 bad geometry or data, 5 not converged, 130 interrupted.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace facies::cli
