// SPDX-License-Identifier: Apache-2.0
// Motions for tests: steps of one size, and Runge and Kutta's method as the independent answer.
#pragma once

#include <cmath>
#include <vector>

#include "facies/solve/time_stepper.hpp"

namespace facies::support {

/// Steps of one size [s] whatever their error, solved to rounding.
inline solve::TimeSettings fixed_steps(double h, double rho_inf = 1.0) {
  solve::TimeSettings settings;
  settings.newton.relative_tolerance = 1e-13;
  settings.newton.absolute_tolerance = 1e-11;
  settings.rho_inf = rho_inf;
  settings.first_step = settings.largest_step = h;
  settings.tolerance = settings.energy_tolerance = 1e99;
  return settings;
}

inline solve::ControlsInTime constantly(mechanics::Controls controls) {
  return [controls](double) { return controls; };
}

/// A motion with everything that it needs to go on.
struct Mover {
  Mover(const mechanics::Model& model, const mechanics::Inertia& mass, std::vector<Index> held,
        const solve::TimeSettings& settings, solve::ControlsInTime drive,
        const mechanics::State& state, std::vector<double> momentum = {})
      : inertia(mass),
        equilibrium(model, std::move(held)),
        stepper(equilibrium, mass, settings),
        controls(std::move(drive)),
        motion(stepper.begin(0.0, state, controls, std::move(momentum))) {}

  solve::MotionReport go(double to) {
    solve::Observer nobody;
    return stepper.advance(motion, to, controls, {}, nobody);
  }
  [[nodiscard]] double energy() const { return motion.energy.kinetic + motion.energy.potential; }

  const mechanics::Inertia& inertia;
  solve::Equilibrium equilibrium;
  solve::TimeStepper stepper;
  solve::ControlsInTime controls;
  solve::Motion motion;
};

/// y(t_end) of dy/dt = f(t, y) in n steps of the classical fourth-order method.
template <class F>
Eigen::VectorXd runge_kutta(const F& f, Eigen::VectorXd y, double t_end, int n) {
  const double h = t_end / n;
  for (int k = 0; k < n; ++k) {
    const double t = k * h;
    const Eigen::VectorXd a = f(t, y);
    const Eigen::VectorXd b = f(t + 0.5 * h, Eigen::VectorXd(y + 0.5 * h * a));
    const Eigen::VectorXd c = f(t + 0.5 * h, Eigen::VectorXd(y + 0.5 * h * b));
    const Eigen::VectorXd d = f(t + h, Eigen::VectorXd(y + h * c));
    y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return y;
}

/// The order at which errors fall from one step size to half of it, from the last two of a list.
inline double order_of(const std::vector<double>& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

}  // namespace facies::support
