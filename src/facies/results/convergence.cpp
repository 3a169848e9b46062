// SPDX-License-Identifier: Apache-2.0
#include "facies/results/convergence.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace facies::results {

namespace {

std::string outcome(const IncrementRecord& increment) {
  std::string text = increment.converged ? "converged" : "NOT CONVERGED";
  if (!increment.reason.empty()) text += ": " + increment.reason;
  if (!increment.converged && increment.worst_node >= 0) {
    text += fmt::format("; largest residual at node {}", increment.worst_node);
  }
  if (!increment.converged && increment.inadmissible.element >= 0) {
    text += "; " + mechanics::describe(increment.inadmissible);
  }
  return text;
}

}  // namespace

int IncrementRecord::factorisations() const {
  int sum = 0;
  for (const IterationRecord& iteration : iterations)
    sum += iteration.factorisations;
  return sum;
}

int IncrementRecord::corrections() const {
  return static_cast<int>(
      std::count_if(iterations.begin(), iterations.end(),
                    [](const IterationRecord& iteration) { return iteration.number > 0; }));
}

std::vector<StepTotals> step_totals(std::span<const IncrementRecord> increments) {
  std::vector<StepTotals> totals;
  for (const IncrementRecord& increment : increments) {
    if (totals.empty() || totals.back().step_number != increment.step_number) {
      totals.push_back({increment.step, increment.step_number});
    }
    StepTotals& step = totals.back();
    ++(increment.converged ? step.increments : step.failed_increments);
    if (increment.converged) step.load = increment.to;
    step.iterations += increment.corrections();
    step.factorisations += increment.factorisations();
  }
  return totals;
}

std::string convergence_text(std::span<const IncrementRecord> increments) {
  std::string text =
      "residual: over the free unknowns [mN]; relative: by the load; correction: largest of a node "
      "[mm];\n"
      "length: part of the Newton step that was taken; shift: of the diagonal, relative;\n"
      "fact.: factorisations, 0 where an earlier one served again;\n"
      "+: the tangent was indefinite, its positive part was used\n";
  int step = 0;
  for (const IncrementRecord& increment : increments) {
    if (increment.step_number != step)
      text += fmt::format("\nstep {} {}\n", increment.step_number, increment.step);
    step = increment.step_number;
    text += fmt::format("\n  increment {}, load {:.6g} to {:.6g}\n", increment.number,
                        increment.from, increment.to);
    text += fmt::format("  {:>9} {:>12} {:>12} {:>12} {:>8} {:>10} {:>6}\n", "iteration",
                        "residual", "relative", "correction", "length", "shift", "fact.");
    for (const IterationRecord& i : increment.iterations) {
      text += fmt::format("  {:>9} {:>12.4e} {:>12.4e} {:>12.4e} {:>8.4f} {:>10.2e} {:>6}{}\n",
                          i.number, i.residual, i.relative, i.correction, i.step_length, i.shift,
                          i.factorisations, i.exact ? "" : " +");
    }
    text += "  " + outcome(increment) + '\n';
  }
  text += fmt::format("\n{:<4} {:<12} {:>7} {:>10} {:>7} {:>10} {:>14}\n", "step", "", "load",
                      "increments", "failed", "iterations", "factorisations");
  for (const StepTotals& t : step_totals(increments)) {
    text += fmt::format("{:<4} {:<12} {:>7.4g} {:>10} {:>7} {:>10} {:>14}\n", t.step_number, t.step,
                        t.load, t.increments, t.failed_increments, t.iterations, t.factorisations);
  }
  return text;
}

}  // namespace facies::results
