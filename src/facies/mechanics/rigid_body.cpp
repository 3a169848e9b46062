// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/rigid_body.hpp"

#include <cmath>

#include "facies/math/rotation.hpp"

namespace facies::mechanics {

double RigidBody::arm() const {
  return mass > 0.0 ? std::sqrt(inertia.trace() / (2.0 * mass)) : 1.0;
}

Vec3 place_of(const RigidBody& body, const Pose& pose, const Vec3& X) {
  return body.centre + pose.u + pose.R * (X - body.centre);
}

Pose moved(const Pose& pose, const Vec3& way, const Vec3& turn) {
  return {pose.u + way, rotation_matrix(turn) * pose.R};
}

Pose extrapolate(const Pose& before, const Pose& now, double ratio) {
  const Vec3 turn = rotation_vector(now.R * before.R.transpose());
  return moved(now, ratio * (now.u - before.u), ratio * turn);
}

}  // namespace facies::mechanics
