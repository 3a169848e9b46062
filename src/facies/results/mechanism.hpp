// SPDX-License-Identifier: Apache-2.0
// What bears the face: the jaw on its joint, and what touches what. Plain data for reports.
#pragma once

#include <string>
#include <vector>

#include "facies/math/tensor.hpp"

namespace facies::results {

/// A force that a guide or stop exerts on the jaw.
struct JointReaction {
  std::string name;           ///< "TMJ_left"
  Vec3 force = Vec3::Zero();  ///< [mN]
};

struct JawMeasure {
  double incisor_distance = 0.0;  ///< between the edges of upper and lower central incisors [mm]
  std::vector<JointReaction> reactions;
};

/// What one surface feels of the tissue.
struct ContactMeasure {
  std::string name;                ///< "jaw", "lips"
  int n_points = 0;                ///< that press on it
  double smallest_distance = 0.0;  ///< [mm]; infinite where nothing is near
  double largest_pressure = 0.0;   ///< [kPa]
  Vec3 force = Vec3::Zero();       ///< on the surface [mN]
};

/// How the jaw came onto its joint before anything else.
struct SettlingMeasure {
  double way = 0.0;   ///< of its centre from the place of its file [mm]
  double turn = 0.0;  ///< from there [deg]
  double guide_before =
      0.0;  ///< farthest that a guided point was off its path in the starting pose [mm]
  double guide_after = 0.0;             ///< and is now
  double smallest_stop_distance = 0.0;  ///< [mm], negative on the wrong side
  double incisor_distance = 0.0;        ///< [mm]
};

}  // namespace facies::results
