// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/inertia.hpp"

#include <array>
#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "facies/base/error.hpp"
#include "facies/math/rotation.hpp"
#include "facies/mechanics/turn.hpp"

namespace facies::mechanics {

namespace {

using Map3 = Eigen::Map<Vec3>;
using ConstMap3 = Eigen::Map<const Vec3>;

ConstMap3 three(std::span<const double> v, std::size_t first) {
  return ConstMap3(v.data() + first);
}

Map3 three(std::vector<double>& v, std::size_t first) {
  return Map3(v.data() + first);
}

}  // namespace

Inertia::Inertia(const Model& model, std::vector<Vec3> X, std::vector<double> mass)
    : model_(model), X_(std::move(X)), mass_(std::move(mass)) {
  require(X_.size() == model.n_nodes() && mass_.size() == model.n_nodes(),
          "one place and one mass per node");
}

Mat3 Inertia::inertia_in_space(const State& state, std::size_t body) const {
  const RigidBody& rigid = model_.bodies()[body];
  const Mat3& R = state.bodies[body].R;
  return R * rigid.inertia * R.transpose() / (rigid.arm() * rigid.arm());
}

std::vector<double> Inertia::way(const State& from, const State& to) const {
  std::vector<double> way(model_.n_dofs());
  for (std::size_t node = 0; node < mass_.size(); ++node)
    three(way, 3 * node) = to.u[node] - from.u[node];
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    const std::size_t first = at(model_.body_dof(to_index(b), 0));
    three(way, first) = to.bodies[b].u - from.bodies[b].u;
    three(way, first + 3) =
        model_.bodies()[b].arm() * rotation_vector(to.bodies[b].R * from.bodies[b].R.transpose());
  }
  return way;
}

std::vector<double> Inertia::mass_way(const State& from, const State& to) const {
  std::vector<double> result(model_.n_dofs());
  for (std::size_t node = 0; node < mass_.size(); ++node)
    three(result, 3 * node) = mass_[node] * (to.u[node] - from.u[node]);
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    const RigidBody& body = model_.bodies()[b];
    const std::size_t first = at(model_.body_dof(to_index(b), 0));
    three(result, first) = body.mass * (to.bodies[b].u - from.bodies[b].u);
    three(result, first + 3) =
        turn_response(from.bodies[b].R, to.bodies[b].R, body.inertia).moment / body.arm();
  }
  return result;
}

double Inertia::energy(const State& state, const Controls& controls) const {
  if (!controls.time_step) return 0.0;
  const TimeStep& step = *controls.time_step;
  const std::vector<double> gone = way(step.from, state);
  double E = 0.0;
  for (std::size_t node = 0; node < mass_.size(); ++node)
    E += 0.5 * mass_[node] * three(gone, 3 * node).squaredNorm();
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    const RigidBody& body = model_.bodies()[b];
    E += 0.5 * body.mass * three(gone, at(model_.body_dof(to_index(b), 0))).squaredNorm();
    const auto turn = [&](const Mat3& R) {
      return turn_response(step.from.bodies[b].R, R, body.inertia).energy;
    };
    E += turn(state.bodies[b].R) - turn(step.from.bodies[b].R);
  }
  return step.inertia * E - std::inner_product(gone.begin(), gone.end(), step.push.begin(), 0.0);
}

bool Inertia::add_residual(const State& state, const Controls& controls, std::span<double> r,
                           Inadmissible* /*why*/) const {
  if (!controls.time_step) return true;
  const TimeStep& step = *controls.time_step;
  const std::vector<double> gone = mass_way(step.from, state);
  for (std::size_t dof = 0; dof < r.size(); ++dof)
    r[dof] += step.inertia * gone[dof] - step.push[dof];
  return true;
}

void Inertia::list_stencils(const State& /*state*/, Stencils& stencils) const {
  for (Index node = 0; node < to_index(mass_.size()); ++node)
    stencils.push_back(std::array{dof(node, 0), dof(node, 1), dof(node, 2)});
  std::array<Index, dofs_of_body> six{};
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    std::iota(six.begin(), six.end(), model_.body_dof(to_index(b), 0));
    stencils.push_back(six);
  }
}

void Inertia::add_tangent(const State& state, const Controls& controls, TangentSink& K) const {
  if (!controls.time_step) return;
  const TimeStep& step = *controls.time_step;
  for (std::size_t node = 0; node < mass_.size(); ++node) {
    const Mat3 block = step.inertia * mass_[node] * Mat3::Identity();
    K.add(node, {block.data(), 9});
  }
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    const RigidBody& body = model_.bodies()[b];
    Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
    block.topLeftCorner<3, 3>() = step.inertia * body.mass * Mat3::Identity();
    block.bottomRightCorner<3, 3>() =
        step.inertia / (body.arm() * body.arm()) *
        turn_response(step.from.bodies[b].R, state.bodies[b].R, body.inertia).stiffness;
    K.add(mass_.size() + b, {block.data(), 36});
  }
}

std::vector<double> Inertia::velocity(const State& state, std::span<const double> momentum) const {
  std::vector<double> v(model_.n_dofs(), 0.0);
  for (std::size_t node = 0; node < mass_.size(); ++node) {
    if (mass_[node] > 0.0) three(v, 3 * node) = three(momentum, 3 * node) / mass_[node];
  }
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    if (!(model_.bodies()[b].mass > 0.0)) continue;
    const std::size_t first = at(model_.body_dof(to_index(b), 0));
    three(v, first) = three(momentum, first) / model_.bodies()[b].mass;
    three(v, first + 3) = inertia_in_space(state, b).inverse() * three(momentum, first + 3);
  }
  return v;
}

std::vector<double> Inertia::acceleration(const State& state, std::span<const double> momentum,
                                          std::span<const double> rate) const {
  std::vector<double> a = velocity(state, rate);
  const std::vector<double> v = velocity(state, momentum);
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    if (!(model_.bodies()[b].mass > 0.0)) continue;
    // d(I w)/dt = I dw/dt + w x I w, in space.
    const std::size_t turning = at(model_.body_dof(to_index(b), 3));
    const Vec3 omega = three(v, turning) / model_.bodies()[b].arm();
    const Vec3 gyroscopic = omega.cross(three(momentum, turning));
    three(a, turning) -= inertia_in_space(state, b).inverse() * gyroscopic;
  }
  return a;
}

double Inertia::kinetic_energy(const State& state, std::span<const double> momentum) const {
  const std::vector<double> v = velocity(state, momentum);
  return 0.5 * std::inner_product(v.begin(), v.end(), momentum.begin(), 0.0);
}

Vec3 Inertia::linear_momentum(std::span<const double> momentum) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t node = 0; node < mass_.size(); ++node)
    sum += three(momentum, 3 * node);
  for (std::size_t b = 0; b < model_.bodies().size(); ++b)
    sum += three(momentum, at(model_.body_dof(to_index(b), 0)));
  return sum;
}

Vec3 Inertia::angular_momentum(const State& state, std::span<const double> momentum) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t node = 0; node < mass_.size(); ++node)
    sum += (X_[node] + state.u[node]).cross(three(momentum, 3 * node));
  for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
    const RigidBody& body = model_.bodies()[b];
    const std::size_t first = at(model_.body_dof(to_index(b), 0));
    sum += (body.centre + state.bodies[b].u).cross(three(momentum, first));
    sum += body.arm() * three(momentum, first + 3);
  }
  return sum;
}

}  // namespace facies::mechanics
