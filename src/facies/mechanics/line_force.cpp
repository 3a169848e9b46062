// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/line_force.hpp"

#include <array>

namespace facies::mechanics {

Vec3 line_between(const Model& model, const State& state, const Anchor& a, const Anchor& b) {
  return place_of(model, state, a) - place_of(model, state, b);
}

void add_tension(const Model& model, const State& state, const Anchor& a, const Anchor& b,
                 double tension, std::span<double> r) {
  const Vec3 pull = tension * line_between(model, state, a, b).normalized();
  add_gradient(model, state, a, pull, r);
  add_gradient(model, state, b, -pull, r);
}

Eigen::MatrixXd tension_tangent(const Model& model, const State& state, const Anchor& a,
                                const Anchor& b, double tension, double stiffness) {
  const Vec3 line = line_between(model, state, a, b);
  const Vec3 n = line.normalized();
  const Mat3 along = n * n.transpose();
  const Mat3 H = stiffness * along + tension / line.norm() * (Mat3::Identity() - along);
  const Vec3 pull = tension * n;
  Eigen::Vector<double, 6> gradient;
  gradient << pull, -pull;
  Eigen::Matrix<double, 6, 6> hessian;
  hessian << H, -H, -H, H;
  return pull_back(model, state, std::array{a, b}, gradient, hessian);
}

}  // namespace facies::mechanics
