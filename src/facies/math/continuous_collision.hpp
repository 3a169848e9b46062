// SPDX-License-Identifier: Apache-2.0
// How far a point and a triangle may move on straight lines before they come too close.
#pragma once

#include "facies/math/tensor.hpp"

namespace facies {

/// A point p and a triangle a, b, c: positions, or how far each of the four moves [mm].
struct PointAndTriangle {
  Vec3 p = Vec3::Zero();
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  Vec3 c = Vec3::Zero();
};

/// The largest t in 0..1 such that the distance of start + s motion is at least `fraction` (0 < fraction < 1) of that of
/// `start` for every s in 0..t; 1 where it never falls so low.
///
/// Conservative: never past such a moment. Short of it, or of 1, in two cases: the distance at t is within a thousandth of
/// the one asked for; or a triangle that turns by hundreds of times its distance used up a thousand steps. 0 where the
/// distance of a moving `start` is lost in rounding (below about 1e-11 mm at 100 mm) or a number is not finite.
///
/// Additive continuous collision detection (li2021), with a bound on the approach that is never weaker: see the source.
[[nodiscard]] double safe_time(const PointAndTriangle& start, const PointAndTriangle& motion,
                               double fraction = 0.1);

}  // namespace facies
