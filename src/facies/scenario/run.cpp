// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/run.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/anatomy/sources.hpp"
#include "facies/base/parallel.hpp"
#include "facies/scenario/recorder.hpp"
#include "facies/scenario/stepper.hpp"

namespace facies::scenario {

namespace {

int choose_threads(const Scenario& scenario, const RunOptions& options) {
  if (options.threads > 0) return options.threads;
  return scenario.solver.threads > 0 ? scenario.solver.threads : available_threads();
}

/// The state that expressions are measured from: after a release, or whatever comes right before the first expression.
bool is_rest(const Scenario& scenario, std::size_t step) {
  const auto expresses = [](const Step& kind) {
    return std::holds_alternative<ExpressStep>(kind) || std::holds_alternative<OpenJawStep>(kind) ||
           std::holds_alternative<MoveStep>(kind);
  };
  if (expresses(scenario.steps[step])) return false;
  const bool last = step + 1 == scenario.steps.size();
  return last || expresses(scenario.steps[step + 1]);
}

/// Of the elements around a node, the one that changed its volume the most.
Index worst_element(const FaceModel& model, const results::Snapshot& snapshot,
                    const solve::NewtonReport& report) {
  if (report.inadmissible.element >= 0) return report.inadmissible.element;
  Index worst = -1;
  double largest = -1.0;
  for (Index e = 0; e < to_index(model.face.mesh.n_elements()); ++e) {
    const std::span<const Index> nodes = model.face.mesh.element(e).connectivity();
    if (std::ranges::find(nodes, report.worst_node) == nodes.end()) continue;
    const double change = std::max(snapshot.J[at(e)], 1.0 / snapshot.J[at(e)]);
    if (change > largest) {
      largest = change;
      worst = e;
    }
  }
  return worst;
}

std::string describe_place(const results::Place& place) {
  if (place.element < 0) return "";
  std::string text = fmt::format("element {} ({}", place.element, place.layer);
  for (const std::string& muscle : place.muscles)
    text += ", " + muscle;
  return text + ")";
}

/// What did not converge, where, and what to try.
std::string describe_failure(const solve::StepReport& report, const results::Place& place) {
  return fmt::format(
      "{} did not converge: stopped at {:.3g} of its load (increment {}, from {:.4g} to {:.4g}): "
      "{}{}{}\n"
      "    what was reached is written; try a smaller load (tsf, activations, sigma_max), or more "
      "and smaller increments "
      "(solver.smallest_increment, solver.max_iterations)",
      report.last_increment.step, report.reached, report.last_increment.number,
      report.last_increment.from, report.last_increment.to, report.last.reason,
      place.element >= 0 ? "; worst: " : "", describe_place(place));
}

results::Snapshot snapshot_of(const FaceModel& model, const Stepper& stepper,
                              const Scenario& scenario, std::size_t step, double load) {
  results::Snapshot snapshot = make_snapshot(model, stepper.state(), stepper.controls());
  snapshot.step = step_name(scenario.steps[step]);
  snapshot.step_number = static_cast<int>(step) + 1;
  snapshot.load = load;
  if (std::holds_alternative<MoveStep>(scenario.steps[step])) snapshot.time = stepper.time();
  return snapshot;
}

/// Takes the steps one after the other; the failure of one in words, or nothing.
std::string take_steps(const FaceModel& model, const Scenario& scenario, Recorder& recorder) {
  Stepper stepper(model, scenario);
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    const auto frame = [&](double part) {
      recorder.frame(snapshot_of(model, stepper, scenario, step, part));
    };
    const solve::StepReport report = stepper.take(static_cast<int>(step) + 1, recorder, frame);
    results::Snapshot snapshot = snapshot_of(model, stepper, scenario, step, report.reached);
    const bool failed = !report.converged && !report.interrupted;
    const Index element = failed ? worst_element(model, snapshot, report.last) : -1;
    recorder.step_ends(std::move(snapshot), report.converged && is_rest(scenario, step));
    recorder.time(step_name(scenario.steps[step]));
    if (report.interrupted) {
      recorder.finish(results::Status::interrupted, "stopped on request", -1);
      throw Interrupted();
    }
    if (failed) {
      std::string failure =
          describe_failure(report, results::place_of(recorder.subject(), element));
      recorder.finish(results::Status::not_converged, failure, element);
      return failure;
    }
  }
  return {};
}

}  // namespace

RunSummary run(const Scenario& scenario, const RunOptions& options, solve::Observer& observer) {
  const int threads = choose_threads(scenario, options);
  const std::unique_ptr<FaceModel> model =
      build_model(anatomy::load_face(scenario.face, options.data), scenario, threads);
  Recorder recorder(*model, scenario, options, observer);
  recorder.time("face and model");
  RunSummary summary;
  summary.out = options.out;
  summary.failure = take_steps(*model, scenario, recorder);
  summary.converged = summary.failure.empty();
  recorder.draw(threads);
  recorder.time("pictures");
  if (summary.converged) recorder.finish(results::Status::done, "", -1);
  summary.table = recorder.closing_text();
  summary.seconds = recorder.seconds();
  return summary;
}

}  // namespace facies::scenario
