// SPDX-License-Identifier: Apache-2.0
#include "facies/results/tables.hpp"

#include <fmt/format.h>

#include "facies/results/measures.hpp"

namespace facies::results {

const mechanics::State* History::rest_for(std::size_t i) const {
  return rest && i >= *rest ? &snapshots[*rest].state : nullptr;
}

std::string exact_number(double value) {
  return fmt::format("{}", value == 0.0 ? 0.0 : value);
}

namespace {

/// Position, displacement and its length, each with a comma before it, and the end of the line.
std::string place_cells(const LandmarkMeasure& measure) {
  std::string text;
  for (const double value : measure.x)
    text += ',' + exact_number(value);
  for (const double value : measure.u)
    text += ',' + exact_number(value);
  return text + ',' + exact_number(measure.displacement) + '\n';
}

}  // namespace

std::string motion_rows(const Subject& subject, const Snapshot& snapshot,
                        const mechanics::State* rest) {
  std::string text;
  for (const LandmarkMeasure& measure : measure_landmarks(subject, snapshot.state, rest)) {
    text += snapshot.step + ',' + exact_number(snapshot.time.value_or(0.0)) + ',' +
            measure.landmark + place_cells(measure);
  }
  return text;
}

std::string landmarks_csv(const Subject& subject, const History& history) {
  std::string text = "step,landmark,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,displacement_mm\n";
  for (std::size_t i = 0; i < history.snapshots.size(); ++i) {
    const Snapshot& snapshot = history.snapshots[i];
    if (snapshot.load < 1.0) continue;
    for (const LandmarkMeasure& measure :
         measure_landmarks(subject, snapshot.state, history.rest_for(i))) {
      text += snapshot.step + ',' + measure.landmark + place_cells(measure);
    }
  }
  return text;
}

std::string distances_csv(const Subject& subject, const History& history) {
  std::string text = "step,pair,rest_mm,length_mm,change_percent\n";
  for (std::size_t i = 0; i < history.snapshots.size(); ++i) {
    const Snapshot& snapshot = history.snapshots[i];
    if (snapshot.load < 1.0) continue;
    for (const PairMeasure& measure : measure_pairs(subject, snapshot.state, history.rest_for(i))) {
      text += fmt::format("{},{}-{},{},{},{}\n", snapshot.step, measure.a, measure.b,
                          exact_number(measure.rest), exact_number(measure.length),
                          exact_number(measure.change_percent));
    }
  }
  return text;
}

}  // namespace facies::results
