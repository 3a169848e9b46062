// SPDX-License-Identifier: Apache-2.0
// Additive continuous collision detection adds up steps of time that are too short for the gap to close. The source
// (li2021) divides the gap by the largest speed. Here the gap is watched along the unit vector u from the closest point
// to p: the triangle is convex, so at any time
//
//   distance >= min over i in a, b, c of u . (p - x_i),
//
// and each of the three changes at a constant rate, at most the largest speed. A step ends when the first of them has
// come down to the distance asked for. A point that slides along a face, which would take the source's bound any number
// of steps, then takes one; so does a head-on collision. The bound holds for every unit vector, so that rounding in u
// cannot make it wrong, only weak; the source's own bound is then the longer step.
#include "facies/math/continuous_collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "facies/base/error.hpp"
#include "facies/math/point_triangle.hpp"

namespace facies {
namespace {

/// Nearly every motion needs less than ten. Those that turn the triangle by much more than the distance would creep.
constexpr int max_steps = 1000;
/// How far above the distance asked for a step may end, as a part of it.
constexpr double tolerance = 1e-3;
/// Rounding of a difference of coordinates, as a part of the largest of them, with a margin.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// p - a, p - b, p - c.
using Separation = std::array<Vec3, 3>;

Separation separation(const PointAndTriangle& x) {
  return {x.p - x.a, x.p - x.b, x.p - x.c};
}

/// A bound on the largest coordinate; not finite where one of them is not.
double size_of(const Separation& r) {
  return r[0].norm() + r[1].norm() + r[2].norm();
}

/// A time for which the distance d > `smallest` stays above `smallest`. `u`: from the closest point to p.
double safe_step(const Separation& r, const Separation& v, const Vec3& u, double d,
                 double smallest) {
  double along_u = std::numeric_limits<double>::infinity();
  double fastest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    fastest = std::max(fastest, v[i].norm());
    const double above = u.dot(r[i]) - smallest;
    const double speed = -u.dot(v[i]);
    if (above <= 0.0) {
      along_u = 0.0;
    } else if (speed > 0.0) {
      along_u = std::min(along_u, above / speed);
    }
  }
  return std::max(along_u, (d - smallest) / fastest);
}

}  // namespace

double safe_time(const PointAndTriangle& start, const PointAndTriangle& motion, double fraction) {
  require(fraction > 0.0 && fraction < 1.0, "safe_time: the fraction must lie between 0 and 1");
  const Separation r0 = separation(start);
  const Separation v = separation(motion);
  if (size_of(v) == 0.0) return 1.0;
  double smallest = 0.0;
  double t = 0.0;
  for (int step = 0; step < max_steps; ++step) {
    Separation r;
    for (std::size_t i = 0; i < 3; ++i)
      r[i] = r0[i] + t * v[i];
    // The triangle as seen from p.
    const ClosestOnTriangle closest = closest_on_triangle(Vec3::Zero(), -r[0], -r[1], -r[2]);
    const double d = std::sqrt(closest.distance_squared);
    if (step == 0) {
      smallest = fraction * d;
      if (!(smallest > rounding * (size_of(r0) + size_of(v)))) return 0.0;
    }
    if (d <= (1.0 + tolerance) * smallest) return t;
    const double allowed = safe_step(r, v, closest.offset / d, d, smallest);
    if (t + allowed >= 1.0) return 1.0;
    t += allowed;
  }
  return t;
}

}  // namespace facies
