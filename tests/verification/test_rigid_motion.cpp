// SPDX-License-Identifier: Apache-2.0
// Bodies and points in motion against Euler's equations, Newton's parabola and the pendulum's differential equation.
#include "support/models.hpp"
#include "support/motion.hpp"
#include "support/session.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/mechanics/contact.hpp"
#include "facies/mechanics/damping.hpp"

namespace facies {
namespace {

using mechanics::Anchor;
using mechanics::Controls;
using mechanics::Inertia;
using mechanics::Model;
using mechanics::State;

/// A body without any force, turning fast about its middle axis: it tumbles.
class Tumbling : public ::testing::Test {
 protected:
  Tumbling() : inertia_(model_.add(std::make_unique<Inertia>(model_, none_, mass_))) {
    state_ = model_.initial_state();
    state_.bodies[0].R = support::Random(3).rotation();
  }

  [[nodiscard]] Mat3 inertia_in_space() const {
    const Mat3& R = state_.bodies[0].R;
    return R * model_.bodies()[0].inertia * R.transpose();
  }

  [[nodiscard]] std::vector<double> momentum() const {
    const Vec3 L = inertia_in_space() * state_.bodies[0].R * omega_;
    const double arm = model_.bodies()[0].arm();
    return {3.0, -2.0, 1.0, L.x() / arm, L.y() / arm, L.z() / arm};
  }

  /// Euler's equations in the body's axes, and the rotation that follows from them.
  [[nodiscard]] Mat3 exact(double t) const {
    const Vec3 I = model_.bodies()[0].inertia.diagonal();
    const auto f = [&](double, const Eigen::VectorXd& y) {
      const Vec3 w = Eigen::Map<const Vec3>(y.data() + 9);
      const Mat3 R = Eigen::Map<const Mat3>(y.data());
      Mat3 W;
      W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
      Eigen::VectorXd dy(12);
      Eigen::Map<Mat3>(dy.data()) = R * W;
      Eigen::Map<Vec3>(dy.data() + 9) = Vec3(I.cwiseProduct(w)).cross(w).cwiseQuotient(I);
      return dy;
    };
    Eigen::VectorXd y(12);
    Eigen::Map<Mat3>(y.data()) = state_.bodies[0].R;
    Eigen::Map<Vec3>(y.data() + 9) = omega_;
    const Eigen::VectorXd end = support::runge_kutta(f, y, t, 20000);
    return Eigen::Map<const Mat3>(end.data());
  }

  std::vector<Vec3> none_;
  std::vector<double> mass_;
  Vec3 omega_{0.05, 6.0, 0.02};  // in the body's axes [rad/s]
  Model model_{0, {{"stone", {1, 2, 3}, 0.2, Vec3(150.0, 250.0, 290.0).asDiagonal()}}};
  const Inertia& inertia_;
  State state_;
};

TEST_F(Tumbling, FollowsEulersEquationsAtSecondOrder) {
  const double t = 3.0;  // it turns over within
  const Mat3 R = exact(t);
  std::vector<double> errors;
  for (const int n : {300, 600, 1200}) {
    support::Mover mover(model_, inertia_, {}, support::fixed_steps(t / n), support::constantly({}),
                         state_, momentum());
    ASSERT_TRUE(mover.go(t).converged);
    EXPECT_EQ(mover.motion.time, t);
    errors.push_back((mover.motion.state.bodies[0].R - R).norm());
    EXPECT_NEAR((mover.motion.state.bodies[0].u - t * Vec3(15, -10, 5)).norm(), 0.0, 1e-9);
  }
  EXPECT_LT(errors.back(), 0.01);
  EXPECT_NEAR(support::order_of(errors), 2.0, 0.15);
}

TEST_F(Tumbling, KeepsItsMomentaAndForgetsNoEnergy) {
  support::Mover mover(model_, inertia_, {}, support::fixed_steps(0.01), support::constantly({}),
                       state_, momentum());
  const std::vector<double> p = momentum();
  const Vec3 P = inertia_.linear_momentum(p);
  const Vec3 L = inertia_.angular_momentum(state_, p);
  const double E = mover.energy();
  double least = E;
  double most = E;
  for (int k = 1; k <= 40; ++k) {
    ASSERT_TRUE(mover.go(0.5 * k).converged);
    least = std::min(least, mover.energy());
    most = std::max(most, mover.energy());
    const solve::Motion& m = mover.motion;
    EXPECT_LE((inertia_.linear_momentum(m.momentum) - P).norm(), 1e-10 * P.norm());
    EXPECT_LE((inertia_.angular_momentum(m.state, m.momentum) - L).norm(), 1e-10 * L.norm());
  }
  EXPECT_LT(most - least, 1e-3 * E) << "oscillates with the square of the step, without drift";
}

TEST_F(Tumbling, IsResolvedByStepsThatAdapt) {
  solve::TimeSettings settings;
  settings.rho_inf = 1.0;
  settings.tolerance = 2e-5;
  settings.newton.relative_tolerance = 1e-10;
  support::Mover mover(model_, inertia_, {}, settings, support::constantly({}), state_, momentum());
  const solve::MotionReport report = mover.go(3.0);
  ASSERT_TRUE(report.converged);
  EXPECT_GT(report.steps, 30);
  EXPECT_LT(report.steps, 3000);
  EXPECT_LT((mover.motion.state.bodies[0].R - exact(3.0)).norm(), 0.05);
}

TEST(FallingBodies, FollowParabolasExactlyInStepsOfAnySize) {
  Model model(1, {{"stone", {0, 0, 0}, 0.3, Mat3::Identity()}});
  model.add(std::make_unique<mechanics::Gravity>(std::vector<double>{0.1}, model.bodies()));
  const Inertia& inertia = model.add(
      std::make_unique<Inertia>(model, std::vector<Vec3>{Vec3::Zero()}, std::vector<double>{0.1}));
  Controls weight;
  weight.gravity = weight.body_gravity = {0, 0, -9800};
  for (const double rho : {1.0, 0.8, 0.0}) {
    support::Mover mover(model, inertia, {}, support::fixed_steps(0.07, rho),
                         support::constantly(weight), model.initial_state(),
                         {5, 0, 0, 30, 0, 60, 0, 0, 0});
    ASSERT_TRUE(mover.go(0.5).converged);
    const Vec3 fallen(0, 0, -0.5 * 9800 * 0.25);
    EXPECT_LE((mover.motion.state.u[0] - fallen - Vec3(25, 0, 0)).norm(), 1e-9);
    EXPECT_LE((mover.motion.state.bodies[0].u - fallen - Vec3(50, 0, 100)).norm(), 1e-9);
    EXPECT_NEAR(mover.motion.energy.numerical, 0.0, 1e-6);
  }
}

TEST(PendulumMuscle, FollowsItsDifferentialEquationAtSecondOrder) {
  const mechanics::HillParameters parameters{5e3, 50.0, 70.0, 0.3, 0.5, 0.2};
  const double m = 0.05;
  const Vec3 X(0, 30, -40);
  Model model(1);
  const auto& muscles = model.add(std::make_unique<mechanics::HillMuscles>(
      model, std::vector<mechanics::HillMuscle>{
                 {"m", Anchor::in_space({0, 0, 0}), Anchor::on_node(0, X), parameters}}));
  model.add(std::make_unique<mechanics::MuscleDamping>(model, muscles));
  model.add(std::make_unique<mechanics::Gravity>(std::vector<double>{m}));
  const Inertia& inertia =
      model.add(std::make_unique<Inertia>(model, std::vector<Vec3>{X}, std::vector<double>{m}));
  const auto controls = [](double t) {
    Controls now;
    now.gravity = {0, 0, -9800};
    now.excitation = {0.3 + 0.2 * std::sin(20.0 * t)};
    return now;
  };
  const auto f = [&](double t, const Eigen::VectorXd& y) {
    const Vec3 x = Eigen::Map<const Vec3>(y.data());
    const Vec3 v = Eigen::Map<const Vec3>(y.data() + 3);
    const double l = x.norm();
    const double tension = mechanics::hill_force(parameters, l, controls(t).excitation[0]).force +
                           parameters.damping * x.dot(v) / l;
    Eigen::VectorXd dy(6);
    Eigen::Map<Vec3>(dy.data()) = v;
    Eigen::Map<Vec3>(dy.data() + 3) = controls(t).gravity - tension / (m * l) * x;
    return dy;
  };
  Eigen::VectorXd start(6);
  Eigen::Map<Vec3>(start.data()) = X;
  Eigen::Map<Vec3>(start.data() + 3) = Vec3(100, 0, 0);
  const double t = 0.4;
  const Eigen::VectorXd end = support::runge_kutta(f, start, t, 20000);
  for (const double rho : {1.0, 0.6}) {
    std::vector<double> errors;
    for (const int n : {200, 400, 800}) {
      support::Mover mover(model, inertia, {}, support::fixed_steps(t / n, rho), controls,
                           model.initial_state(), {100 * m, 0, 0});
      ASSERT_TRUE(mover.go(t).converged);
      errors.push_back((X + mover.motion.state.u[0] - Eigen::Map<const Vec3>(end.data())).norm());
      EXPECT_GT(mover.motion.energy.dissipated, 1.0);
    }
    EXPECT_LT(errors.back(), 0.05) << rho;
    EXPECT_NEAR(support::order_of(errors), 2.0, 0.2) << rho;
  }
}

TEST(BodyFriction, SlowsABodyExponentially) {
  Model model(0, {{"stone", {0, 0, 0}, 0.2, 250.0 * Mat3::Identity()}});
  model.add(std::make_unique<mechanics::BodyDamping>(
      model, std::vector<mechanics::BodyFriction>{{20.0 * 0.1, 200.0}}));
  const Inertia& inertia =
      model.add(std::make_unique<Inertia>(model, std::vector<Vec3>{}, std::vector<double>{}));
  const double arm = model.bodies()[0].arm();
  support::Mover mover(model, inertia, {}, support::fixed_steps(1e-3), support::constantly({}),
                       model.initial_state(), {2.0, 0, 0, 0, 0, 250.0 * 3.0 / arm});
  ASSERT_TRUE(mover.go(0.5).converged);
  EXPECT_NEAR(mover.motion.momentum[0], 2.0 * std::exp(-10.0 * 0.5), 2e-5);
  EXPECT_NEAR(mover.motion.momentum[5] * arm, 750.0 * std::exp(-0.8 * 0.5), 2e-4);
  const solve::EnergyBooks& books = mover.motion.energy;
  EXPECT_NEAR(books.dissipated + books.kinetic, 0.5 * 4.0 / 0.2 + 0.5 * 250.0 * 9.0, 1e-3);
}

/// A node on a plane of bone that falls towards -x.
class InclinedPlane : public ::testing::TestWithParam<double> {};

TEST_P(InclinedPlane, LetsAPointSlideWithoutFrictionAndGainNoEnergy) {
  const double slope = 0.5;
  const Vec3 down(-std::cos(slope), 0, -std::sin(slope));
  const Vec3 normal(-std::sin(slope), 0, std::cos(slope));
  const Vec3 X = 0.4 * normal + Vec3(0.1, 0.2, 0.0);
  const double m = 1e-4;
  Model model(1);
  mechanics::ContactSurface bone{"bone", {}, {{0, 1, 2}, {1, 3, 2}}};
  for (const auto& [along, across] : {std::pair{-100, -200}, {100, -200}, {-100, 200}, {100, 200}})
    bone.vertices.push_back(Anchor::in_space(-along * down + Vec3(0, across, 0)));
  model.add(std::make_unique<mechanics::Contact>(
      model, std::vector<mechanics::ContactPoint>{{Anchor::on_node(0, X), 1.0}}, bone,
      mechanics::ContactSettings{.d_hat = 0.5, .stiffness = 100.0}));
  model.add(std::make_unique<mechanics::Gravity>(std::vector<double>{m}));
  const Inertia& inertia =
      model.add(std::make_unique<Inertia>(model, std::vector<Vec3>{X}, std::vector<double>{m}));
  Controls weight;
  weight.gravity = {0, 0, -9800};
  solve::TimeSettings settings;
  settings.rho_inf = GetParam();
  support::Mover mover(model, inertia, {}, settings, support::constantly(weight),
                       model.initial_state());
  const double E = mover.energy();
  const double exchanged = m * 9800 * std::sin(slope) * 0.5 * 9800 * std::sin(slope) * 0.01;
  for (int k = 1; k <= 10; ++k) {
    const double t = 0.01 * k;
    ASSERT_TRUE(mover.go(t).converged);
    const Vec3 x = X + mover.motion.state.u[0];
    EXPECT_GT(x.dot(normal), 0.0);
    EXPECT_NEAR((x - X).dot(down), 0.5 * 9800 * std::sin(slope) * t * t, 1e-3);
    EXPECT_LE(mover.energy() - E, 0.01 * exchanged);
  }
}

INSTANTIATE_TEST_SUITE_P(Rho, InclinedPlane, ::testing::Values(1.0, 0.8, 0.3));

}  // namespace
}  // namespace facies
