// SPDX-License-Identifier: Apache-2.0
// Keeps the result folder of a run complete while the run goes on.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "facies/results/fields.hpp"
#include "facies/results/published.hpp"
#include "facies/results/summary.hpp"
#include "facies/scenario/build_model.hpp"
#include "facies/scenario/run.hpp"

namespace facies::scenario {

/// What results need to know of a face and its muscles.
[[nodiscard]] results::Subject make_subject(const FaceModel& model);

/// The state with the stress and dilatation that follow from it.
[[nodiscard]] results::Snapshot make_snapshot(const FaceModel& model, const mechanics::State& state,
                                              const mechanics::Controls& controls);

/// Hears the solution procedure, passes everything on, and writes after every event what a reader may want to see.
class Recorder final : public solve::Observer {
 public:
  /// Prepares the folder and writes the resolved scenario. Throws UsageError where that is impossible.
  Recorder(const FaceModel& model, const Scenario& scenario, const RunOptions& options,
           solve::Observer& listener);

  void increment_begins(const solve::Increment& increment) override;
  void iteration_done(const solve::Increment& increment,
                      const solve::Iteration& iteration) override;
  void increment_ends(const solve::Increment& increment, const solve::IncrementEnd& end) override;
  [[nodiscard]] bool stop_requested() const override { return listener_.stop_requested(); }

  /// A state on the way through a step, from its beginning (load 0) to its end (load 1).
  void frame(results::Snapshot snapshot);

  void time_step_done(const solve::Motion& motion) override;

  /// A step ended, here or before its load was whole. A step that expressions start from is the tensioned rest.
  void step_ends(results::Snapshot snapshot, bool is_rest);

  /// The pictures of what there is; none for a run that reached nothing.
  void draw(int threads);

  /// How the run ended, and where in the tissue.
  void finish(results::Status status, const std::string& reason, Index element);

  /// The seconds since the last call (or the beginning) belong to `name`.
  void time(const std::string& name);

  /// Text for the terminal: measures beside published values.
  [[nodiscard]] std::string closing_text() const;
  [[nodiscard]] double seconds() const;
  [[nodiscard]] const results::Subject& subject() const { return subject_; }

 private:
  [[nodiscard]] const mechanics::State* rest_state() const;
  void record_motion(const results::Snapshot& snapshot);
  void write_tables() const;
  void write_summary() const;

  const FaceModel& model_;
  const Scenario& scenario_;
  RunOptions options_;
  solve::Observer& listener_;
  results::Subject subject_;
  results::Summary summary_;
  results::FieldWriter fields_;
  std::optional<results::RunLog> log_;
  std::vector<results::Snapshot> snapshots_;
  std::vector<std::vector<results::Snapshot>> films_;  ///< frames of each step that has any
  std::optional<std::size_t> rest_;
  std::string motion_;  // rows of motion.csv
  std::string energy_;  // rows of energy.csv
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace facies::scenario
