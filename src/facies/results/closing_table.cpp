// SPDX-License-Identifier: Apache-2.0
#include "facies/results/closing_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "facies/base/text.hpp"

namespace facies::results {

namespace {

const PublishedValue* find(const std::vector<PublishedValue>& published, std::string_view quantity,
                           std::string_view subject) {
  const auto found =
      std::find_if(published.begin(), published.end(), [&](const PublishedValue& value) {
        return value.quantity == quantity && value.subject == subject;
      });
  return found == published.end() ? nullptr : &*found;
}

std::string paper_columns(const PublishedValue* paper, double model) {
  if (paper == nullptr) return fmt::format("{:>12} {:>12}", "-", "-");
  return fmt::format("{:>12} {:>+12.2f}", paper->text(), model - paper->value);
}

std::string place_text(const Place& place) {
  std::string text = fmt::format("element {}", place.element);
  if (!place.layer.empty()) text += ", " + place.layer;
  for (const std::string& muscle : place.muscles)
    text += ", " + muscle;
  return text;
}

/// The largest among the landmarks that a published value lists; nothing where the subject has none of them.
std::optional<double> largest_of(const std::vector<LandmarkMeasure>& landmarks,
                                 std::string_view names) {
  std::optional<double> largest;
  for (const std::string_view name : split_blanks(names)) {
    for (const LandmarkMeasure& m : landmarks) {
      if (m.landmark == name) largest = std::max(largest.value_or(0.0), m.displacement);
    }
  }
  return largest;
}

}  // namespace

std::string landmark_table(const std::vector<LandmarkMeasure>& landmarks,
                           const std::vector<PublishedValue>& published) {
  std::string text = fmt::format("{:<24} {:>12} {:>12} {:>12}\n", "displacement [mm]", "model",
                                 "paper", "difference");
  for (const LandmarkMeasure& m : landmarks) {
    text += fmt::format("  {:<22} {:>12.2f} {}\n", m.landmark, m.displacement,
                        paper_columns(find(published, "displacement", m.landmark), m.displacement));
  }
  for (const PublishedValue& paper : published) {
    if (paper.quantity != "largest_displacement") continue;
    const std::optional<double> largest = largest_of(landmarks, paper.subject);
    if (!largest) continue;
    text += fmt::format("  largest of {}\n  {:<22} {:>12.2f} {}\n", paper.subject, "", *largest,
                        paper_columns(&paper, *largest));
  }
  return text;
}

std::string distance_table(const std::vector<PairMeasure>& pairs,
                           const std::vector<PublishedValue>& published) {
  std::string text = fmt::format("{:<24} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "distance [mm]",
                                 "rest", "now", "change [%]", "paper [%]", "difference");
  for (const PairMeasure& m : pairs) {
    const std::string pair = m.a + "-" + m.b;
    text += fmt::format("  {:<22} {:>12.2f} {:>12.2f} {:>+12.2f} {}\n", pair, m.rest, m.length,
                        m.change_percent,
                        paper_columns(find(published, "distance_change", pair), m.change_percent));
  }
  return text;
}

std::string jaw_line(const JawMeasure& jaw, const std::vector<PublishedValue>& published) {
  return fmt::format(
      "{:<24} {:>12.2f} {}\n", "incisor distance [mm]", jaw.incisor_distance,
      paper_columns(find(published, "incisor_distance", "incisors"), jaw.incisor_distance));
}

std::string contact_table(const std::vector<ContactMeasure>& contacts) {
  std::string text = fmt::format("{:<24} {:>12} {:>12} {:>12} {:>12}\n", "contact", "points",
                                 "nearest [mm]", "at most [kPa]", "force [N]");
  for (const ContactMeasure& contact : contacts) {
    const std::string nearest = std::isfinite(contact.smallest_distance)
                                    ? fmt::format("{:.3f}", contact.smallest_distance)
                                    : "-";
    text +=
        fmt::format("  {:<22} {:>12} {:>12} {:>12.1f} {:>12.2f}\n", contact.name, contact.n_points,
                    nearest, contact.largest_pressure, contact.force.norm() / 1000.0);
  }
  return text;
}

std::string closing_text(const Headline& headline, const std::vector<PublishedValue>& published) {
  std::string text;
  if (!headline.landmarks.empty()) text += landmark_table(headline.landmarks, published) + '\n';
  if (!headline.pairs.empty()) text += distance_table(headline.pairs, published) + '\n';
  if (headline.jaw) text += jaw_line(*headline.jaw, published) + '\n';
  if (!headline.contacts.empty()) text += contact_table(headline.contacts) + '\n';
  text += fmt::format(
      "J against the stress-free state\n  smallest {:>8.4f}  at {}\n  largest  {:>8.4f}  at {}\n",
      headline.J.smallest, place_text(headline.smallest_J), headline.J.largest,
      place_text(headline.largest_J));
  const Volumes& v = headline.volumes;
  text += fmt::format(
      "volume {:.2f} cm3: {:+.2f} % from the mesh as read, {:+.2f} % from the stress-free state\n",
      v.deformed / 1000.0, 100.0 * (v.deformed / v.mesh - 1.0),
      100.0 * (v.deformed / v.stress_free - 1.0));
  text += fmt::format("skin under tension: {:.1f} % of it", 100.0 * headline.tension.all);
  if (headline.tension.away_from_borders) {
    text += fmt::format(", {:.1f} % away from its borders",
                        100.0 * *headline.tension.away_from_borders);
  }
  return text + '\n';
}

}  // namespace facies::results
