// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "facies/scenario/motion_model.hpp"

namespace facies::scenario {

solve::StepSettings step_settings(const SolverChoice& choice) {
  solve::StepSettings settings;
  settings.newton.relative_tolerance = choice.relative_tolerance;
  settings.newton.max_iterations = choice.max_iterations;
  settings.max_increments = choice.max_increments;
  settings.first_increment = choice.first_increment;
  settings.smallest_increment = choice.smallest_increment;
  return settings;
}

Stepper::Stepper(const FaceModel& model, const Scenario& scenario)
    : model_(model), scenario_(scenario), state_(model.initial) {
  controls_.activation.assign(model.muscles.size(), 0.0);
  controls_.body_gravity = scenario.gravity.vector();
}

/// From now on these unknowns stay where they are.
void Stepper::hold(const std::vector<Index>& unknowns) {
  const bool same = equilibrium_ && std::ranges::equal(equilibrium_->prescribed(), unknowns);
  if (!same) equilibrium_ = std::make_unique<solve::Equilibrium>(model_.model, unknowns);
}

namespace {

/// The least multiple of the frames that is no less than the parts.
int stops_for(int parts, int frames) {
  return frames == 0 ? parts : frames * ((parts + frames - 1) / frames);
}

bool is_whole(double x) {
  return std::abs(x - std::round(x)) < 1e-9;
}

}  // namespace

/// `from` is a copy: the present controls, which it usually is, change on the way.
solve::StepReport Stepper::drive(mechanics::Controls from, const mechanics::Controls& to,
                                 const solve::Increment& label, solve::Observer& observer,
                                 int parts, const FrameListener& frame_reached) {
  const int frames = frame_reached ? scenario_.output.frames : 0;
  if (frames > 0) frame_reached(0.0);
  std::vector<double> places;
  places.reserve(equilibrium_->prescribed().size());
  for (const Index dof : equilibrium_->prescribed())
    places.push_back(model_.model.value_of(state_, dof));
  solve::StepSettings settings = step_settings(scenario_.solver);
  settings.stops = stops_for(parts, frames);
  const auto at_stop = [&](double part) {
    controls_ = mechanics::interpolate(from, to, part);
    if (frames > 0 && is_whole(frames * part)) frame_reached(part);
  };
  solve::StepReport report =
      solve::advance(*equilibrium_, state_, from, to, places, settings, label, observer, at_stop);
  controls_ = mechanics::interpolate(from, to, report.reached);
  return report;
}

/// The forces that would keep every free node where it is.
std::vector<Vec3> Stepper::holding_forces() const {
  std::vector<double> r(model_.model.n_dofs());
  const bool admissible = model_.model.residual(state_, controls_, r);
  require(admissible, "a converged state is admissible");
  for (const Index dof : equilibrium_->prescribed())
    r[at(dof)] = 0.0;
  std::vector<Vec3> forces;
  for (std::size_t node = 0; node < model_.model.n_nodes(); ++node) {
    forces.emplace_back(r[3 * node], r[3 * node + 1], r[3 * node + 2]);
  }
  return forces;
}

/// The mesh as read is the stress-free face stretched by the pre-stretch, every node at its place in the file. Held
/// nodes stay there; the forces that keep the others there are taken away: the end of the paper's first step.
solve::StepReport Stepper::tension(const solve::Increment& label, solve::Observer& observer) {
  hold(model_.held_in_tension);
  return let_go(controls_, label, observer);
}

/// What held the nodes that become free is first put on as forces, then taken away.
solve::StepReport Stepper::release(const solve::Increment& label, solve::Observer& observer) {
  hold(model_.held_after_release);
  mechanics::Controls to = controls_;
  if (scenario_.gravity.from == "release") to.gravity = scenario_.gravity.vector();
  return let_go(to, label, observer);
}

solve::StepReport Stepper::let_go(const mechanics::Controls& to, const solve::Increment& label,
                                  solve::Observer& observer) {
  mechanics::Controls from = controls_;
  from.nodal_force = holding_forces();
  solve::StepReport report = drive(from, to, label, observer);
  if (report.converged) controls_.nodal_force.clear();
  return report;
}

solve::StepReport Stepper::express(const ExpressStep& step, const solve::Increment& label,
                                   solve::Observer& observer, const FrameListener& frame_reached) {
  if (!equilibrium_) hold(model_.held_after_release);
  mechanics::Controls to = controls_;
  to.gravity = scenario_.gravity.vector();
  for (std::size_t m = 0; m < model_.muscles.size(); ++m) {
    to.activation[m] = activation_of(step, model_.muscles[m].name, model_.muscles[m].group);
  }
  return drive(controls_, to, label, observer, scenario_.solver.parts, frame_reached);
}

solve::StepReport Stepper::open_jaw(const OpenJawStep& step, const solve::Increment& label,
                                    solve::Observer& observer, const FrameListener& frame_reached) {
  if (!equilibrium_) hold(model_.held_after_release);
  mechanics::Controls to = controls_;
  to.gravity = scenario_.gravity.vector();
  require(model_.face.jaw.has_value(), "names on the face have been checked");
  to.excitation = excite(*model_.face.jaw, step.excitations, controls_.excitation);
  return drive(controls_, to, label, observer, scenario_.solver.parts, frame_reached);
}

namespace {

/// The part of a step that leads to frame `number` of `n`; increments are counted on.
solve::Increment part_of(const solve::Increment& label, int number, int n, int tries) {
  solve::Increment part = label;
  part.from = static_cast<double>(number - 1) / n;
  part.to = static_cast<double>(number) / n;
  part.number = tries;
  return part;
}

}  // namespace

solve::StepReport Stepper::move(const MoveStep& step, const solve::Increment& label,
                                solve::Observer& observer, const FrameListener& frame_reached) {
  if (!equilibrium_) hold(model_.held_after_release);
  if (frame_reached) frame_reached(0.0);
  if (step.method == "quasi_static")
    return move_quasi_statically(step, label, observer, frame_reached);
  require(model_.inertia != nullptr, "a model that moves has mass");
  const double begin = time_;
  const mechanics::Controls before = controls_;
  const auto controls = [&](double time) {
    return controls_in_move(model_, step, scenario_.gravity.vector(), before, time - begin);
  };
  solve::TimeStepper stepper(*equilibrium_, *model_.inertia, time_settings(scenario_));
  solve::Motion motion = stepper.begin(begin, state_, controls);
  solve::StepReport report;
  for (int k = 1; k <= step.frames; ++k) {
    const int tries = report.increments + report.cut_backs;
    const solve::MotionReport part =
        stepper.advance(motion, begin + step.duration * k / step.frames, controls,
                        part_of(label, k, step.frames, tries), observer);
    report.increments += part.steps;
    report.cut_backs += part.refused_newton + part.refused_error + part.refused_energy;
    report.iterations += part.iterations;
    report.factorisations += part.factorisations;
    report.last = part.last;
    report.last_increment = part.last_increment;
    report.interrupted = part.interrupted;
    if (!part.converged) report.last.reason = part.reason;
    state_ = motion.state;
    controls_ = controls(motion.time);
    time_ = motion.time;
    report.reached = (time_ - begin) / step.duration;
    if (!part.converged) return report;
    report.reached = static_cast<double>(k) / step.frames;
    if (frame_reached) frame_reached(report.reached);
  }
  report.converged = true;
  return report;
}

solve::StepReport Stepper::move_quasi_statically(const MoveStep& step,
                                                 const solve::Increment& label,
                                                 solve::Observer& observer,
                                                 const FrameListener& frame_reached) {
  const double begin = time_;
  const mechanics::Controls before = controls_;
  solve::StepReport report;
  for (int k = 1; k <= step.frames; ++k) {
    const double time = step.duration * k / step.frames;
    const mechanics::Controls to =
        controls_in_move(model_, step, scenario_.gravity.vector(), before, time);
    solve::StepReport part = drive(controls_, to, label, observer);
    part.increments += report.increments;
    part.cut_backs += report.cut_backs;
    part.iterations += report.iterations;
    part.factorisations += report.factorisations;
    part.reached = (k - 1 + part.reached) / step.frames;
    report = part;
    time_ = begin + step.duration * report.reached;
    if (!report.converged) return report;
    if (frame_reached) frame_reached(report.reached);
  }
  return report;
}

solve::StepReport Stepper::take(int number, solve::Observer& observer,
                                const FrameListener& frame_reached) {
  const Step& step = scenario_.steps.at(static_cast<std::size_t>(number - 1));
  solve::Increment label;
  label.step = step_name(step);
  label.step_number = number;
  label.n_steps = static_cast<int>(scenario_.steps.size());
  if (std::holds_alternative<TensionStep>(step)) return tension(label, observer);
  if (std::holds_alternative<ReleaseStep>(step)) return release(label, observer);
  if (const auto* moving = std::get_if<MoveStep>(&step))
    return move(*moving, label, observer, frame_reached);
  if (std::holds_alternative<OpenJawStep>(step))
    return open_jaw(std::get<OpenJawStep>(step), label, observer, frame_reached);
  return express(std::get<ExpressStep>(step), label, observer, frame_reached);
}

}  // namespace facies::scenario
