// SPDX-License-Identifier: Apache-2.0
// A smooth map of space that takes given points to given places.
#pragma once

#include <span>
#include <vector>

#include "facies/math/tensor.hpp"

namespace facies {

/// x -> A x + b + sum_i w_i sqrt(|x - c_i|^2 + r^2). With r = 0 it is, of all maps that take the points to their places, the one
/// that bends space least (bookstein1989, in three dimensions), with a kink at each point; r rounds the kinks off (hardy1971).
/// A map of points that an affine one explains is that one, everywhere.
class RadialWarp {
 public:
  /// The map that takes each point of `from` to the one of `to` in its place, with r = `rounding` (not negative, in the unit of
  /// the points). Throws BugError where their numbers differ, two points of `from` are within 1e-6 of each other, or all lie in
  /// a plane.
  RadialWarp(std::span<const Vec3> from, std::span<const Vec3> to, double rounding = 0.0);

  [[nodiscard]] Vec3 operator()(const Vec3& x) const;

 private:
  std::vector<Vec3> centres_;
  std::vector<Vec3> weights_;
  double rounding_ = 0.0;
  Mat3 A_ = Mat3::Identity();
  Vec3 b_ = Vec3::Zero();
};

}  // namespace facies
