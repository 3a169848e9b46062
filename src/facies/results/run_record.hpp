// SPDX-License-Identifier: Apache-2.0
// A result folder read back: how its run ended and what it measured (summary.json).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/results/published.hpp"
#include "facies/results/summary.hpp"

namespace facies::results {

/// A measured number, in the words of PublishedValue.
struct MeasuredValue {
  std::string quantity;  ///< "displacement", "distance_change", "incisor_distance"
  std::string subject;   ///< "RMC", "RMC-LMC", "incisors"
  std::string unit;      ///< "mm", "%"
  double value = 0.0;
};

struct RunRecord {
  std::string version;  ///< of facies
  std::string status;   ///< a name(Status)
  std::string reason;   ///< why it ended other than done
  std::vector<InputFile> inputs;
  std::vector<MeasuredValue> measured;  ///< in the state where it ended
};

/// Nothing where the folder has no summary.json or it is not one of ours.
[[nodiscard]] std::optional<RunRecord> read_run_record(const std::filesystem::path& folder);

/// What was measured of the quantity that a publication gives; nothing where it was not.
[[nodiscard]] std::optional<double> measured_of(const PublishedValue& published,
                                                const std::vector<MeasuredValue>& measured);

}  // namespace facies::results
