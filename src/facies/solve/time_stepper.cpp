// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/time_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "facies/base/error.hpp"

namespace facies::solve {

namespace {

constexpr double shrink = 0.2;  // least and largest change of size from step to step
constexpr double grow = 2.0;
constexpr double worth_while =
    1.3;  // smaller growth is left: steps of one size are the best understood
constexpr double safety = 0.9;
// Of energies: differences below this part of the potential are rounding and unfinished iterations.
constexpr double noise = 1e-9;

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

/// One step tried: where it leads and what is to be said of it.
struct TimeStepper::Attempt {
  NewtonReport newton;
  std::shared_ptr<const mechanics::TimeStep> step;
  Motion end;
  double error = 0.0;     // [mm]
  double gain = 0.0;      // energy out of nothing [uJ]
  double exchange = 0.0;  // energy that changed its place [uJ]
};

TimeStepper::TimeStepper(Equilibrium& equilibrium, const mechanics::Inertia& inertia,
                         const TimeSettings& settings)
    : equilibrium_(equilibrium), inertia_(inertia), settings_(settings) {
  const double rho = settings.rho_inf;
  require(rho >= 0.0 && rho <= 1.0, "rho_inf is between 0 and 1");
  require(settings.first_step > 0.0 && settings.smallest_step > 0.0, "time steps are positive");
  alpha_m_ = (2.0 * rho - 1.0) / (rho + 1.0);
  alpha_f_ = rho / (rho + 1.0);
  gamma_ = 0.5 - alpha_m_ + alpha_f_;
  beta_ = 0.25 * std::pow(1.0 - alpha_m_ + alpha_f_, 2);
  size_ = std::min(settings.first_step, settings.largest_step);
}

void TimeStepper::clear_held(std::vector<double>& v) const {
  for (const Index dof : equilibrium_.prescribed())
    v[at(dof)] = 0.0;
}

Motion TimeStepper::begin(double time, const mechanics::State& state,
                          const ControlsInTime& controls, std::vector<double> momentum) const {
  const mechanics::Model& model = equilibrium_.model();
  Motion motion;
  motion.time = time;
  motion.state = state;
  motion.momentum = std::move(momentum);
  motion.momentum.resize(model.n_dofs(), 0.0);
  clear_held(motion.momentum);
  // Damping at the first moment: that of a step without length, whose rates are the velocities.
  mechanics::Controls now = controls(time);
  now.time_step.reset();
  motion.energy.potential = model.energy(state, now);
  motion.energy.kinetic = inertia_.kinetic_energy(state, motion.momentum);
  motion.force.resize(model.n_dofs());
  const bool admissible = model.residual(state, now, motion.force);
  require(admissible, "a motion begins at an admissible state");
  motion.damping.resize(model.n_dofs());
  const auto step = std::make_shared<mechanics::TimeStep>();
  step->h = 1.0;
  step->from = state;
  step->velocity = inertia_.velocity(state, motion.momentum);
  for (double& v : step->velocity)
    v = -v;  // rate() then gives the velocity where nothing has moved
  for (const auto& term : model.terms())
    term->begin(now, *step);
  now.time_step = step;
  model.damping(state, now, motion.damping);
  for (std::size_t dof = 0; dof < motion.force.size(); ++dof)
    motion.force[dof] = -motion.force[dof] - motion.damping[dof];
  clear_held(motion.force);
  motion.rate = motion.force;
  return motion;
}

/// Inertia in terms of the way: the rate of the momenta at the end is (mass way / h - p) / (beta h) - (1/2 - beta) / beta rate.
std::shared_ptr<mechanics::TimeStep> TimeStepper::make_step(
    const Motion& motion, double h, const mechanics::Controls& before) const {
  auto step = std::make_shared<mechanics::TimeStep>();
  step->h = h;
  step->from = motion.state;
  step->velocity = inertia_.velocity(motion.state, motion.momentum);
  const double weight = (1.0 - alpha_m_) / (1.0 - alpha_f_);
  step->inertia = weight / (beta_ * h * h);
  step->push.resize(motion.momentum.size());
  for (std::size_t dof = 0; dof < step->push.size(); ++dof) {
    const double carried =
        motion.momentum[dof] / (beta_ * h) + (0.5 - beta_) / beta_ * motion.rate[dof];
    step->push[dof] =
        weight * carried +
        (alpha_f_ * motion.force[dof] - alpha_m_ * motion.rate[dof]) / (1.0 - alpha_f_);
  }
  for (const auto& term : equilibrium_.model().terms())
    term->begin(before, *step);
  return step;
}

/// Momenta, rates and forces at the end of a step whose state is known.
void TimeStepper::finish(Attempt& attempt, const Motion& before,
                         const mechanics::Controls& controls_before,
                         const mechanics::Controls& controls_after) const {
  const double h = attempt.step->h;
  Motion& end = attempt.end;
  const std::vector<double> mass_way = inertia_.mass_way(before.state, end.state);
  const std::size_t n = mass_way.size();
  end.momentum.resize(n);
  end.rate.resize(n);
  end.force.resize(n);
  for (std::size_t dof = 0; dof < n; ++dof) {
    end.rate[dof] = (mass_way[dof] / h - before.momentum[dof]) / (beta_ * h) -
                    (0.5 - beta_) / beta_ * before.rate[dof];
    end.momentum[dof] =
        before.momentum[dof] + h * ((1.0 - gamma_) * before.rate[dof] + gamma_ * end.rate[dof]);
    end.force[dof] = ((1.0 - alpha_m_) * end.rate[dof] + alpha_m_ * before.rate[dof] -
                      alpha_f_ * before.force[dof]) /
                     (1.0 - alpha_f_);
  }
  for (std::vector<double>* v : {&end.rate, &end.momentum, &end.force})
    clear_held(*v);
  end.damping.resize(n);
  equilibrium_.model().damping(end.state, controls_after, end.damping);
  balance(attempt, before, controls_before, controls_after);
  attempt.error = error_of(attempt, before);
}

/// Both ends count half for damping and for controls that change: exact for the trapezoidal rule and linear forces.
void TimeStepper::balance(Attempt& attempt, const Motion& before,
                          const mechanics::Controls& controls_before,
                          const mechanics::Controls& controls_after) const {
  const mechanics::Model& model = equilibrium_.model();
  mechanics::Controls now = controls_after;
  now.time_step.reset();
  EnergyBooks& books = attempt.end.energy;
  books = before.energy;
  books.kinetic = inertia_.kinetic_energy(attempt.end.state, attempt.end.momentum);
  books.potential = model.energy(attempt.end.state, now);
  const double work = 0.5 * (model.energy(before.state, now) - before.energy.potential +
                             books.potential - model.energy(attempt.end.state, controls_before));
  const std::vector<double> way = inertia_.way(before.state, attempt.end.state);
  const double dissipated = 0.5 * (dot(way, before.damping) + dot(way, attempt.end.damping));
  const double kinetic = books.kinetic - before.energy.kinetic;
  const double potential = books.potential - before.energy.potential;
  attempt.gain = kinetic + potential + dissipated - work;
  attempt.exchange = books.kinetic + before.energy.kinetic + std::abs(potential) +
                     std::abs(dissipated) + std::abs(work);
  books.work += work;
  books.dissipated += dissipated;
  books.numerical += attempt.gain;
}

/// Way that the next term of the Taylor series would add (Zienkiewicz and Xie 1991), the largest of all unknowns.
double TimeStepper::error_of(const Attempt& attempt, const Motion& before) const {
  const double h = attempt.step->h;
  const Motion& end = attempt.end;
  const std::vector<double> a0 = inertia_.acceleration(before.state, before.momentum, before.rate);
  const std::vector<double> a1 = inertia_.acceleration(end.state, end.momentum, end.rate);
  double largest = 0.0;
  for (std::size_t dof = 0; dof < a0.size(); ++dof)
    largest = std::max(largest, std::abs(a1[dof] - a0[dof]));
  return (beta_ - 1.0 / 6.0) * h * h * largest;
}

TimeStepper::Attempt TimeStepper::attempt(const Motion& motion, double h,
                                          const ControlsInTime& controls,
                                          const std::function<void(const Iteration&)>& listen) {
  mechanics::Controls before = controls(motion.time);
  mechanics::Controls after = controls(motion.time + h);
  before.time_step.reset();
  Attempt attempt;
  attempt.step = make_step(motion, h, before);
  after.time_step = attempt.step;
  attempt.end.time = motion.time + h;
  attempt.end.state = motion.state;
  const mechanics::Model& model = equilibrium_.model();
  std::vector<double> way(model.n_dofs());
  const std::vector<double> a = inertia_.acceleration(motion.state, motion.momentum, motion.rate);
  for (std::size_t dof = 0; dof < way.size(); ++dof)
    way[dof] = h * (attempt.step->velocity[dof] + 0.5 * h * a[dof]);
  mechanics::State guess = model.moved(motion.state, way, 1.0);
  if (equilibrium_.residual_norm(guess, after) < equilibrium_.residual_norm(motion.state, after) &&
      model.longest_step(motion.state, guess) >= 1.0) {
    attempt.end.state = std::move(guess);
  }
  std::vector<double> places;
  for (const Index dof : equilibrium_.prescribed())
    places.push_back(model.value_of(motion.state, dof));
  attempt.newton = equilibrium_.solve(attempt.end.state, after, places, settings_.newton, listen);
  if (attempt.newton.converged) finish(attempt, motion, before, after);
  return attempt;
}

/// What size to try next, and in the report why where the step is refused: then it is smaller than h.
double TimeStepper::next_size(const Attempt& attempt, double h, MotionReport& report) const {
  const auto too_small = [&](const std::string& why) {
    report.reason = fmt::format("{} even in a step of {:.1e} s", why, h);
  };
  if (!attempt.newton.converged) {
    ++report.refused_newton;
    too_small(attempt.newton.reason);
    return 0.5 * h;
  }
  const double factor = safety * std::cbrt(settings_.tolerance / attempt.error);
  if (!(attempt.error <= settings_.tolerance)) {
    ++report.refused_error;
    too_small(fmt::format("the error is {:.2g} mm", attempt.error));
    return h * std::clamp(factor, shrink, 0.9);
  }
  if (attempt.gain > settings_.energy_tolerance * attempt.exchange +
                         noise * std::abs(attempt.end.energy.potential)) {
    ++report.refused_energy;
    too_small(fmt::format("{:.2g} uJ appear out of nothing", attempt.gain));
    return 0.5 * h;
  }
  if (factor < worth_while) return factor < 1.0 ? h * factor : h;
  return h * std::min(grow, factor);
}

MotionReport TimeStepper::advance(Motion& motion, double to, const ControlsInTime& controls,
                                  const Increment& label, Observer& observer) {
  const double begin = motion.time;
  MotionReport report;
  int tries = 0;
  const auto part = [&](double time) {
    return label.from + (label.to - label.from) * (time - begin) / (to - begin);
  };
  while (motion.time < to) {
    const double left = to - motion.time;
    // Two equal steps at the end instead of one that is much smaller; none shorter than rounding.
    const double h = left <= 1.001 * size_ ? left : std::min(size_, 0.5 * left);
    Increment& increment = report.last_increment;
    increment = label;
    increment.number = label.number + ++tries;
    increment.from = part(motion.time);
    increment.to = part(motion.time + h);
    observer.increment_begins(increment);
    bool stop = false;
    Attempt tried = attempt(motion, h, controls, [&](const Iteration& iteration) {
      observer.iteration_done(increment, iteration);
      stop = stop || observer.stop_requested();
    });
    report.last = tried.newton;
    report.iterations += tried.newton.iterations;
    report.factorisations += tried.newton.factorisations;
    const int refused = report.refused_newton + report.refused_error + report.refused_energy;
    const double next = next_size(tried, h, report);
    const bool accepted =
        report.refused_newton + report.refused_error + report.refused_energy == refused;
    observer.increment_ends(
        increment, {accepted, accepted ? report.last.reason : report.reason, report.last.iterations,
                    report.last.residual, report.last.relative, report.last.worst_node,
                    report.last.inadmissible});
    if (accepted) {
      ++report.steps;
      motion = std::move(tried.end);
      if (h == left) motion.time = to;
      observer.time_step_done(motion);
      size_ = std::min(std::max(next, h < size_ ? size_ : 0.0), settings_.largest_step);
    } else {
      size_ = next;
      if (size_ < settings_.smallest_step) return report;
    }
    if (stop) {
      report.interrupted = true;
      return report;
    }
    if (tries >= settings_.max_steps) {
      report.reason = fmt::format("not at the end after {} steps", tries);
      return report;
    }
  }
  report.converged = true;
  report.reason.clear();
  return report;
}

}  // namespace facies::solve
