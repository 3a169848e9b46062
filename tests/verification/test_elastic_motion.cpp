// SPDX-License-Identifier: Apache-2.0
// Tissue in motion: a rod's vibrations against closed forms, conservation, and slow motions against statics.
#include <numbers>
#include <numeric>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/motion.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/damping.hpp"

namespace facies {
namespace {

using mechanics::Inertia;
using mechanics::State;

constexpr double density = 1e-6;  // [kg/mm^3]

/// A solid that has mass and damping.
struct MovingSolid : support::SolidModel {
  MovingSolid(const mesh::Mesh& of, mechanics::SolidDescription description, double alpha,
              double beta, int threads = 1)
      : SolidModel(of, std::move(description), threads),
        mass(mechanics::lumped_mass(mesh, std::vector<double>(mesh.n_elements(), density), {})) {
    model.add(std::make_unique<mechanics::Gravity>(mass));
    model.add(std::make_unique<mechanics::RayleighDamping>(*solid, mass, alpha, beta));
    inertia = &model.add(std::make_unique<Inertia>(
        model, std::vector<Vec3>(mesh.X().begin(), mesh.X().end()), mass));
  }

  std::vector<double> mass;
  const Inertia* inertia = nullptr;
};

/// A rod along x that cannot widen, held at x = 0, free at x = L, set off in its first mode.
struct Rod {
  explicit Rod(double alpha = 0.0, double beta = 0.0)
      : solid(support::make_block({.size = {L, 1, 1}, .n = {n, 1, 1}}), description(), alpha,
              beta) {
    support::Supports supports;
    std::vector<Index> all(solid.mesh.n_nodes());
    std::iota(all.begin(), all.end(), 0);
    supports.hold(all, 1).hold(all, 2).hold(solid.mesh.nodes("x_min"), 0);
    held = supports.prescribed().dofs;
    tip = solid.mesh.nodes("x_max")[0];
  }

  /// Momenta of the first mode with this velocity at the tip.
  [[nodiscard]] std::vector<double> momentum(double velocity) const {
    std::vector<double> p(solid.model.n_dofs(), 0.0);
    for (std::size_t node = 0; node < solid.mesh.n_nodes(); ++node) {
      const double shape = std::sin(0.5 * std::numbers::pi * solid.mesh.X()[node].x() / L);
      p[3 * node] = solid.mass[node] * velocity * shape;
    }
    return p;
  }

  static mechanics::SolidDescription description() {
    const mesh::Mesh mesh = support::make_block({.size = {L, 1, 1}, .n = {n, 1, 1}});
    return support::uniform_solid(mesh, support::neo_hookean(C10), support::log_volume(kappa));
  }

  static constexpr double L = 20.0;
  static constexpr int n = 10;
  static constexpr double C10 = 3.0;
  static constexpr double kappa = 20.0;
  /// Of a chain of n springs and masses: (2 c / d) sin(pi d / 4 L), c^2 = (kappa + 4/3 mu) / density, mu = 2 C10; d = L / n.
  const double omega = 2.0 * n / L * std::sqrt((kappa + 8.0 / 3.0 * C10) / density) *
                       std::sin(0.25 * std::numbers::pi / n);
  MovingSolid solid;
  std::vector<Index> held;
  Index tip = -1;
};

TEST(Rod, VibratesAtItsFrequencyAtSecondOrderAndKeepsItsEnergy) {
  const Rod rod;
  const double v = 1e-3 * rod.omega;  // 1 um at the tip: linear
  const double t = 3.1 * 2.0 * std::numbers::pi / rod.omega;
  std::vector<double> errors;
  for (const int n : {150, 300, 600}) {
    support::Mover mover(rod.solid.model, *rod.solid.inertia, rod.held, support::fixed_steps(t / n),
                         support::constantly({}), rod.solid.model.initial_state(), rod.momentum(v));
    const double E = mover.energy();
    ASSERT_TRUE(mover.go(t).converged);
    const double u = mover.motion.state.u[at(rod.tip)].x();
    errors.push_back(std::abs(u / 1e-3 - std::sin(rod.omega * t)));
    EXPECT_NEAR(mover.energy(), E, 1e-3 * E);
  }
  EXPECT_LT(errors.back(), 2e-3);
  EXPECT_NEAR(support::order_of(errors), 2.0, 0.2);
}

TEST(Rod, LosesWhatTheMethodIsAskedToTakeAndNeverGains) {
  const Rod rod;
  double before = 1.0;
  for (const double rho : {1.0, 0.8, 0.5, 0.0}) {
    support::Mover mover(rod.solid.model, *rod.solid.inertia, rod.held,
                         support::fixed_steps(0.5 / rod.omega, rho), support::constantly({}),
                         rod.solid.model.initial_state(), rod.momentum(1e-3 * rod.omega));
    const double E = mover.energy();
    ASSERT_TRUE(mover.go(60.0 / rod.omega).converged);
    const double kept = mover.energy() / E;
    EXPECT_NEAR(mover.motion.energy.numerical, mover.energy() - E, 1e-9 * E);
    EXPECT_LT(kept, before + 1e-3) << rho;
    before = kept;
  }
  EXPECT_LT(before, 0.5);
}

TEST(RayleighDamping, GivesAModeTheRatioOfItsFormula) {
  for (const auto& [alpha, beta] : {std::pair{80.0, 0.0}, {0.0, 1e-4}, {60.0, 5e-5}}) {
    const Rod rod(alpha, beta);
    const double xi = 0.5 * (alpha / rod.omega + beta * rod.omega);
    const double damped = rod.omega * std::sqrt(1.0 - xi * xi);
    const double t = 4.0 / rod.omega;
    support::Mover mover(rod.solid.model, *rod.solid.inertia, rod.held,
                         support::fixed_steps(t / 800), support::constantly({}),
                         rod.solid.model.initial_state(), rod.momentum(1e-3 * rod.omega));
    const double E = mover.energy();
    ASSERT_TRUE(mover.go(t).converged);
    const double u = mover.motion.state.u[at(rod.tip)].x();
    const double exact =
        1e-3 * rod.omega / damped * std::exp(-xi * rod.omega * t) * std::sin(damped * t);
    EXPECT_NEAR(u, exact, 2e-6) << alpha << ' ' << beta << ' ' << xi;
    EXPECT_NEAR(mover.energy() + mover.motion.energy.dissipated, E, 2e-3 * E);
  }
}

mechanics::SolidDescription jelly(const mesh::Mesh& mesh) {
  mechanics::SolidDescription description =
      support::uniform_solid(mesh, support::neo_hookean(1.0), support::log_volume(10.0));
  description.fibres.push_back(
      support::uniform_fibres(mesh, support::example_fibre("none"), 0, Vec3::UnitX()));
  return description;
}

TEST(FreeTissue, KeepsItsMomentaWhileItTurnsAndTrembles) {
  const mesh::Mesh mesh = support::make_block({.size = {10, 4, 4}, .n = {3, 2, 2}, .shake = 0.1});
  const MovingSolid body(mesh, jelly(mesh), 0.0, 0.0);
  std::vector<double> p;
  for (std::size_t node = 0; node < mesh.n_nodes(); ++node) {
    const Vec3& X = mesh.X()[node];
    const Vec3 v = Vec3(20, -30, 10) + Vec3(2, 5, -3).cross(X) + 4.0 * Vec3(X.x(), 0, -X.z());
    for (int axis = 0; axis < 3; ++axis)
      p.push_back(body.mass[node] * v(axis));
  }
  const State start = body.model.initial_state();
  const Vec3 P = body.inertia->linear_momentum(p);
  const Vec3 L = body.inertia->angular_momentum(start, p);
  std::vector<double> drift;
  for (const double h : {2e-3, 1e-3, 5e-4}) {
    support::Mover mover(body.model, *body.inertia, {}, support::fixed_steps(h),
                         support::constantly(support::activated({0.0})), start, p);
    const double E = mover.energy();
    ASSERT_TRUE(mover.go(0.2).converged);
    const solve::Motion& m = mover.motion;
    EXPECT_LE((body.inertia->linear_momentum(m.momentum) - P).norm(), 1e-9 * P.norm());
    drift.push_back((body.inertia->angular_momentum(m.state, m.momentum) - L).norm() / L.norm());
    EXPECT_NEAR(mover.energy(), E, 0.02 * E);
  }
  EXPECT_LT(drift.back(), 1e-3);
  EXPECT_GT(support::order_of(drift), 1.5);
}

/// A block that hangs on one side and whose muscle becomes active.
struct Flexing {
  explicit Flexing(int threads)
      : mesh(support::make_block({.size = {12, 4, 3}, .n = {4, 2, 2}})),
        body(mesh, jelly(mesh), 80.0, 0.02, threads),
        held(support::Supports().clamp(mesh.nodes("x_min")).prescribed()) {}

  [[nodiscard]] static mechanics::Controls controls(double t) {
    mechanics::Controls now = support::activated({0.05 * std::min(1.0, t)});
    now.gravity = {0, 0, -9800 * 0.02 * std::min(1.0, t)};
    return now;
  }

  [[nodiscard]] solve::Motion move(const solve::TimeSettings& settings, double to) const {
    support::Mover mover(body.model, *body.inertia, held.dofs, settings, controls,
                         body.model.initial_state());
    const solve::MotionReport report = mover.go(to);
    EXPECT_TRUE(report.converged) << report.reason;
    return mover.motion;
  }

  mesh::Mesh mesh;
  MovingSolid body;
  mechanics::Prescribed held;
};

TEST(SlowMotion, EndsWhereStaticsEnds) {
  const Flexing flexing(1);
  State still = flexing.body.model.initial_state();
  for (const double t : {0.25, 0.5, 0.75, 1.0}) {
    const solve::NewtonReport report =
        solve::solve_equilibrium(flexing.body.model, still, Flexing::controls(t), flexing.held);
    ASSERT_TRUE(report.converged);
  }
  const solve::Motion moved = flexing.move({}, 4.0);
  double largest = 0.0;
  double apart = 0.0;
  for (std::size_t node = 0; node < still.u.size(); ++node) {
    largest = std::max(largest, still.u[node].norm());
    apart = std::max(apart, (still.u[node] - moved.state.u[node]).norm());
  }
  EXPECT_GT(largest, 0.5);
  EXPECT_LT(apart, 1e-4);
}

TEST(Motion, HasTheSameBitsForAnyNumberOfThreads) {
  const solve::Motion one = Flexing(1).move({}, 0.1);
  const solve::Motion three = Flexing(3).move({}, 0.1);
  EXPECT_TRUE(support::same_bits(one.state.u, three.state.u));
  EXPECT_TRUE(support::same_bits(one.momentum, three.momentum));
  EXPECT_EQ(one.energy.dissipated, three.energy.dissipated);
}

TEST(Motion, ThatFindsNoBalanceSaysWhereAndStopsBefore) {
  const Flexing flexing(1);
  solve::TimeSettings settings;
  settings.first_step = 1e-3;
  settings.smallest_step = 6e-4;
  settings.newton.max_iterations = 3;
  std::vector<double> p(flexing.body.model.n_dofs(), 0.0);
  for (const Index node : flexing.mesh.nodes("x_max"))
    p[at(mechanics::dof(node, 0))] = -1e5 * flexing.body.mass[at(node)];
  support::Mover mover(flexing.body.model, *flexing.body.inertia, flexing.held.dofs, settings,
                       Flexing::controls, flexing.body.model.initial_state(), p);
  const solve::MotionReport report = mover.go(1.0);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(report.refused_newton, 1);
  EXPECT_EQ(mover.motion.time, 0.0);
  EXPECT_NE(report.reason.find("after 3 iterations even in a step of 1.0e-03 s"), std::string::npos)
      << report.reason;
  EXPECT_GE(report.last.inadmissible.element, 0);
  EXPECT_GE(report.last.worst_node, 0);
}

}  // namespace
}  // namespace facies
