// SPDX-License-Identifier: Apache-2.0
// Errors as a person reads them, and the exit status that goes with each.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "facies/base/error.hpp"

namespace facies::cli {

namespace exit_status {
inline constexpr int done = 0;
inline constexpr int defect = 1;
inline constexpr int usage = 2;
inline constexpr int scenario = 3;
inline constexpr int data = 4;
inline constexpr int not_converged = 5;
inline constexpr int interrupted = 130;
}  // namespace exit_status

/// One block per problem, at most 50 of them.
void print_problems(std::ostream& out, const std::vector<Problem>& problems);

/// Reports the exception that is being handled and answers its exit status.
[[nodiscard]] int report_current_exception(std::ostream& out);

}  // namespace facies::cli
