// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_lengths.hpp"

#include <algorithm>

namespace facies::anatomy {
namespace {

std::optional<double> value_of(const MeasureValues& values, const std::string& key) {
  const auto value = values.find(key);
  return value == values.end() ? std::nullopt : std::optional(value->second);
}

/// Where the drawn points have come to: the outer node of a point has the point's number.
std::vector<Vec3> drawn_points(const Drawings& drawings, const FaceAnatomy& face) {
  const std::span<const Vec3> X = face.mesh.X();
  return {X.begin(), X.begin() + static_cast<std::ptrdiff_t>(drawings.skin.points.size())};
}

}  // namespace

std::vector<FaceLength> lengths_of(const Drawings& drawings, const MeasureValues& wanted,
                                   const MeasureValues& depths, const FaceAnatomy& face) {
  const std::vector<Vec3> outer = drawn_points(drawings, face);
  LandmarkPlaces places;
  for (const SkinLandmark& landmark : drawings.measures.landmarks)
    places[landmark.name] = outer[at(drawings.skin.index.at(landmark.point))];
  std::vector<FaceLength> lengths;
  for (const FaceMeasure& measure : drawings.measures.measures) {
    lengths.push_back({measure.key, measure.meaning, value_of(wanted, measure.key),
                       measured(measure, places), measure.smallest, measure.largest});
  }
  const std::vector<MeasuredDepth> found =
      measure_depths(drawings.depths, *face.jaw, smooth_surface(drawings.skin, outer));
  for (const DepthSite& site : drawings.depths) {
    const auto depth = std::ranges::find(found, site.key, &MeasuredDepth::key);
    if (depth == found.end()) continue;
    lengths.push_back({site.key, site.meaning, value_of(depths, site.key), depth->depth,
                       site.smallest, site.largest});
  }
  return lengths;
}

}  // namespace facies::anatomy
