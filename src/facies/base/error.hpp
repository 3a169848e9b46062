// SPDX-License-Identifier: Apache-2.0
// What can go wrong, and what a person is told about it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace facies {

/// One thing wrong with an input, told so that a person can mend it.
struct Problem {
  std::string where;     ///< "smile.yaml:12:7", "face.node:301" or "/steps/2/express"
  std::string found;     ///< what stands there
  std::string expected;  ///< what should stand there; may be empty
  std::string hint;      ///< what to do; may be empty
};

/// "where: found; expected ... \n  hint". One line, or two where there is a hint.
[[nodiscard]] std::string to_string(const Problem& problem);

/// Something that the user gave cannot be used. Carries every problem found, not only the first.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// The command line cannot be carried out: unknown option, unusable output folder, full disk. Exit status 2.
class UsageError : public InputError {
 public:
  using InputError::InputError;
};

/// The scenario is wrong. Exit status 3.
class ScenarioError : public InputError {
 public:
  using InputError::InputError;
};

/// A mesh, a table or another file of data is wrong. Exit status 4.
class DataError : public InputError {
 public:
  using InputError::InputError;
};

/// A calculation cannot go on: no equilibrium was found, or the linear solver gave up. Exit status 5.
class NumericsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user asked to stop (Ctrl-C). Exit status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// A caller broke a contract: a defect of facies, never the user's. Exit status 1.
class BugError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws BugError with `message` unless `condition` holds. Always on; not for inner loops.
void require(bool condition, const char* message);

/// Collects problems so that all of them are reported at once.
class Problems {
 public:
  void add(Problem problem) { list_.push_back(std::move(problem)); }
  void add(const std::vector<Problem>& more) {
    list_.insert(list_.end(), more.begin(), more.end());
  }
  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  [[nodiscard]] const std::vector<Problem>& list() const { return list_; }

  /// Throws `Error` (ScenarioError, DataError, UsageError) with everything collected, if anything was.
  template <class Error>
  void throw_if_any() const {
    if (!list_.empty()) throw Error(list_);
  }

 private:
  std::vector<Problem> list_;
};

/// Problems of one kind in one place, so that a spoiled file does not flood: the first ones as they are, the rest as a
/// count.
class ProblemsOfOneKind {
 public:
  /// `where` and `kind` ("unreadable lines") are for the count.
  ProblemsOfOneKind(std::string where, std::string kind, std::size_t max_listed = 10)
      : where_(std::move(where)), kind_(std::move(kind)), max_listed_(max_listed) {}

  void add(Problem problem);
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  void move_to(Problems& all);

 private:
  std::string where_;
  std::string kind_;
  std::size_t max_listed_;
  std::vector<Problem> list_;
  std::size_t count_ = 0;
};

}  // namespace facies
