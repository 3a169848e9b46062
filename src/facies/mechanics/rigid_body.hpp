// SPDX-License-Identifier: Apache-2.0
// Rigid bodies: six unknowns each, rotations exact for any angle.
#pragma once

#include <string>
#include <vector>

#include "facies/math/tensor.hpp"

namespace facies::mechanics {

/// A body in the place that it has when nothing has moved.
struct RigidBody {
  std::string name;
  Vec3 centre = Vec3::Zero();       ///< of mass [mm]
  double mass = 0.0;                ///< [kg]
  Mat3 inertia = Mat3::Identity();  ///< about the centre [kg mm^2]

  /// Its rotations are counted as ways at this distance from the centre [mm], so that all unknowns are lengths and all
  /// residuals forces: sqrt(tr(inertia) / (2 mass)), 1 mm for a body without mass.
  [[nodiscard]] double arm() const;
};

/// Where a body has gone: x = centre + u + R (X - centre).
struct Pose {
  Vec3 u = Vec3::Zero();  ///< displacement of the centre [mm]
  Mat3 R = Mat3::Identity();
};

/// The place of the body's point that was at X [mm].
[[nodiscard]] Vec3 place_of(const RigidBody& body, const Pose& pose, const Vec3& X);

/// The pose after a further way of the centre and a rotation vector in space [rad].
[[nodiscard]] Pose moved(const Pose& pose, const Vec3& way, const Vec3& turn);

/// The pose as far beyond `now` as `ratio` times the way from `before` to `now`, in way and in rotation.
[[nodiscard]] Pose extrapolate(const Pose& before, const Pose& now, double ratio);

}  // namespace facies::mechanics
