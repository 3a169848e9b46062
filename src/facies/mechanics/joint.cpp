// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/joint.hpp"

#include <algorithm>
#include <limits>

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
  return smooth_ramp(-distance - 0.5 * Joint::rounding, 0.5 * Joint::rounding);
}

/// How deep a point may sink in, in one step that leads it into a plane it did not feel yet; else twice as deep as it is,
/// until all of its stiffness is felt.
constexpr double first_depth = 0.25 * Joint::rounding;
constexpr double deeper = 2.0;

double least_distance(double distance) {
  if (distance <= -Joint::rounding) return -std::numeric_limits<double>::infinity();
  return std::min(-first_depth, deeper * distance);
}

}  // namespace

/// Conditions on the bodies: each row of the gradients times what the bodies do more has to be what is missing.
struct Joint::Leads {
  std::vector<double> missing;    // [mm]
  std::vector<double> gradients;  // row by row, [n_body_dofs] each
};

SurfaceView Joint::view(const State& state, std::size_t g) const {
  return facies::view(guides_[g].curve, place_of(model_, state, guides_[g].anchor));
}

Vec3 Joint::guide_reaction(const State& state, std::size_t g) const {
  const SurfaceView seen = view(state, g);
  return -stiffness_ * seen.distance * seen.normal;
}

double Joint::distance(const State& state, std::size_t k) const {
  return (place_of(model_, state, stops_[k].anchor) - stops_[k].point).dot(stops_[k].normal);
}

Vec3 Joint::stop_reaction(const State& state, std::size_t k) const {
  return stiffness_ * sunk(distance(state, k)).value * stops_[k].normal;
}

double Joint::energy(const State& state, const Controls& /*controls*/) const {
  double E = 0.0;
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const double d = view(state, g).distance;
    E += 0.5 * stiffness_ * d * d;
  }
  for (std::size_t k = 0; k < stops_.size(); ++k)
    E += stiffness_ * sunk(distance(state, k)).integral;
  return E;
}

bool Joint::add_residual(const State& state, const Controls& /*controls*/, std::span<double> r,
                         Inadmissible* /*why*/) const {
  for (std::size_t g = 0; g < guides_.size(); ++g)
    add_gradient(model_, state, guides_[g].anchor, -guide_reaction(state, g), r);
  for (std::size_t k = 0; k < stops_.size(); ++k)
    add_gradient(model_, state, stops_[k].anchor, -stop_reaction(state, k), r);
  return true;
}

void Joint::add_lead(const State& to, const Anchor& anchor, const Vec3& direction, double missing,
                     Leads& leads) const {
  std::vector<double> gradient(model_.n_dofs());
  add_gradient(model_, to, anchor, direction, gradient);
  leads.gradients.insert(leads.gradients.end(),
                         gradient.begin() + static_cast<std::ptrdiff_t>(3 * model_.n_nodes()),
                         gradient.end());
  leads.missing.push_back(missing);
}

/// By Newton's method on the distances that the straight step means, with corrections of the bodies as small as can be.
void Joint::bend(const State& from, std::span<const double> straight,
                 std::span<double> increments) const {
  const auto n_body_dofs = static_cast<Eigen::Index>(dofs_of_body * model_.bodies().size());
  if (n_body_dofs == 0) return;
  Eigen::Map<Eigen::VectorXd> bodies(increments.data() + 3 * model_.n_nodes(), n_body_dofs);
  std::vector<double> meant;  // distances of guided points
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const SurfaceView seen = view(from, g);
    meant.push_back(seen.distance +
                    seen.normal.dot(way_of(model_, from, guides_[g].anchor, straight)));
  }
  std::vector<bool> stopped(stops_.size(), false);
  constexpr int corrections = 4;
  for (int correction = 0; correction < corrections; ++correction) {
    const State to = model_.moved(from, increments, 1.0);
    Leads leads;
    for (std::size_t g = 0; g < guides_.size(); ++g) {
      const SurfaceView seen = view(to, g);
      add_lead(to, guides_[g].anchor, seen.normal, meant[g] - seen.distance, leads);
    }
    for (std::size_t k = 0; k < stops_.size(); ++k) {
      const double missing = least_distance(distance(from, k)) - distance(to, k);
      stopped[k] = stopped[k] || missing > 0.0;
      if (stopped[k]) add_lead(to, stops_[k].anchor, stops_[k].normal, missing, leads);
    }
    const auto n = static_cast<Eigen::Index>(leads.missing.size());
    if (n == 0) return;
    const Eigen::Map<const Eigen::VectorXd> missing(leads.missing.data(), n);
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
        gradients(leads.gradients.data(), n, n_body_dofs);
    const Eigen::VectorXd more = gradients.completeOrthogonalDecomposition().solve(missing);
    if (!more.allFinite()) return;
    bodies += more;
  }
}

void Joint::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const Guide& guide : guides_)
    stencils.push_back(dofs_of(model_, {&guide.anchor, 1}));
  for (const Stop& stop : stops_)
    stencils.push_back(dofs_of(model_, {&stop.anchor, 1}));
}

void Joint::add_tangent(const State& state, const Controls& /*controls*/, TangentSink& K) const {
  for (std::size_t g = 0; g < guides_.size(); ++g) {
    const SurfaceView seen = view(state, g);
    const Mat3 hessian =
        stiffness_ * (seen.normal * seen.normal.transpose() + seen.distance * seen.second);
    add_block(model_, state, guides_[g].anchor, -guide_reaction(state, g), hessian, g, K);
  }
  for (std::size_t k = 0; k < stops_.size(); ++k) {
    const double slope = sunk(distance(state, k)).slope;
    if (slope == 0.0) continue;
    const Vec3& n = stops_[k].normal;
    add_block(model_, state, stops_[k].anchor, -stop_reaction(state, k),
              stiffness_ * slope * n * n.transpose(), guides_.size() + k, K);
  }
}

}  // namespace facies::mechanics
