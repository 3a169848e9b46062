// SPDX-License-Identifier: Apache-2.0
// What inertia and damping say in a time step: derivatives of their potentials, nothing in statics, energies of motions.
#include <functional>
#include <ostream>

#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/math/rotation.hpp"
#include "facies/mechanics/damping.hpp"
#include "facies/mechanics/inertia.hpp"
#include "facies/mechanics/turn.hpp"

namespace facies::mechanics {
namespace {

const Vec3 three_moments(150.0, 250.0, 290.0);

TEST(Turn, OfASmallAngleIsInertiaTimesAngle) {
  const Mat3 R0 = support::Random(2).rotation();
  const Mat3 I = three_moments.asDiagonal();
  const Vec3 w(1e-5, -2e-5, 3e-5);
  const TurnResponse turn = turn_response(R0, rotation_matrix(w) * R0, I);
  const Mat3 in_space = R0 * I * R0.transpose();
  EXPECT_NEAR((turn.moment - in_space * w).norm(), 0.0, 1e-6);
  EXPECT_NEAR((turn.stiffness - in_space).norm(), 0.0, 1e-1);
  EXPECT_NEAR(turn.energy - turn_response(R0, R0, I).energy, 0.5 * w.dot(in_space * w), 1e-10);
}

TEST(Turn, ForthAndBackHasOppositeMoments) {
  support::Random random(4);
  const Mat3 a = random.rotation();
  const Mat3 b = random.rotation();
  const Mat3 I = three_moments.asDiagonal();
  const Vec3 sum = turn_response(a, b, I).moment + turn_response(b, a, I).moment;
  EXPECT_NEAR(sum.norm(), 0.0, 1e-10);
}

/// Three nodes of a model with a block, a body and a muscle between them, in the middle of a step.
class InAStep : public ::testing::Test {
 protected:
  void add(std::unique_ptr<Term> term) { model_.add(std::move(term)); }

  void begin() {
    support::Random random(12);
    const auto step = std::make_shared<TimeStep>();
    step->h = 0.1;
    step->inertia = 300.0;
    step->from = model_.initial_state();
    step->from.bodies[0].R = random.rotation();
    state_ = step->from;
    for (Vec3& u : state_.u)
      u = random.vector(-0.1, 0.1);
    state_.bodies[0] = moved(state_.bodies[0], {1, 2, 3}, {0.3, -0.2, 0.4});
    for (std::size_t dof = 0; dof < model_.n_dofs(); ++dof) {
      // What pushes or has turned a body from the beginning has no potential.
      const bool turns = dof >= 3 * model_.n_nodes() + 3;
      step->push.push_back(turns ? 0.0 : random.uniform(-1, 1));
      step->velocity.push_back(turns && !keep_turning_ ? 0.0 : random.uniform(-9, 9));
    }
    controls_.activation = {0.3};
    for (const auto& term : model_.terms())
      term->begin(controls_, *step);
    controls_.time_step = step;
  }

  void check_derivatives() const {
    const Eigen::VectorXd r = support::residual(model_, state_, controls_);
    const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
    EXPECT_GT(support::norm_of(r), 1e-3);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Eigen::VectorXd d = 0.1 * support::random_direction(model_.n_dofs(), seed);
      const auto moved = [&](double h) {
        return model_.moved(state_, {d.data(), static_cast<std::size_t>(d.size())}, h);
      };
      const auto E = [&](double h) { return model_.energy(moved(h), controls_); };
      EXPECT_GE(support::remainder_slope(E, support::inner_product(r, d)), 1.9);
      const auto dE = [&](double h) {
        return support::inner_product(support::residual(model_, moved(h), controls_), d);
      };
      const Eigen::VectorXd Kd = K * d;
      EXPECT_GE(support::remainder_slope(dE, support::inner_product(d, Kd)), 1.9);
    }
  }

  void check_silent_in_statics() {
    controls_.time_step.reset();
    EXPECT_EQ(model_.energy(state_, controls_), 0.0);
    EXPECT_EQ(support::norm_of(support::residual(model_, state_, controls_)), 0.0);
    EXPECT_EQ(support::norm_of(support::dense_tangent(model_, state_, controls_)), 0.0);
  }

  mesh::Mesh mesh_ = support::make_block({.n = {1, 1, 1}});
  Model model_{mesh_.n_nodes(), {{"stone", {5, 6, 7}, 0.3, Mat3(three_moments.asDiagonal())}}};
  bool keep_turning_ = false;
  State state_;
  Controls controls_;
};

TEST_F(InAStep, InertiaHasTheDerivativesOfItsPotential) {
  add(std::make_unique<Inertia>(model_, std::vector<Vec3>(mesh_.X().begin(), mesh_.X().end()),
                                std::vector<double>(mesh_.n_nodes(), 0.2)));
  begin();
  check_derivatives();
  check_silent_in_statics();
}

TEST_F(InAStep, FrictionOfABodyHasTheDerivativesOfItsPotential) {
  add(std::make_unique<BodyDamping>(model_, std::vector<BodyFriction>{{20.0, 200.0}}));
  begin();
  check_derivatives();
  check_silent_in_statics();
}

TEST_F(InAStep, ViscosityOfMusclesHasTheDerivativesOfItsPotential) {
  const HillParameters oily{1e3, 5.0, 9.0, 0.1, 0.5, 3.0};
  const HillMuscles muscles(
      model_, {{"free", Anchor::on_node(0, {0, 0, 0}), Anchor::on_body(0, {4, 4, 4}), oily},
               {"fixed", Anchor::in_space({0, 0, 0}), Anchor::in_space({4, 4, 4}), oily},
               {"held", Anchor::in_space({0, 0, 0}), Anchor::on_node(7, {1, 1, 1}), oily}});
  add(std::make_unique<MuscleDamping>(model_, muscles));
  keep_turning_ = true;
  begin();
  check_derivatives();
  check_silent_in_statics();
}

TEST_F(InAStep, RayleighDampingHasTheDerivativesOfItsPotential) {
  mechanics::SolidDescription description =
      support::uniform_solid(mesh_, support::neo_hookean(1.0), support::log_volume(10.0));
  description.fibres.push_back(
      support::uniform_fibres(mesh_, support::example_fibre("none"), 0, Vec3::UnitX()));
  const Solid solid(mesh_, std::move(description), 1);
  add(std::make_unique<RayleighDamping>(solid, std::vector<double>(mesh_.n_nodes(), 0.2), 80.0,
                                        0.02));
  begin();
  check_derivatives();
  const std::vector<double> eigenvalues =
      support::symmetric_eigenvalues(support::dense_tangent(model_, state_, controls_));
  EXPECT_GE(eigenvalues.front(), -1e-9);
  check_silent_in_statics();
}

TEST(Inertia, TellsEnergyAndMomentaOfARigidMotion) {
  const Model model(2, {{"stone", {5, 6, 7}, 0.3, Mat3(three_moments.asDiagonal())}});
  const std::vector<Vec3> X = {{1, 2, 3}, {4, 0, -1}};
  const Inertia inertia(model, X, {0.1, 0.2});
  State state = model.initial_state();
  const Mat3 R = support::Random(8).rotation();
  state.bodies[0].R = R;
  state.u = {Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Vec3 v(3, -2, 1);
  const Vec3 omega(0.3, 0.2, -0.4);
  const Mat3 I = R * three_moments.asDiagonal() * R.transpose();
  const std::array<Vec3, 3> x = {Vec3(2, 2, 3), Vec3(4, 1, -1), Vec3(5, 6, 7)};
  const std::array<double, 3> m = {0.1, 0.2, 0.3};
  std::vector<double> p;
  double E = 0.5 * omega.dot(I * omega);
  Vec3 P = Vec3::Zero();
  Vec3 L = I * omega;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 velocity = v + omega.cross(x[k]);
    E += 0.5 * m[k] * velocity.squaredNorm();
    P += m[k] * velocity;
    L += m[k] * x[k].cross(velocity);
    for (int axis = 0; axis < 3; ++axis)
      p.push_back(m[k] * velocity(axis));
  }
  for (int axis = 0; axis < 3; ++axis)
    p.push_back(Vec3(I * omega)(axis) / model.bodies()[0].arm());
  EXPECT_NEAR(inertia.kinetic_energy(state, p), E, 1e-12 * E);
  EXPECT_NEAR((inertia.linear_momentum(p) - P).norm(), 0.0, 1e-12);
  EXPECT_NEAR((inertia.angular_momentum(state, p) - L).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace facies::mechanics
