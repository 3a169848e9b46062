// SPDX-License-Identifier: Apache-2.0
// The closest point is looked for on the face (where p projects into it) and on the three edges; the nearest wins. That
// needs no case distinction that a needle could upset.
//
// Derivatives. Let u be the unit vector from the closest point to p, beta = (1, -lambda_a, -lambda_b, -lambda_c) with the
// barycentric weights lambda of the closest point, and t = (0, grad lambda_a, grad lambda_b, grad lambda_c) their
// gradients along the nearest feature (t is tangential to the face; parallel to the edge; zero at a vertex). d is the
// minimum of |p - q| over the points q of the feature; hence, with i, j in p, a, b, c,
//
//   dd/dx_i       = beta_i u
//   d2d/dx_i dx_j = beta_i beta_j M / d - beta_j u (x) t_i - beta_i t_j (x) u - d (t_i . t_j) u (x) u
//
// where M projects on the directions that are normal to u and to the feature: nothing for a face, u x e for an edge
// along e, I - u (x) u for a vertex. For a face no term grows as d goes to zero.
#include "facies/math/point_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "facies/base/error.hpp"

namespace facies {
namespace {

constexpr double flat_height = 1e-8;

/// The triangle as seen from a.
struct Frame {
  Vec3 ab, ac, normal;  // the normal is not a unit vector
  bool is_flat;
};

Frame make_frame(const Vec3& a, const Vec3& b, const Vec3& c) {
  Frame frame{b - a, c - a, Vec3::Zero(), false};
  frame.normal = frame.ab.cross(frame.ac);
  const double longest_squared =
      std::max({frame.ab.squaredNorm(), frame.ac.squaredNorm(), (c - b).squaredNorm()});
  frame.is_flat = !(frame.normal.norm() > flat_height * longest_squared);
  return frame;
}

ClosestOnTriangle closest_on_edge(int edge, const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const Vec3 r = p - from;
  const double length_squared = along.squaredNorm();
  const double t = length_squared > 0.0 ? std::clamp(r.dot(along) / length_squared, 0.0, 1.0) : 0.0;
  const int next = (edge + 1) % 3;
  ClosestOnTriangle closest;
  closest.barycentric(edge) = 1.0 - t;
  closest.barycentric(next) = t;
  if (t == 0.0) {
    closest.feature = TriangleFeature(int(TriangleFeature::vertex0) + edge);
    closest.offset = r;
  } else if (t == 1.0) {
    closest.feature = TriangleFeature(int(TriangleFeature::vertex0) + next);
    closest.offset = p - to;
  } else {
    closest.feature = TriangleFeature(int(TriangleFeature::edge0) + edge);
    closest.offset = r - t * along;
    // Of a long edge, the rounding of t along it may be as large as a small distance.
    closest.offset -= (closest.offset.dot(along) / length_squared) * along;
  }
  closest.distance_squared = closest.offset.squaredNorm();
  return closest;
}

/// Where p projects into the triangle: the candidate on its face; else one at infinity.
ClosestOnTriangle closest_on_face(const Vec3& p, const Vec3& a, const Frame& frame) {
  ClosestOnTriangle closest;
  closest.distance_squared = HUGE_VAL;
  if (frame.is_flat) return closest;
  const Vec3 r = p - a;
  const double normal_squared = frame.normal.squaredNorm();
  const double b = frame.normal.dot(r.cross(frame.ac)) / normal_squared;
  const double c = frame.normal.dot(frame.ab.cross(r)) / normal_squared;
  if (!(b > 0.0 && c > 0.0 && b + c < 1.0)) return closest;
  closest.barycentric = Vec3(1.0 - b - c, b, c);
  closest.offset = (frame.normal.dot(r) / normal_squared) * frame.normal;
  closest.distance_squared = closest.offset.squaredNorm();
  return closest;
}

using Weights = std::array<double, 4>;
using WeightGradients = std::array<Vec3, 4>;

/// t of the head comment. `edges`: the vectors opposite to a, b and c.
WeightGradients weight_gradients(TriangleFeature feature, const std::array<Vec3, 3>& edges,
                                 const Vec3& normal) {
  WeightGradients t{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  if (feature == TriangleFeature::face) {
    for (std::size_t i = 0; i < 3; ++i)
      t[i + 1] = normal.cross(edges[i]) / normal.squaredNorm();
  } else if (feature <= TriangleFeature::edge2) {
    const auto from = std::size_t(feature) - std::size_t(TriangleFeature::edge0);
    const Vec3& along = edges[(from + 2) % 3];
    t[(from + 1) % 3 + 1] = along / along.squaredNorm();
    t[from + 1] = -t[(from + 1) % 3 + 1];
  }
  return t;
}

/// M of the head comment.
Mat3 normal_directions(TriangleFeature feature, const std::array<Vec3, 3>& edges, const Vec3& u) {
  if (feature == TriangleFeature::face) return Mat3::Zero();
  if (feature >= TriangleFeature::vertex0) return Mat3::Identity() - u * u.transpose();
  const auto from = std::size_t(feature) - std::size_t(TriangleFeature::edge0);
  const Vec3 m = u.cross(edges[(from + 2) % 3]).normalized();
  return m * m.transpose();
}

}  // namespace

bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  return make_frame(a, b, c).is_flat;
}

ClosestOnTriangle closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  ClosestOnTriangle closest = closest_on_edge(0, p, a, b);
  for (const ClosestOnTriangle& candidate :
       {closest_on_edge(1, p, b, c), closest_on_edge(2, p, c, a)}) {
    if (candidate.distance_squared < closest.distance_squared) closest = candidate;
  }
  const ClosestOnTriangle face = closest_on_face(p, a, make_frame(a, b, c));
  return face.distance_squared <= closest.distance_squared ? face : closest;
}

DistanceResponse distance_response(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const ClosestOnTriangle closest = closest_on_triangle(p, a, b, c);
  DistanceResponse response;
  response.d = std::sqrt(closest.distance_squared);
  require(response.d > 0.0, "the derivatives of a distance need a distance above zero");
  const Vec3 u = closest.offset / response.d;
  const std::array<Vec3, 3> edges{c - b, a - c, b - a};
  const Weights beta{1.0, -closest.barycentric(0), -closest.barycentric(1),
                     -closest.barycentric(2)};
  const WeightGradients t = weight_gradients(closest.feature, edges, edges[2].cross(-edges[1]));
  const Mat3 M_by_d = normal_directions(closest.feature, edges, u) / response.d;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = Eigen::Index(3 * i);
    response.gradient.segment<3>(row) = beta[i] * u;
    for (std::size_t j = 0; j <= i; ++j) {
      const auto column = Eigen::Index(3 * j);
      const Vec3 along = beta[j] * t[i] + response.d * t[i].dot(t[j]) * u;
      const Mat3 block =
          beta[i] * beta[j] * M_by_d - u * along.transpose() - beta[i] * t[j] * u.transpose();
      response.hessian.block<3, 3>(row, column) = block;
      response.hessian.block<3, 3>(column, row) = block.transpose();
    }
  }
  return response;
}

}  // namespace facies
