// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/attachment.hpp"

#include <algorithm>
#include <array>

namespace facies::mechanics {

Vec3 Attachment::gap(const State& state, const Tie& tie) const {
  return place_of(model_, state, tie.a) - place_of(model_, state, tie.b) - (tie.a.X - tie.b.X);
}

double Attachment::energy(const State& state, const Controls& /*controls*/) const {
  double E = 0.0;
  for (const Tie& tie : ties_)
    E += 0.5 * stiffness_ * gap(state, tie).squaredNorm();
  return E;
}

bool Attachment::add_residual(const State& state, const Controls& /*controls*/, std::span<double> r,
                              Inadmissible* /*why*/) const {
  for (const Tie& tie : ties_) {
    const Vec3 force = stiffness_ * gap(state, tie);
    add_gradient(model_, state, tie.a, force, r);
    add_gradient(model_, state, tie.b, -force, r);
  }
  return true;
}

void Attachment::bend(const State& from, std::span<const double> straight,
                      std::span<double> increments) const {
  const State to = model_.moved(from, increments, 1.0);
  for (const Tie& tie : ties_) {
    const Vec3 meant = gap(from, tie) + way_of(model_, from, tie.a, straight) -
                       way_of(model_, from, tie.b, straight);
    const Vec3 missing = meant - gap(to, tie);
    if (tie.a.kind == Anchor::Kind::node)
      Eigen::Map<Vec3>(increments.data() + dof(tie.a.index, 0)) += missing;
    else if (tie.b.kind == Anchor::Kind::node)
      Eigen::Map<Vec3>(increments.data() + dof(tie.b.index, 0)) -= missing;
  }
}

void Attachment::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const Tie& tie : ties_)
    stencils.push_back(dofs_of(model_, std::array{tie.a, tie.b}));
}

void Attachment::add_tangent(const State& state, const Controls& /*controls*/,
                             TangentSink& K) const {
  Eigen::MatrixXd hessian = stiffness_ * Eigen::MatrixXd::Identity(6, 6);
  hessian.topRightCorner<3, 3>() = hessian.bottomLeftCorner<3, 3>() =
      -stiffness_ * Mat3::Identity();
  for (std::size_t k = 0; k < ties_.size(); ++k) {
    const Vec3 force = stiffness_ * gap(state, ties_[k]);
    Eigen::VectorXd gradient(6);
    gradient.head<3>() = force;
    gradient.tail<3>() = -force;
    const Eigen::MatrixXd block =
        pull_back(model_, state, std::array{ties_[k].a, ties_[k].b}, gradient, hessian);
    K.add(k, {block.data(), static_cast<std::size_t>(block.size())});
  }
}

double Attachment::largest_gap(const State& state) const {
  double largest = 0.0;
  for (const Tie& tie : ties_)
    largest = std::max(largest, gap(state, tie).norm());
  return largest;
}

}  // namespace facies::mechanics
