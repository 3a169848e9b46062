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

void ProblemsOfOneKind::add(Problem problem) {
  if (count_ < max_listed_) list_.push_back(std::move(problem));
  ++count_;
}

void ProblemsOfOneKind::move_to(Problems& all) {
  all.add(list_);
  if (count_ > max_listed_) {
    all.add({where_, std::to_string(count_) + " " + kind_ + " in all", "", ""});
  }
  list_.clear();
  count_ = 0;
}

}  // namespace facies
