// SPDX-License-Identifier: Apache-2.0
#include "facies/results/summary.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "facies/base/error.hpp"

namespace facies::results {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Place& place) {
  return {{"element", place.element}, {"layer", place.layer}, {"muscles", place.muscles}};
}

Json to_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Json to_json(const StepTotals& totals) {
  return {{"step", totals.step},
          {"load", totals.load},
          {"increments", totals.increments},
          {"failed_increments", totals.failed_increments},
          {"iterations", totals.iterations},
          {"factorisations", totals.factorisations}};
}

Json to_json(const JawMeasure& jaw) {
  Json json = {{"incisor_distance_mm", jaw.incisor_distance}, {"reactions_mN", Json::object()}};
  for (const JointReaction& reaction : jaw.reactions)
    json["reactions_mN"][reaction.name] = to_json(reaction.force);
  return json;
}

/// Distances that are infinite, as nothing is near, become null.
Json to_json(const ContactMeasure& contact) {
  Json json = {{"points", contact.n_points},
               {"smallest_distance_mm", contact.smallest_distance},
               {"largest_pressure_kPa", contact.largest_pressure},
               {"force_mN", to_json(contact.force)}};
  if (!std::isfinite(contact.smallest_distance)) json["smallest_distance_mm"] = nullptr;
  return json;
}

Json to_json(const SettlingMeasure& settling) {
  return {{"way_mm", settling.way},
          {"turn_deg", settling.turn},
          {"guide_off_path_before_mm", settling.guide_before},
          {"guide_off_path_after_mm", settling.guide_after},
          {"smallest_stop_distance_mm", settling.smallest_stop_distance},
          {"incisor_distance_mm", settling.incisor_distance}};
}

Json to_json(const Headline& headline) {
  Json json = {{"step", headline.step}};
  json["landmarks"] = Json::object();
  for (const LandmarkMeasure& m : headline.landmarks) {
    json["landmarks"][m.landmark] = {
        {"position_mm", to_json(m.x)}, {"u_mm", to_json(m.u)}, {"displacement_mm", m.displacement}};
  }
  json["distances"] = Json::object();
  for (const PairMeasure& m : headline.pairs) {
    json["distances"][m.a + "-" + m.b] = {
        {"rest_mm", m.rest}, {"length_mm", m.length}, {"change_percent", m.change_percent}};
  }
  json["J"]["smallest"] = {{"value", headline.J.smallest}, {"at", to_json(headline.smallest_J)}};
  json["J"]["largest"] = {{"value", headline.J.largest}, {"at", to_json(headline.largest_J)}};
  const Volumes& v = headline.volumes;
  json["volume"] = {
      {"mesh_mm3", v.mesh},
      {"stress_free_mm3", v.stress_free},
      {"deformed_mm3", v.deformed},
      {"change_from_mesh_percent", 100.0 * (v.deformed / v.mesh - 1.0)},
      {"change_from_stress_free_percent", 100.0 * (v.deformed / v.stress_free - 1.0)}};
  json["skin_under_tension"] = {{"share", headline.tension.all},
                                {"share_away_from_borders", nullptr}};
  if (headline.tension.away_from_borders) {
    json["skin_under_tension"]["share_away_from_borders"] = *headline.tension.away_from_borders;
  }
  if (headline.jaw) json["jaw"] = to_json(*headline.jaw);
  for (const ContactMeasure& contact : headline.contacts)
    json["contact"][contact.name] = to_json(contact);
  return json;
}

Json parse_settings(const std::string& text) {
  Json settings = Json::parse(text, nullptr, false);
  require(!settings.is_discarded(), "Summary: settings_json is not JSON");
  return settings;
}

}  // namespace

std::string_view name(Status status) {
  switch (status) {
    case Status::running:
      return "running";
    case Status::done:
      return "done";
    case Status::not_converged:
      return "not_converged";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      return "failed";
  }
  return "";
}

Place place_of(const Subject& subject, Index element) {
  Place place{element, "", {}};
  if (element < 0) return place;
  if (at(element) < subject.layer_of_element.size()) {
    const auto layer = static_cast<std::size_t>(subject.layer_of_element[at(element)]);
    if (layer < subject.layers.size()) place.layer = subject.layers[layer];
  }
  for (const NamedMuscle& muscle : subject.muscles) {
    if (std::find(muscle.elements.begin(), muscle.elements.end(), element) !=
        muscle.elements.end()) {
      place.muscles.push_back(muscle.name);
    }
  }
  return place;
}

Headline make_headline(const Subject& subject, const Snapshot& snapshot,
                       const mechanics::State* rest) {
  Headline headline;
  headline.step = snapshot.step;
  headline.landmarks = measure_landmarks(subject, snapshot.state, rest);
  headline.pairs = measure_pairs(subject, snapshot.state, rest);
  headline.J = measure_dilatation(snapshot);
  headline.smallest_J = place_of(subject, headline.J.smallest_element);
  headline.largest_J = place_of(subject, headline.J.largest_element);
  headline.volumes = measure_volumes(subject, snapshot);
  headline.tension = measure_tension_share(subject, snapshot);
  headline.jaw = snapshot.jaw;
  headline.contacts = snapshot.contacts;
  return headline;
}

std::string to_json(const Summary& summary) {
  Json json = {{"facies", summary.version}, {"status", name(summary.status)}};
  if (!summary.reason.empty()) json["reason"] = summary.reason;
  if (summary.where.element >= 0) json["where"] = to_json(summary.where);
  json["steps"] = Json::array();
  for (const StepTotals& totals : step_totals(summary.convergence))
    json["steps"].push_back(to_json(totals));
  if (summary.settling) json["jaw_settled"] = to_json(*summary.settling);
  json["measures"] = Json::array();
  for (const Headline& headline : summary.headlines)
    json["measures"].push_back(to_json(headline));
  json["settings"] = parse_settings(summary.settings_json);
  json["inputs"] = Json::object();
  for (const InputFile& input : summary.inputs)
    json["inputs"][input.name] = input.checksum;
  json["timings"] = Json::object();
  for (const auto& [what, seconds] : summary.timings)
    json["timings"][what + "_s"] = seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace facies::results
