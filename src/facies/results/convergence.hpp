// SPDX-License-Identifier: Apache-2.0
// How the solution of a run went: records of increments and iterations, as a table to read and as lines to process.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "facies/mechanics/term.hpp"

namespace facies::results {

/// One Newton iteration. Number 0 is the state before the first correction.
struct IterationRecord {
  int number = 0;
  double residual = 0.0;     ///< |r| over the free unknowns [mN]
  double relative = 0.0;     ///< by the load that it is measured against
  double correction = 0.0;   ///< largest nodal correction that led here [mm]
  double step_length = 0.0;  ///< Newton steps gone, 0..16
  double shift = 0.0;        ///< of the tangent's diagonal, relative; 0: none was needed
  int factorisations = 0;
  bool exact =
      true;  ///< the tangent itself was used; else, as it was indefinite, its positive part
};

/// One increment of a step, from load `from` to load `to`, with its iterations and how it ended.
struct IncrementRecord {
  std::string step;     ///< "tension"
  int step_number = 0;  ///< from 1
  int number = 0;       ///< from 1 within the step, failed ones counted
  double from = 0.0, to = 1.0;
  std::vector<IterationRecord> iterations;
  bool converged = false;
  std::string reason;
  Index worst_node = -1;                 ///< carries the largest remaining residual; -1: not known
  mechanics::Inadmissible inadmissible;  ///< the last element that stood in the way, if any

  [[nodiscard]] int factorisations() const;
  /// Corrections made: the iterations without number 0.
  [[nodiscard]] int corrections() const;
};

/// The totals of a step.
struct StepTotals {
  std::string step;
  int step_number = 0;
  double load = 0.0;  ///< part of the step that was reached, 0..1
  int increments = 0, failed_increments = 0, iterations = 0, factorisations = 0;
};

/// In the order in which the steps were made.
[[nodiscard]] std::vector<StepTotals> step_totals(std::span<const IncrementRecord> increments);

/// convergence.txt: every iteration in a row, increments and steps with their outcome. Numbers of nodes and elements are
/// those of the mesh, from 0.
[[nodiscard]] std::string convergence_text(std::span<const IncrementRecord> increments);

/// log.jsonl: a JSON object on each line, on disk as soon as it is written. No times in it, so that two runs give the
/// same bytes.
class RunLog {
 public:
  /// Starts the file anew. Throws UsageError where that is impossible.
  explicit RunLog(std::filesystem::path path);
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;
  RunLog(RunLog&&) = delete;
  RunLog& operator=(RunLog&&) = delete;
  ~RunLog();

  /// {"event":"iteration", ...}. `increment` says where it belongs; its own iterations are not looked at.
  void iteration(const IncrementRecord& increment, const IterationRecord& iteration);
  /// {"event":"increment", ...} once it has ended.
  void increment(const IncrementRecord& increment);

 private:
  void write_line(std::string line);

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace facies::results
