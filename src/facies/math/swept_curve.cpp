// SPDX-License-Identifier: Apache-2.0
#include "facies/math/swept_curve.hpp"

#include <algorithm>
#include <cmath>

namespace facies {

namespace {

/// Height above z0 at a travel, and its derivatives.
struct Height {
  double f = 0.0, df = 0.0, ddf = 0.0;
};

Height cubic(const SweptCurve& c, double s) {
  return {((c.a3 * s + c.a2) * s + c.a1) * s, (3.0 * c.a3 * s + 2.0 * c.a2) * s + c.a1,
          6.0 * c.a3 * s + 2.0 * c.a2};
}

Height height(const SweptCurve& c, double s) {
  const double inside = std::clamp(s, 0.0, c.travel);
  const Height end = cubic(c, inside);
  if (inside == s) return end;
  return {end.f + (s - inside) * end.df, end.df, 0.0};
}

/// Half the derivative by s of the squared distance of the curve's point s from (s_p, z_p).
double slope_of_distance(const Height& h, double s, double s_p, double z_p) {
  return s - s_p + (h.f - z_p) * h.df;
}

/// Where the line through the curve's point s with its slope is nearest to (s_p, z_p).
double nearest_on_tangent(const Height& h, double s, double s_p, double z_p) {
  return s - slope_of_distance(h, s, s_p, z_p) / (1.0 + h.df * h.df);
}

/// The travel whose point is nearest: on the straight parts in closed form, between them by Newton's method kept in its bracket.
double nearest_travel(const SweptCurve& c, double s_p, double z_p) {
  const Height first = cubic(c, 0.0);
  if (slope_of_distance(first, 0.0, s_p, z_p) >= 0.0)
    return nearest_on_tangent(first, 0.0, s_p, z_p);
  const Height last = cubic(c, c.travel);
  if (slope_of_distance(last, c.travel, s_p, z_p) <= 0.0)
    return nearest_on_tangent(last, c.travel, s_p, z_p);
  double low = 0.0;
  double high = c.travel;
  double s = std::clamp(s_p, low, high);
  while (true) {
    const Height h = cubic(c, s);
    const double g = slope_of_distance(h, s, s_p, z_p);
    if (g == 0.0) return s;
    (g < 0.0 ? low : high) = s;
    double next = s - g / (1.0 + h.df * h.df + (h.f - z_p) * h.ddf);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - s) <= 1e-14 * c.travel || next <= low || next >= high) return next;
    s = next;
  }
}

}  // namespace

SweptCurve swept_curve(double x0, double z0, double travel, double descent, double first,
                       double last) {
  // Hermite's cubic with the values 0 and -descent.
  const double chord = -descent / travel;
  return {x0,
          z0,
          travel,
          first,
          (3.0 * chord - 2.0 * first - last) / travel,
          (first + last - 2.0 * chord) / (travel * travel)};
}

SurfaceView view(const SweptCurve& curve, const Vec3& x) {
  const double s_p = curve.x0 - x.x();
  const double z_p = x.z() - curve.z0;
  const double s = nearest_travel(curve, s_p, z_p);
  const Height h = height(curve, s);
  const double q = std::hypot(1.0, h.df);
  const Vec3 tangent(-1.0 / q, 0.0, h.df / q);  // forward is -x
  SurfaceView result;
  result.travel = s;
  result.normal = Vec3(h.df, 0.0, 1.0) / q;
  result.distance = (-h.df * (s_p - s) + (z_p - h.f)) / q;
  const double curvature = h.ddf / (q * q * q);
  result.second = -curvature / (1.0 - curvature * result.distance) * tangent * tangent.transpose();
  return result;
}

}  // namespace facies
