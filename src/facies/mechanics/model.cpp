// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/model.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/error.hpp"

namespace facies::mechanics {

double Model::energy(const State& state, const Controls& controls) const {
  double total = 0.0;
  for (const auto& term : terms_)
    total += term->energy(state, controls);
  return total;
}

bool Model::residual(const State& state, const Controls& controls, std::span<double> r,
                     Inadmissible* why) const {
  require(r.size() == n_dofs(), "a residual has one entry per unknown");
  std::fill(r.begin(), r.end(), 0.0);
  return std::all_of(terms_.begin(), terms_.end(),
                     [&](const auto& term) { return term->add_residual(state, controls, r, why); });
}

void Model::damping(const State& state, const Controls& controls, std::span<double> r) const {
  require(r.size() == n_dofs(), "a residual has one entry per unknown");
  std::fill(r.begin(), r.end(), 0.0);
  for (const auto& term : terms_) {
    if (!term->dissipates()) continue;
    const bool admissible = term->add_residual(state, controls, r, nullptr);
    require(admissible, "damping is asked for at admissible states");
  }
}

State Model::moved(const State& state, std::span<const double> increments, double ratio) const {
  require(increments.size() == n_dofs(), "increments have one entry per unknown");
  State after = state;
  for (std::size_t node = 0; node < n_nodes_; ++node) {
    const Eigen::Map<const Vec3> du(increments.data() + 3 * node);
    after.u[node] += ratio * du;
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const double* six = increments.data() + at(body_dof(to_index(b), 0));
    const Eigen::Map<const Vec3> way(six);
    const Eigen::Map<const Vec3> turn(six + 3);
    after.bodies[b] =
        mechanics::moved(state.bodies[b], ratio * way, ratio / bodies_[b].arm() * turn);
  }
  return after;
}

std::vector<double> Model::bent(const State& state, std::span<const double> increments,
                                double ratio) const {
  std::vector<double> straight(increments.begin(), increments.end());
  for (double& increment : straight)
    increment *= ratio;
  std::vector<double> step = straight;
  for (const auto& term : terms_)
    term->bend(state, straight, step);
  return step;
}

double Model::value_of(const State& state, Index dof) const {
  return at(dof) < 3 * n_nodes_ ? state.u[at(dof / 3)](dof % 3) : 0.0;
}

double Model::longest_step(const State& from, const State& to) const {
  double step = 1.0;
  for (const auto& term : terms_)
    step = std::min(step, term->longest_step(from, to));
  return step;
}

Inadmissible Model::overgrown(const State& state) const {
  Inadmissible worst;
  for (const auto& term : terms_) {
    const Inadmissible found = term->overgrown(state);
    if (found.element >= 0 && found.J > worst.J) worst = found;
  }
  return worst;
}

std::string describe(const Inadmissible& inadmissible) {
  if (inadmissible.J > 0.0) {
    return fmt::format(
        "element {} has grown to {:.3g} times its stress-free volume, more than its law can hold",
        inadmissible.element, inadmissible.J);
  }
  return fmt::format("element {} would be inside out (det F = {:.2g})", inadmissible.element,
                     inadmissible.J);
}

}  // namespace facies::mechanics
