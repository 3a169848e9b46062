// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/jaw.hpp"

#include "facies/base/error.hpp"

namespace facies::anatomy {

namespace {

const JawPoint& point_named(const Jaw& jaw, std::string_view name) {
  const JawPoint* point = find_named(jaw.points, name);
  if (point == nullptr) throw BugError("a jaw has no point " + std::string(name));
  return *point;
}

}  // namespace

Vec3 place_of(const Jaw& jaw, const JawPose& pose, const BonePoint& point) {
  const Bone& bone = jaw.bones.at(at(point.bone));
  if (!bone.moves) return point.X;
  return bone.centre + pose.u + pose.R * (point.X - bone.centre);
}

double distance(const Jaw& jaw, const JawPose& pose, std::string_view a, std::string_view b) {
  return (place_of(jaw, pose, point_named(jaw, a).at) - place_of(jaw, pose, point_named(jaw, b).at))
      .norm();
}

}  // namespace facies::anatomy
