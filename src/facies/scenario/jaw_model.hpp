// SPDX-License-Identifier: Apache-2.0
// From the jaw of a face to a rigid body of a model and the terms that act on it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "facies/anatomy/jaw.hpp"
#include "facies/mechanics/attachment.hpp"
#include "facies/mechanics/hill_muscle.hpp"
#include "facies/mechanics/joint.hpp"

namespace facies::scenario {

/// A jaw that stands on its joint: balanced under its weight and the passive tension of its muscles. A model's state
/// counts from there.
struct SettledJaw {
  mechanics::RigidBody body;   ///< where it settled
  mechanics::Pose from_files;  ///< how it came there from the place of the bones' files
  double guide_before = 0.0;   ///< farthest that a guided point was off its path [mm]
  double guide_after = 0.0;    ///< and is now
  double deepest_stop =
      0.0;  ///< smallest distance from a stop now, negative on the wrong side [mm]
};

/// Lets the jaw alone, without any tissue, come to rest from its starting pose. Needs a solve::Session. Throws DataError
/// where guides, stops and muscles leave it no place of rest, for each guide and stop that it is more than 0.1 mm off there,
/// and where start and rest are more than 25 mm apart.
[[nodiscard]] SettledJaw settle_jaw(const anatomy::Jaw& jaw, const Vec3& gravity);

/// A point of a bone in a model whose body 0 is the settled jaw.
[[nodiscard]] mechanics::Anchor anchor_of(const anatomy::Jaw& jaw, const SettledJaw& settled,
                                          const anatomy::BonePoint& point);

/// Joint and muscles, in this order, into a model whose body 0 is the jaw; the muscles in the order of Jaw::muscles.
struct JawTerms {
  const mechanics::Joint* joint = nullptr;
  const mechanics::HillMuscles* muscles = nullptr;
};
JawTerms add_jaw_terms(mechanics::Model& model, const anatomy::Jaw& jaw, const SettledJaw& settled);

/// Names that steps may use for muscles of the jaw: exciters and muscles.
[[nodiscard]] std::vector<std::string> excitation_names(const anatomy::Jaw& jaw);

/// Excitation of every muscle [n_muscles]: its own entry where it has one, else the largest of the exciters that reach
/// it, else what it was.
[[nodiscard]] std::vector<double> excite(const anatomy::Jaw& jaw,
                                         const std::map<std::string, double>& excitations,
                                         std::vector<double> before);

}  // namespace facies::scenario
