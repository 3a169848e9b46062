// SPDX-License-Identifier: Apache-2.0
#include "facies/base/error.hpp"

namespace facies {

std::string to_string(const Problem& problem) {
  std::string text = problem.where.empty() ? problem.found : problem.where + ": " + problem.found;
  if (!problem.expected.empty()) text += "; expected " + problem.expected;
  if (!problem.hint.empty()) text += "\n    " + problem.hint;
  return text;
}

namespace {

std::string join(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_string(problem);
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

void require(bool condition, const char* message) {
  if (!condition) throw BugError(message);
}

}  // namespace facies
