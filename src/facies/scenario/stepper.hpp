// SPDX-License-Identifier: Apache-2.0
// Carries out the steps of a scenario on a model: what each verb holds, drives and releases.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "facies/scenario/build_model.hpp"
#include "facies/solve/motion.hpp"
#include "facies/solve/step.hpp"

namespace facies::scenario {

/// Settings of the solution procedure from what the scenario says.
[[nodiscard]] solve::StepSettings step_settings(const SolverChoice& choice);

/// Told the part of a step, 0..1, at which a frame has been reached.
using FrameListener = std::function<void(double part)>;

/// A face on its way through the steps. State and controls are those of the last converged increment.
class Stepper {
 public:
  /// Both must outlive the stepper. Needs a solve::Session.
  Stepper(const FaceModel& model, const Scenario& scenario);

  /// Carries out step `number` (from 1). Where the scenario asks for frames, `frame_reached` hears of each in steps that
  /// express something or open the jaw, and always in steps that move in time: of part 0, where they begin, and of equal parts
  /// up to 1. State and controls are then those of the frame.
  [[nodiscard]] solve::StepReport take(int number, solve::Observer& observer,
                                       const FrameListener& frame_reached = {});

  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] const mechanics::Controls& controls() const { return controls_; }
  /// Seconds that the move steps so far have taken.
  [[nodiscard]] double time() const { return time_; }

 private:
  [[nodiscard]] solve::StepReport tension(const solve::Increment& label, solve::Observer& observer);
  [[nodiscard]] solve::StepReport release(const solve::Increment& label, solve::Observer& observer);
  [[nodiscard]] solve::StepReport express(const ExpressStep& step, const solve::Increment& label,
                                          solve::Observer& observer,
                                          const FrameListener& frame_reached);
  [[nodiscard]] solve::StepReport open_jaw(const OpenJawStep& step, const solve::Increment& label,
                                           solve::Observer& observer,
                                           const FrameListener& frame_reached);
  [[nodiscard]] solve::StepReport move(const MoveStep& step, const solve::Increment& label,
                                       solve::Observer& observer,
                                       const FrameListener& frame_reached);
  [[nodiscard]] solve::StepReport move_quasi_statically(const MoveStep& step,
                                                        const solve::Increment& label,
                                                        solve::Observer& observer,
                                                        const FrameListener& frame_reached);
  [[nodiscard]] solve::StepReport drive(mechanics::Controls from, const mechanics::Controls& to,
                                        const solve::Increment& label, solve::Observer& observer,
                                        int parts = 1, const FrameListener& frame_reached = {});
  [[nodiscard]] solve::StepReport let_go(const mechanics::Controls& to,
                                         const solve::Increment& label, solve::Observer& observer);
  [[nodiscard]] std::vector<Vec3> holding_forces() const;
  void hold(const std::vector<Index>& unknowns);

  const FaceModel& model_;
  const Scenario& scenario_;
  mechanics::State state_;
  mechanics::Controls controls_;
  double time_ = 0.0;
  std::unique_ptr<solve::Equilibrium> equilibrium_;
};

}  // namespace facies::scenario
