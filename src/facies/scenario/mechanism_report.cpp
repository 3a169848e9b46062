// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/mechanism_report.hpp"

#include <numbers>

#include <Eigen/Geometry>

namespace facies::scenario {

namespace {

/// Between the points "lower_incisor" and "upper_incisor"; 0 where the jaw has no such points.
double incisor_distance(const FaceModel& model, const mechanics::State& state) {
  const anatomy::Jaw& jaw = *model.face.jaw;
  const anatomy::JawPoint* lower = anatomy::find_named(jaw.points, "lower_incisor");
  const anatomy::JawPoint* upper = anatomy::find_named(jaw.points, "upper_incisor");
  if (lower == nullptr || upper == nullptr) return 0.0;
  const auto place = [&](const anatomy::JawPoint& point) {
    return mechanics::place_of(model.model, state, anchor_of(jaw, *model.jaw, point.at));
  };
  return (place(*lower) - place(*upper)).norm();
}

}  // namespace

std::optional<results::JawMeasure> measure_jaw(const FaceModel& model,
                                               const mechanics::State& state) {
  if (!model.jaw) return std::nullopt;
  results::JawMeasure measure;
  measure.incisor_distance = incisor_distance(model, state);
  const mechanics::Joint& joint = *model.jaw_terms.joint;
  for (std::size_t g = 0; g < joint.guides().size(); ++g)
    measure.reactions.push_back({joint.guides()[g].name, joint.guide_reaction(state, g)});
  for (std::size_t k = 0; k < joint.stops().size(); ++k)
    measure.reactions.push_back({joint.stops()[k].name, joint.stop_reaction(state, k)});
  return measure;
}

std::vector<results::ContactMeasure> measure_contacts(const FaceModel& model,
                                                      const mechanics::State& state) {
  std::vector<results::ContactMeasure> measures;
  for (const mechanics::Contact* contact : model.contacts) {
    const mechanics::ContactReport report = contact->report(state);
    measures.push_back({std::string(contact->name()), report.n_points, report.smallest_distance,
                        report.largest_pressure, report.force});
  }
  return measures;
}

std::optional<results::SettlingMeasure> measure_settling(const FaceModel& model) {
  if (!model.jaw) return std::nullopt;
  const SettledJaw& settled = *model.jaw;
  const double turn = Eigen::AngleAxisd(settled.from_files.R).angle();
  return results::SettlingMeasure{
      settled.from_files.u.norm(), turn * 180.0 / std::numbers::pi,
      settled.guide_before,        settled.guide_after,
      settled.deepest_stop,        incisor_distance(model, model.model.initial_state())};
}

}  // namespace facies::scenario
