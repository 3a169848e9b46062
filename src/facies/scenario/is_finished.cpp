// SPDX-License-Identifier: Apache-2.0
// Runs that need not be repeated.
#include <algorithm>

#include "facies/base/checksum.hpp"
#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/run_record.hpp"
#include "facies/scenario/run.hpp"
#include "facies/scenario/write_scenario.hpp"

namespace facies::scenario {

namespace {

bool holds(const std::filesystem::path& file, const std::string& content) {
  try {
    return read_file(file) == content;
  } catch (const DataError&) {
    return false;
  }
}

bool is_unchanged(const results::InputFile& input) {
  try {
    return "sha256:" + sha256(read_file(input.name)) == input.checksum;
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace

bool is_finished(const Scenario& scenario, const RunOptions& options) {
  if (!holds(options.out / "scenario.yaml", to_yaml(scenario))) return false;
  const std::optional<results::RunRecord> record = results::read_run_record(options.out);
  if (!record || record->version != options.version) return false;
  const bool ended = record->status == results::name(results::Status::done) ||
                     record->status == results::name(results::Status::not_converged);
  return ended && std::ranges::all_of(record->inputs, is_unchanged);
}

}  // namespace facies::scenario
