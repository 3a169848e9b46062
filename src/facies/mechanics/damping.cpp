// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/damping.hpp"

#include <array>
#include <numeric>

#include <Eigen/Geometry>

#include "facies/base/error.hpp"
#include "facies/math/rotation.hpp"
#include "facies/mechanics/line_force.hpp"
#include "facies/mechanics/time_step.hpp"
#include "facies/mechanics/turn.hpp"

namespace facies::mechanics {

namespace {

Vec3 velocity_at(const TimeStep& step, Index first_dof) {
  return Eigen::Map<const Vec3>(step.velocity.data() + first_dof);
}

/// At the beginning of the step.
Vec3 velocity_of(const Model& model, const TimeStep& step, const Anchor& anchor) {
  if (anchor.kind == Anchor::Kind::node) return velocity_at(step, dof(anchor.index, 0));
  if (anchor.kind == Anchor::Kind::space) return Vec3::Zero();
  const RigidBody& body = model.bodies()[at(anchor.index)];
  const Vec3 lever = step.from.bodies[at(anchor.index)].R * (anchor.X - body.centre);
  const Vec3 omega = velocity_at(step, model.body_dof(anchor.index, 3)) / body.arm();
  return velocity_at(step, model.body_dof(anchor.index, 0)) + omega.cross(lever);
}

/// A turn in a time step: its sine vector stands for the rotation vector, the same to second order.
TurnResponse turn_in(const TimeStep& step, const State& state, std::size_t body) {
  return turn_response(step.from.bodies[body].R, state.bodies[body].R, Mat3::Identity());
}

}  // namespace

BodyDamping::BodyDamping(const Model& model, std::vector<BodyFriction> friction)
    : model_(model), friction_(std::move(friction)) {
  require(friction_.size() == model.bodies().size(), "one friction per body");
  for (const BodyFriction& f : friction_)
    require(f.translational >= 0.0 && f.rotational >= 0.0, "damping takes energy, it gives none");
}

double BodyDamping::energy(const State& state, const Controls& controls) const {
  if (!controls.time_step) return 0.0;
  const TimeStep& step = *controls.time_step;
  double E = 0.0;
  for (std::size_t b = 0; b < friction_.size(); ++b) {
    const auto body = to_index(b);
    const double arm = model_.bodies()[b].arm();
    const Vec3 way = state.bodies[b].u - step.from.bodies[b].u;
    const Vec3 rate = step.rate(way, velocity_at(step, model_.body_dof(body, 0)));
    E += 0.5 * friction_[b].translational * rate.squaredNorm() / step.rate_by_change();
    const Vec3 omega = velocity_at(step, model_.body_dof(body, 3)) / arm;
    const Vec3 turn = rotation_vector(state.bodies[b].R * step.from.bodies[b].R.transpose());
    E += friction_[b].rotational *
         (step.rate_by_change() * turn_in(step, state, b).energy - omega.dot(turn));
  }
  return E;
}

bool BodyDamping::add_residual(const State& state, const Controls& controls, std::span<double> r,
                               Inadmissible* /*why*/) const {
  if (!controls.time_step) return true;
  const TimeStep& step = *controls.time_step;
  for (std::size_t b = 0; b < friction_.size(); ++b) {
    const Index first = model_.body_dof(to_index(b), 0);
    const double arm = model_.bodies()[b].arm();
    const Vec3 way = state.bodies[b].u - step.from.bodies[b].u;
    const Vec3 omega =
        step.rate(turn_in(step, state, b).moment, Vec3(velocity_at(step, first + 3) / arm));
    Eigen::Map<Vec3>(r.data() + first) +=
        friction_[b].translational * step.rate(way, velocity_at(step, first));
    Eigen::Map<Vec3>(r.data() + first + 3) += friction_[b].rotational * omega / arm;
  }
  return true;
}

void BodyDamping::list_stencils(const State& /*state*/, Stencils& stencils) const {
  std::array<Index, dofs_of_body> six{};
  for (std::size_t b = 0; b < friction_.size(); ++b) {
    std::iota(six.begin(), six.end(), model_.body_dof(to_index(b), 0));
    stencils.push_back(six);
  }
}

void BodyDamping::add_tangent(const State& state, const Controls& controls, TangentSink& K) const {
  if (!controls.time_step) return;
  const TimeStep& step = *controls.time_step;
  const double factor = step.rate_by_change();
  for (std::size_t b = 0; b < friction_.size(); ++b) {
    const double arm = model_.bodies()[b].arm();
    Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
    block.topLeftCorner<3, 3>() = factor * friction_[b].translational * Mat3::Identity();
    block.bottomRightCorner<3, 3>() =
        factor * friction_[b].rotational / (arm * arm) * turn_in(step, state, b).stiffness;
    K.add(b, {block.data(), 36});
  }
}

MuscleDamping::MuscleDamping(const Model& model, const HillMuscles& muscles)
    : model_(model), muscles_(muscles) {
  const std::span<const HillMuscle> all = muscles.muscles();
  for (std::size_t m = 0; m < all.size(); ++m) {
    const bool moves = !dofs_of(model_, std::array{all[m].a, all[m].b}).empty();
    if (moves && all[m].parameters.damping > 0.0) damped_.push_back(m);
  }
}

double MuscleDamping::rate(const State& state, const TimeStep& step, std::size_t m) const {
  const HillMuscle& muscle = muscles_.muscles()[m];
  const Vec3 n = line_between(model_, step.from, muscle.a, muscle.b).normalized();
  const Vec3 v = velocity_of(model_, step, muscle.a) - velocity_of(model_, step, muscle.b);
  return step.rate(muscles_.length(state, m) - muscles_.length(step.from, m), n.dot(v));
}

double MuscleDamping::energy(const State& state, const Controls& controls) const {
  if (!controls.time_step) return 0.0;
  const TimeStep& step = *controls.time_step;
  double power = 0.0;
  for (const std::size_t m : damped_) {
    const double v = rate(state, step, m);
    power += muscles_.muscles()[m].parameters.damping * v * v;
  }
  return 0.5 * power / step.rate_by_change();
}

bool MuscleDamping::add_residual(const State& state, const Controls& controls, std::span<double> r,
                                 Inadmissible* /*why*/) const {
  if (!controls.time_step) return true;
  for (const std::size_t m : damped_) {
    const HillMuscle& muscle = muscles_.muscles()[m];
    const double tension = muscle.parameters.damping * rate(state, *controls.time_step, m);
    add_tension(model_, state, muscle.a, muscle.b, tension, r);
  }
  return true;
}

void MuscleDamping::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (const std::size_t m : damped_) {
    const HillMuscle& muscle = muscles_.muscles()[m];
    stencils.push_back(dofs_of(model_, std::array{muscle.a, muscle.b}));
  }
}

void MuscleDamping::add_tangent(const State& state, const Controls& controls,
                                TangentSink& K) const {
  if (!controls.time_step) return;
  const TimeStep& step = *controls.time_step;
  for (std::size_t k = 0; k < damped_.size(); ++k) {
    const HillMuscle& muscle = muscles_.muscles()[damped_[k]];
    const double d = muscle.parameters.damping;
    const Eigen::MatrixXd block =
        tension_tangent(model_, state, muscle.a, muscle.b, d * rate(state, step, damped_[k]),
                        d * step.rate_by_change());
    K.add(k, {block.data(), static_cast<std::size_t>(block.size())});
  }
}

}  // namespace facies::mechanics
