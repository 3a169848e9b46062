// SPDX-License-Identifier: Apache-2.0
// A step of a scenario: from one set of controls to another in increments that adapt themselves.
#pragma once

#include <functional>

#include "facies/solve/newton.hpp"

namespace facies::solve {

struct StepSettings {
  NewtonSettings newton;
  double first_increment = 1.0;  ///< part of the step, 0..1
  double smallest_increment = 1.0 / 32.0;
  int max_increments = 400;  ///< failed ones counted
  int stops = 1;             ///< an increment ends at every k / stops of the step, k = 1, 2, ...
};

/// How a step ended.
struct StepReport {
  bool converged = false;
  bool interrupted = false;  ///< the observer asked to stop
  double reached = 0.0;      ///< load at the last converged state, 0..1
  int increments = 0;        ///< converged ones
  int cut_backs = 0;
  int iterations = 0;
  int factorisations = 0;
  NewtonReport last;  ///< the last increment tried
  Increment last_increment;
};

/// Told the part of the step, 0..1, at which `state` has just found its equilibrium.
using StopListener = std::function<void(double part)>;

/// Drives `state` from equilibrium under `from` to equilibrium under `to`, the prescribed unknowns moving in proportion
/// from where they are to `targets` [mm]. An increment that fails is tried again with half its size; a step fails when
/// the smallest one does. The state is always the last converged one. `label` names the step for the observer, which is
/// told everything and may ask to stop. `stop_reached` hears of every stop of the settings.
[[nodiscard]] StepReport advance(Equilibrium& equilibrium, mechanics::State& state,
                                 const mechanics::Controls& from, const mechanics::Controls& to,
                                 std::span<const double> targets, const StepSettings& settings,
                                 const Increment& label, Observer& observer,
                                 const StopListener& stop_reached = {});

}  // namespace facies::solve
