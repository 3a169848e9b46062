// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/hill_muscle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/math/smooth_ramp.hpp"
#include "facies/mechanics/line_force.hpp"

namespace facies::mechanics {

namespace {

constexpr double shortest = 1e-3;  // ends nearer than this have no direction to speak of [mm]
constexpr double rounding = 0.01;  // of the corners of f_pas, as a part of l_max - l_opt

HillForce active(const HillParameters& p, double length) {
  const double belly = p.optimal_length * (1.0 - p.tendon_ratio);
  const double l_n = (length - p.optimal_length * p.tendon_ratio) / belly;
  if (l_n <= 0.5) return {};
  if (l_n >= 1.5) return {0.5 * belly, 0.0, 0.0};
  const double angle = 2.0 * std::numbers::pi * l_n;
  return {belly * (0.5 * (l_n - 0.5) + std::sin(angle) / (4.0 * std::numbers::pi)),
          0.5 * (1.0 + std::cos(angle)), -std::numbers::pi * std::sin(angle) / belly};
}

HillForce passive(const HillParameters& p, double length) {
  const double range = p.max_length - p.optimal_length;
  const double above = length - p.max_length;
  if (above > rounding * range)
    return {above + 0.5 * range, 1.0, 0.0};  // no difference of large numbers
  const Ramp begin = smooth_ramp(length - p.optimal_length, rounding * range);
  const Ramp end = smooth_ramp(above, rounding * range);
  return {(begin.integral - end.integral) / range, (begin.value - end.value) / range,
          (begin.slope - end.slope) / range};
}

void check(const HillMuscle& muscle, Problems& problems) {
  const HillParameters& p = muscle.parameters;
  const std::string where = fmt::format("muscle '{}'", muscle.name);
  const double length = (muscle.a.X - muscle.b.X).norm();
  if (!(length > shortest)) {
    problems.add({where, fmt::format("ends {:.2g} mm apart", length), "two different points", ""});
  }
  if (!(p.optimal_length > 0.0 && p.max_length > p.optimal_length)) {
    problems.add(
        {where,
         fmt::format("optimal length {} mm, greatest length {} mm", p.optimal_length, p.max_length),
         "0 < optimal < greatest", ""});
  }
  if (!(p.tendon_ratio >= 0.0 && p.tendon_ratio < 1.0)) {
    problems.add({where, fmt::format("tendon ratio {}", p.tendon_ratio), "0 or more, below 1", ""});
  }
  if (!(p.max_force >= 0.0 && p.passive_fraction >= 0.0 && p.damping >= 0.0)) {
    problems.add({where,
                  fmt::format("greatest force {} mN, passive fraction {}, damping {} mN s/mm",
                              p.max_force, p.passive_fraction, p.damping),
                  "nothing negative", ""});
  }
}

}  // namespace

HillForce hill_force(const HillParameters& muscle, double length, double excitation) {
  const HillForce act = active(muscle, length);
  const HillForce pas = passive(muscle, length);
  const double e = muscle.max_force * excitation;
  const double p = muscle.max_force * muscle.passive_fraction;
  return {e * act.energy + p * pas.energy, e * act.force + p * pas.force,
          e * act.stiffness + p * pas.stiffness};
}

HillMuscles::HillMuscles(const Model& model, std::vector<HillMuscle> muscles)
    : model_(model), muscles_(std::move(muscles)) {
  Problems problems;
  for (std::size_t m = 0; m < muscles_.size(); ++m) {
    check(muscles_[m], problems);
    if (!dofs_of(model_, std::array{muscles_[m].a, muscles_[m].b}).empty()) moving_.push_back(m);
  }
  problems.throw_if_any<DataError>();
}

double HillMuscles::length(const State& state, std::size_t m) const {
  return line_between(model_, state, muscles_[m].a, muscles_[m].b).norm();
}

HillForce HillMuscles::evaluate(const State& state, const Controls& controls, std::size_t m) const {
  require(controls.excitation.empty() || controls.excitation.size() == muscles_.size(),
          "one excitation per muscle between points, or none at all");
  const double excitation = controls.excitation.empty() ? 0.0 : controls.excitation[m];
  return hill_force(muscles_[m].parameters, length(state, m), excitation);
}

double HillMuscles::force(const State& state, const Controls& controls, std::size_t m) const {
  return evaluate(state, controls, m).force;
}

double HillMuscles::energy(const State& state, const Controls& controls) const {
  double E = 0.0;
  for (std::size_t m = 0; m < muscles_.size(); ++m)
    E += evaluate(state, controls, m).energy;
  return E;
}

bool HillMuscles::add_residual(const State& state, const Controls& controls, std::span<double> r,
                               Inadmissible* /*why*/) const {
  for (const std::size_t m : moving_) {
    const HillForce hill = evaluate(state, controls, m);
    if (hill.force == 0.0) continue;  // so is every muscle whose ends meet
    add_tension(model_, state, muscles_[m].a, muscles_[m].b, hill.force, r);
  }
  return true;
}

void HillMuscles::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const std::size_t m : moving_)
    stencils.push_back(dofs_of(model_, std::array{muscles_[m].a, muscles_[m].b}));
}

void HillMuscles::add_tangent(const State& state, const Controls& controls, TangentSink& K) const {
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    const std::size_t m = moving_[k];
    const HillForce hill = evaluate(state, controls, m);
    if (hill.force == 0.0 && hill.stiffness == 0.0) continue;
    const Eigen::MatrixXd block =
        tension_tangent(model_, state, muscles_[m].a, muscles_[m].b, hill.force, hill.stiffness);
    K.add(k, {block.data(), static_cast<std::size_t>(block.size())});
  }
}

}  // namespace facies::mechanics
