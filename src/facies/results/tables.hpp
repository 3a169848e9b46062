// SPDX-License-Identifier: Apache-2.0
// landmarks.csv and distances.csv, motion.csv and energy.csv.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "facies/results/subject.hpp"

namespace facies::results {

/// The snapshots of a run in the order they were made.
struct History {
  std::span<const Snapshot> snapshots;
  std::optional<std::size_t>
      rest;  ///< position of the tensioned rest; nothing: the run has none (yet)

  /// The state that snapshot `i` is measured from: the tensioned rest from itself on, before it nullptr, which stands
  /// for the mesh as read. (When the tension is put in, the tensioned rest does not exist yet.)
  [[nodiscard]] const mechanics::State* rest_for(std::size_t i) const;
};

/// `step,landmark,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,displacement_mm`: a row for every landmark at the end of every
/// finished step. Numbers have the digits that it takes to read them back exactly.
[[nodiscard]] std::string landmarks_csv(const Subject& subject, const History& history);

/// `step,pair,rest_mm,length_mm,change_percent`: a row for every pair at the end of every finished step.
[[nodiscard]] std::string distances_csv(const Subject& subject, const History& history);

/// `step,time_s,landmark,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,displacement_mm`: rows for every landmark in a state of a move
/// step, without the titles; `rest` as in History::rest_for.
inline constexpr const char* motion_titles =
    "step,time_s,landmark,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,displacement_mm\n";
[[nodiscard]] std::string motion_rows(const Subject& subject, const Snapshot& snapshot,
                                      const mechanics::State* rest);

/// The shortest decimal number that reads back as the same double; "0" for both zeros.
[[nodiscard]] std::string exact_number(double value);

}  // namespace facies::results
