// SPDX-License-Identifier: Apache-2.0
#include "apps/facies/errors.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <ostream>

#include "apps/facies/terminal.hpp"
#include <fmt/format.h>

namespace facies::cli {

namespace {

constexpr std::size_t most_printed = 50;

std::string error_word() {
  return error_terminal().colour ? "\x1b[31merror:\x1b[0m " : "error: ";
}

}  // namespace

void print_problems(std::ostream& out, const std::vector<Problem>& problems) {
  for (std::size_t i = 0; i < std::min(problems.size(), most_printed); ++i) {
    out << error_word() << to_string(problems[i]) << '\n';
  }
  if (problems.size() > most_printed) {
    out << fmt::format("and {} more\n", problems.size() - most_printed);
  }
}

int report_current_exception(std::ostream& out) {
  try {
    throw;
  } catch (const UsageError& error) {
    print_problems(out, error.problems());
    return exit_status::usage;
  } catch (const ScenarioError& error) {
    print_problems(out, error.problems());
    return exit_status::scenario;
  } catch (const InputError& error) {  // DataError, and whatever else a file may be guilty of
    print_problems(out, error.problems());
    return exit_status::data;
  } catch (const NumericsError& error) {
    out << error_word() << error.what() << '\n';
    return exit_status::not_converged;
  } catch (const Interrupted&) {
    out << "interrupted\n";
    return exit_status::interrupted;
  } catch (const std::filesystem::filesystem_error& error) {
    out << error_word() << error.what() << '\n';
    return exit_status::usage;
  } catch (const std::bad_alloc&) {
    out << error_word() << "out of memory\n";
    return exit_status::defect;
  } catch (const std::exception& error) {
    out << error_word() << error.what() << "\n    this is a defect of facies; please report it\n";
    return exit_status::defect;
  }
}

}  // namespace facies::cli
