// SPDX-License-Identifier: Apache-2.0
// A surface that a curve of the x-z plane sweeps along y: the path that a joint leaves to a point.
#pragma once

#include "facies/math/tensor.hpp"

namespace facies {

/// z = z0 + a1 s + a2 s^2 + a3 s^3 over the forward travel s = x0 - x [mm], 0 <= s <= travel; straight, with the slope of
/// its ends, beyond them.
struct SweptCurve {
  double x0 = 0.0, z0 = 0.0;            ///< where it begins [mm]
  double travel = 0.0;                  ///< [mm], positive
  double a1 = 0.0, a2 = 0.0, a3 = 0.0;  ///< [1, 1/mm, 1/mm^2]
};

/// The curve that falls by `descent` [mm] over `travel` [mm] and has the slopes dz/ds `first` and `last` at its ends.
[[nodiscard]] SweptCurve swept_curve(double x0, double z0, double travel, double descent,
                                     double first, double last);

/// What a point sees of the surface.
struct SurfaceView {
  double distance = 0.0;       ///< positive above the surface [mm]
  double travel = 0.0;         ///< s of the nearest point [mm]
  Vec3 normal = Vec3::Zero();  ///< there, upward: the gradient of the distance
  Mat3 second = Mat3::Zero();  ///< second derivative of the distance by the point [1/mm]
};

/// Distance and its derivatives at x [mm]. Exact, and continuous with the first derivative, where x is nearer than the
/// surface's radius of curvature (30 mm on the reference face); beyond it, those of some stationary point of the distance.
[[nodiscard]] SurfaceView view(const SweptCurve& curve, const Vec3& x);

}  // namespace facies
