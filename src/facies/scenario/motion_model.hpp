// SPDX-License-Identifier: Apache-2.0
// What a model needs to move in time, and what drives it there.
#pragma once

#include "facies/scenario/build_model.hpp"
#include "facies/solve/time_stepper.hpp"

namespace facies::scenario {

/// Adds inertia and damping to a model that is complete otherwise. `mass` [n_nodes] [kg].
void add_dynamics(FaceModel& built, const DynamicsChoice& choice, std::vector<double> mass);

/// Whether a step of the scenario moves by its dynamics.
[[nodiscard]] bool has_dynamics(const Scenario& scenario);

[[nodiscard]] solve::TimeSettings time_settings(const Scenario& scenario);

/// Part of a move step over which everything goes from where it was to where the curves are: controls have no jumps.
inline constexpr double onset = 0.1;

/// Controls `time` [s] after the beginning of the step, which began at `before`. What has no curve stays as it was.
[[nodiscard]] mechanics::Controls controls_in_move(const FaceModel& model, const MoveStep& step,
                                                   const Vec3& gravity,
                                                   const mechanics::Controls& before, double time);

}  // namespace facies::scenario
