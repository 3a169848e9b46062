// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "facies/base/error.hpp"
#include "facies/mechanics/damping.hpp"
#include "facies/mechanics/positive_part.hpp"
#include "facies/mechanics/time_step.hpp"

namespace facies::mechanics {

namespace {

using Block = Eigen::Map<const Eigen::MatrixXd>;

/// Keeps the positive part of every block.
class KeepingSink final : public TangentSink {
 public:
  KeepingSink(std::span<const std::size_t> begin, std::span<double> kept)
      : begin_(begin), kept_(kept) {}

  void add(std::size_t stencil, std::span<const double> block) override {
    const auto place = kept_.subspan(begin_[stencil], block.size());
    std::copy(block.begin(), block.end(), place.begin());
    reduce_negative(place, 1.0);
  }

 private:
  std::span<const std::size_t> begin_;
  std::span<double> kept_;
};

Eigen::VectorXd gather(std::span<const Index> dofs, std::span<const double> v) {
  Eigen::VectorXd local(static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i)
    local(static_cast<Eigen::Index>(i)) = v[at(dofs[i])];
  return local;
}

Block block_of(std::span<const double> kept, std::size_t begin, std::size_t n) {
  return {kept.data() + begin, static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n)};
}

}  // namespace

RayleighDamping::RayleighDamping(const Solid& solid, std::vector<double> mass, double alpha,
                                 double beta)
    : solid_(solid), mass_(std::move(mass)), alpha_(alpha), beta_(beta), block_begin_{0} {
  require(alpha >= 0.0 && beta >= 0.0, "damping takes energy, it gives none");
  solid_.list_stencils({}, stencils_);
  for (std::size_t e = 0; e < stencils_.size(); ++e)
    block_begin_.push_back(block_begin_.back() + stencils_[e].size() * stencils_[e].size());
  for (Index node = 0; node < to_index(mass_.size()); ++node)
    stencils_.push_back(std::array{dof(node, 0), dof(node, 1), dof(node, 2)});
}

void RayleighDamping::begin(const Controls& controls, TimeStep& step) const {
  std::vector<double>& kept = step.kept[this];
  kept.assign(beta_ > 0.0 ? block_begin_.back() : 0, 0.0);
  if (kept.empty()) return;
  KeepingSink sink(block_begin_, kept);
  solid_.add_tangent(step.from, controls, sink);
}

/// Velocities of the nodes at the end of the step [3 n_nodes].
std::vector<double> RayleighDamping::rates(const State& state, const TimeStep& step) const {
  std::vector<double> v(3 * mass_.size());
  for (std::size_t dof = 0; dof < v.size(); ++dof) {
    const auto axis = static_cast<Eigen::Index>(dof % 3);
    const double way = state.u[dof / 3](axis) - step.from.u[dof / 3](axis);
    v[dof] = step.rate(way, step.velocity[dof]);
  }
  return v;
}

double RayleighDamping::energy(const State& state, const Controls& controls) const {
  if (!controls.time_step) return 0.0;
  const TimeStep& step = *controls.time_step;
  const std::vector<double> v = rates(state, step);
  double power = 0.0;
  for (std::size_t dof = 0; dof < v.size(); ++dof)
    power += alpha_ * mass_[dof / 3] * v[dof] * v[dof];
  const std::vector<double>& kept = step.kept.at(this);
  for (std::size_t e = 0; e < n_elements() && !kept.empty(); ++e) {
    const Eigen::VectorXd local = gather(stencils_[e], v);
    power += beta_ * local.dot(block_of(kept, block_begin_[e], stencils_[e].size()) * local);
  }
  return 0.5 * power / step.rate_by_change();
}

bool RayleighDamping::add_residual(const State& state, const Controls& controls,
                                   std::span<double> r, Inadmissible* /*why*/) const {
  if (!controls.time_step) return true;
  const TimeStep& step = *controls.time_step;
  const std::vector<double> v = rates(state, step);
  for (std::size_t dof = 0; dof < v.size(); ++dof)
    r[dof] += alpha_ * mass_[dof / 3] * v[dof];
  const std::vector<double>& kept = step.kept.at(this);
  for (std::size_t e = 0; e < n_elements() && !kept.empty(); ++e) {
    const std::span<const Index> dofs = stencils_[e];
    const Eigen::VectorXd force =
        beta_ * (block_of(kept, block_begin_[e], dofs.size()) * gather(dofs, v));
    for (std::size_t i = 0; i < dofs.size(); ++i)
      r[at(dofs[i])] += force(static_cast<Eigen::Index>(i));
  }
  return true;
}

void RayleighDamping::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (std::size_t g = 0; g < stencils_.size(); ++g)
    stencils.push_back(stencils_[g]);
}

void RayleighDamping::add_tangent(const State& /*state*/, const Controls& controls,
                                  TangentSink& K) const {
  if (!controls.time_step) return;
  const TimeStep& step = *controls.time_step;
  const double factor = step.rate_by_change();
  const std::vector<double>& kept = step.kept.at(this);
  for (std::size_t e = 0; e < n_elements() && !kept.empty(); ++e) {
    const Eigen::MatrixXd block =
        factor * beta_ * block_of(kept, block_begin_[e], stencils_[e].size());
    K.add(e, {block.data(), static_cast<std::size_t>(block.size())});
  }
  for (std::size_t node = 0; node < mass_.size(); ++node) {
    const Mat3 block = factor * alpha_ * mass_[node] * Mat3::Identity();
    K.add(n_elements() + node, {block.data(), 9});
  }
}

}  // namespace facies::mechanics
