// SPDX-License-Identifier: Apache-2.0
// Motion in time: the implicit generalized-alpha method (Chung and Hulbert 1993), each of whose steps is an equilibrium with inertia
// and damping, and steps that adapt. Method: docs/theory/dynamics.md.
#pragma once

#include <functional>

#include "facies/mechanics/inertia.hpp"
#include "facies/solve/motion.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {

struct TimeSettings {
  NewtonSettings newton;
  /// What is left after one step of an oscillation that is much faster than the steps, 0..1. 1 takes nothing from any
  /// oscillation (the trapezoidal rule).
  double rho_inf = 0.8;
  double first_step = 1e-3;     ///< [s]
  double smallest_step = 1e-7;  ///< below which the motion is given up [s]
  double largest_step = 1e9;    ///< [s]
  double tolerance = 0.01;      ///< of the estimated error of one step at any unknown [mm]
  /// Energy that one step may add out of nothing, as a part of what is exchanged in it.
  double energy_tolerance = 0.02;
  int max_steps = 1000000;  ///< refused ones counted
};

/// How a motion, or a part of it, ended.
struct MotionReport {
  bool converged = false;
  bool interrupted = false;  ///< the observer asked to stop
  int steps = 0;             ///< accepted ones
  int refused_newton = 0;    ///< steps tried again because no balance was found,
  int refused_error = 0;     ///< because the error was too large,
  int refused_energy = 0;    ///< because energy appeared out of nothing
  int iterations = 0;
  int factorisations = 0;
  NewtonReport last;         ///< the last step tried
  Increment last_increment;  ///< it, as a part of the whole
  std::string reason;        ///< why it did not converge
};

/// Controls at a time [s]; continuous. Their time_step is not looked at.
using ControlsInTime = std::function<mechanics::Controls(double)>;

/// Moves one model with one set of held unknowns. Everything free has mass.
class TimeStepper {
 public:
  /// Both must outlive this; `inertia` is a term of the model of `equilibrium`.
  TimeStepper(Equilibrium& equilibrium, const mechanics::Inertia& inertia,
              const TimeSettings& settings);

  /// A motion that begins at `time` from this state with these momenta [n_dofs] (empty: at rest) and controls. The state is
  /// admissible.
  [[nodiscard]] Motion begin(double time, const mechanics::State& state,
                             const ControlsInTime& controls,
                             std::vector<double> momentum = {}) const;

  /// Moves on to time `to`, in steps that go on with the size that the last call ended with; the motion is always at the last
  /// accepted step. `label` names the step of the scenario for the observer, of which this motion is the part from
  /// label.from to label.to.
  [[nodiscard]] MotionReport advance(Motion& motion, double to, const ControlsInTime& controls,
                                     const Increment& label, Observer& observer);

 private:
  struct Attempt;

  [[nodiscard]] std::shared_ptr<mechanics::TimeStep> make_step(
      const Motion& motion, double h, const mechanics::Controls& before) const;
  [[nodiscard]] Attempt attempt(const Motion& motion, double h, const ControlsInTime& controls,
                                const std::function<void(const Iteration&)>& listen);
  void finish(Attempt& attempt, const Motion& before, const mechanics::Controls& controls_before,
              const mechanics::Controls& controls_after) const;
  void balance(Attempt& attempt, const Motion& before, const mechanics::Controls& controls_before,
               const mechanics::Controls& controls_after) const;
  [[nodiscard]] double error_of(const Attempt& attempt, const Motion& before) const;
  [[nodiscard]] double next_size(const Attempt& attempt, double h, MotionReport& report) const;
  void clear_held(std::vector<double>& v) const;

  Equilibrium& equilibrium_;
  const mechanics::Inertia& inertia_;
  TimeSettings settings_;
  double alpha_m_, alpha_f_, beta_, gamma_;  // Chung and Hulbert 1993, Eqs. 17, 20, 25
  double size_;                              // of the next step [s]
};

}  // namespace facies::solve
