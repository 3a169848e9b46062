// SPDX-License-Identifier: Apache-2.0
// summary.json: what was run, how it ended, and its headline numbers, for programs and for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "facies/results/convergence.hpp"
#include "facies/results/measures.hpp"

namespace facies::results {

enum class Status { running, done, not_converged, interrupted, failed };

/// "running", "done", "not_converged", "interrupted", "failed".
[[nodiscard]] std::string_view name(Status status);

/// A file that the run was made from.
struct InputFile {
  std::string name;
  std::string checksum;  ///< with its kind: "sha256:..."
};

/// Where in the tissue something is, in words of the subject.
struct Place {
  Index element = -1;
  std::string layer;
  std::vector<std::string> muscles;
};

[[nodiscard]] Place place_of(const Subject& subject, Index element);

/// What a state comes to.
struct Headline {
  std::string step;
  std::vector<LandmarkMeasure> landmarks;
  std::vector<PairMeasure> pairs;
  DilatationExtremes J;
  Place smallest_J, largest_J;
  Volumes volumes;
  TensionShare tension;
  std::optional<JawMeasure> jaw;
  std::vector<ContactMeasure> contacts;
};

/// All measures of a snapshot; `rest` as in measure_landmarks.
[[nodiscard]] Headline make_headline(const Subject& subject, const Snapshot& snapshot,
                                     const mechanics::State* rest);

struct Summary {
  std::string version;  ///< of facies
  Status status = Status::running;
  std::string reason;         ///< why it ended other than done; empty otherwise
  Place where;                ///< element that stood in the way; element -1: none
  std::string settings_json;  ///< the resolved scenario as a JSON text
  std::vector<InputFile> inputs;
  std::optional<SettlingMeasure> settling;  ///< where the model has a jaw
  std::vector<IncrementRecord> convergence;
  std::vector<Headline> headlines;  ///< at the ends of steps
  std::vector<std::pair<std::string, double>>
      timings;  ///< name, seconds; all that may differ between equal runs
};

/// The file's text, keys always in the same order. Rewrite it whole (write_file of base/files.hpp) at the start, after
/// every step and at the end. Throws BugError where settings_json is not JSON.
[[nodiscard]] std::string to_json(const Summary& summary);

}  // namespace facies::results
