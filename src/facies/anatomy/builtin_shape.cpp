// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_shape.hpp"

namespace facies::anatomy {
namespace {

/// Landmarks have drawn points as near as 2 mm, which must not come to the wrong side of them when they move: what is nearer than
/// this goes along [mm].
constexpr double rounding = 15.0;

}  // namespace

RadialWarp shape_warp(const Drawings& drawings, const MeasureValues& values) {
  LandmarkPlaces drawn;
  for (const SkinLandmark& landmark : drawings.measures.landmarks)
    drawn[landmark.name] = drawings.skin.points[at(drawings.skin.index.at(landmark.point))];
  const LandmarkPlaces places = place_landmarks(drawings.measures.measures, values, drawn);
  std::vector<Vec3> from;
  std::vector<Vec3> to;
  for (const auto& [name, x] : drawn) {
    from.push_back(x);
    to.push_back(places.at(name));
    if (x.y() == 0.0) continue;
    from.emplace_back(x.x(), -x.y(), x.z());
    to.emplace_back(to.back().x(), -to.back().y(), to.back().z());
  }
  return {from, to, rounding};
}

}  // namespace facies::anatomy
