// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/joint.hpp"

#include <algorithm>

#include <Eigen/QR>

#include "facies/math/smooth_ramp.hpp"

namespace facies::mechanics {

namespace {

void add_block(const Model& model, const State& state, const Anchor& anchor, const Vec3& gradient,
               const Mat3& hessian, std::size_t stencil, TangentSink& K) {
  const Eigen::MatrixXd block = pull_back(model, state, {&anchor, 1}, gradient, hessian);
  K.add(stencil, {block.data(), static_cast<std::size_t>(block.size())});
}

/// How far a point has sunk in, with the corner rounded: all of it on the wrong side.
Ramp sunk(double distance) {
  return smooth_ramp(-distance - 0.5 * Stops::rounding, 0.5 * Stops::rounding);
}

}  // namespace

SurfaceView Guides::view(const State& state, std::size_t g) const {
  return facies::view(guides_[g].curve, place_of(model_, state, guides_[g].anchor));
}

Vec3 Guides::reaction(const State& state, std::size_t g) const {
  const SurfaceView seen = view(state, g);
  return -stiffness_ * seen.distance * seen.normal;
}

double Guides::energy(const State& state, const Controls& /*controls*/) const {
  double E = 0.0;
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const double d = view(state, g).distance;
    E += 0.5 * stiffness_ * d * d;
  }
  return E;
}

bool Guides::add_residual(const State& state, const Controls& /*controls*/, std::span<double> r,
                          Inadmissible* /*why*/) const {
  for (std::size_t g = 0; g < guides_.size(); ++g)
    add_gradient(model_, state, guides_[g].anchor, -reaction(state, g), r);
  return true;
}

/// By Newton's method on the distances that the straight step means, with corrections of the bodies as small as can be.
void Guides::bend(const State& from, std::span<double> increments) const {
  const auto n = static_cast<Eigen::Index>(guides_.size());
  const auto n_body_dofs = static_cast<Eigen::Index>(dofs_of_body * model_.bodies().size());
  if (n == 0 || n_body_dofs == 0) return;
  const std::size_t first = 3 * model_.n_nodes();
  Eigen::Map<Eigen::VectorXd> bodies(increments.data() + first, n_body_dofs);
  Eigen::VectorXd meant(n);
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const SurfaceView seen = view(from, g);
    meant(static_cast<Eigen::Index>(g)) =
        seen.distance + seen.normal.dot(way_of(model_, from, guides_[g].anchor, increments));
  }
  constexpr int corrections = 3;
  for (int correction = 0; correction < corrections; ++correction) {
    const State to = model_.moved(from, increments, 1.0);
    Eigen::VectorXd missing(n);
    Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(n, n_body_dofs);
    std::vector<double> gradient(model_.n_dofs());
    for (std::size_t g = 0; g < guides_.size(); ++g) {
      const auto row = static_cast<Eigen::Index>(g);
      const SurfaceView seen = view(to, g);
      missing(row) = meant(row) - seen.distance;
      std::fill(gradient.begin() + static_cast<std::ptrdiff_t>(first), gradient.end(), 0.0);
      add_gradient(model_, to, guides_[g].anchor, seen.normal, gradient);
      gradients.row(row) =
          Eigen::Map<const Eigen::RowVectorXd>(gradient.data() + first, n_body_dofs);
    }
    const Eigen::VectorXd more = gradients.completeOrthogonalDecomposition().solve(missing);
    if (!more.allFinite()) return;
    bodies += more;
  }
}

void Guides::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const Guide& guide : guides_)
    stencils.push_back(dofs_of(model_, {&guide.anchor, 1}));
}

void Guides::add_tangent(const State& state, const Controls& /*controls*/, TangentSink& K) const {
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const SurfaceView seen = view(state, g);
    const Mat3 hessian =
        stiffness_ * (seen.normal * seen.normal.transpose() + seen.distance * seen.second);
    add_block(model_, state, guides_[g].anchor, -reaction(state, g), hessian, g, K);
  }
}

double Stops::distance(const State& state, std::size_t k) const {
  return (place_of(model_, state, stops_[k].anchor) - stops_[k].point).dot(stops_[k].normal);
}

Vec3 Stops::reaction(const State& state, std::size_t k) const {
  return stiffness_ * sunk(distance(state, k)).value * stops_[k].normal;
}

double Stops::energy(const State& state, const Controls& /*controls*/) const {
  double E = 0.0;
  for (std::size_t k = 0; k < stops_.size(); ++k)
    E += stiffness_ * sunk(distance(state, k)).integral;
  return E;
}

bool Stops::add_residual(const State& state, const Controls& /*controls*/, std::span<double> r,
                         Inadmissible* /*why*/) const {
  for (std::size_t k = 0; k < stops_.size(); ++k)
    add_gradient(model_, state, stops_[k].anchor, -reaction(state, k), r);
  return true;
}

void Stops::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const Stop& stop : stops_)
    stencils.push_back(dofs_of(model_, {&stop.anchor, 1}));
}

void Stops::add_tangent(const State& state, const Controls& /*controls*/, TangentSink& K) const {
  for (std::size_t k = 0; k < stops_.size(); ++k) {
    const double slope = sunk(distance(state, k)).slope;
    if (slope == 0.0) continue;
    const Vec3& n = stops_[k].normal;
    add_block(model_, state, stops_[k].anchor, -reaction(state, k),
              stiffness_ * slope * n * n.transpose(), k, K);
  }
}

}  // namespace facies::mechanics
