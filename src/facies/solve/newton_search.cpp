// SPDX-License-Identifier: Apache-2.0
// How far a step is gone: the longest part of it that passes nothing and leads nearer to equilibrium.
#include <algorithm>
#include <cmath>

#include "facies/solve/newton_work.hpp"

namespace facies::solve {

namespace {

constexpr double energy_rounding = 1e-10;  // relative
constexpr double sufficient = 1e-4;        // part of the expected decrease of energy that is enough
constexpr double almost_all =
    0.999;  // of a way that was found free, so that rounding does not block it
constexpr double notably_less = 0.9;      // of a way that was found free and, bent anew, is not
constexpr double longest_stretch = 16.0;  // times a whole step
constexpr double still_steep = 0.5;    // part of the starting slope that makes going on worth a try
constexpr double accepted_work = 0.9;  // part of the starting work that may remain after a step

}  // namespace

/// The work of r along increments of the free unknowns [uJ].
double Equilibrium::work_of_free(std::span<const double> r,
                                 std::span<const double> increments) const {
  double sum = 0.0;
  for (const Index dof : assembly_.equations().dof_of_equation)
    sum += r[at(dof)] * increments[at(dof)];
  return sum;
}

/// Whether a trial is nearer to equilibrium: its energy is lower by a sufficient part of what the slope promised; or,
/// where differences of energy drown in rounding, it is not higher and the residual's work along the step fell. (The work alone
/// would let iterations go to and fro between two states on either side of a kink, as contact has. In a time step, where
/// a turning body has no potential and mass keeps iterations from that, it is enough.)
bool Equilibrium::is_nearer(const Descent& before, const Trial& trial, double step) const {
  if (trial.energy <= before.energy - sufficient * step * trial.work_before) return true;
  const bool not_higher =
      before.in_time || trial.energy <= before.energy + energy_rounding * std::abs(before.energy);
  return not_higher && std::abs(trial.work_after) <= accepted_work * trial.work_before;
}

/// The state where part `step` of the Newton step, bent, leads to; false where something is in the way (then `free_way` of the
/// bent step is free) or the state is inadmissible.
bool Equilibrium::try_step(const Work& work, const mechanics::State& state,
                           const mechanics::Controls& controls, double step, Trial& trial,
                           NewtonReport& report) const {
  trial.way = model_.bent(state, work.increment, step);
  trial.state = model_.moved(state, trial.way, 1.0);
  trial.r.resize(work.r.size());
  trial.free_way = model_.longest_step(state, trial.state);
  if (trial.free_way < 1.0) return false;
  if (!model_.residual(trial.state, controls, trial.r, &report.inadmissible)) return false;
  trial.work_before = -work_of_free(work.r, trial.way) / step;
  trial.work_after = work_of_free(trial.r, trial.way) / step;
  if (!std::isfinite(trial.work_after)) return false;
  if (!work.moving) trial.energy = model_.energy(trial.state, controls);
  return true;
}

/// Part of the step, the longest that is found by shortening it to `shortest`, which leads, once bent, to an admissible
/// state nearer to equilibrium; where its end is still steep, more than the whole. Updates state, residual, way and gain; 0
/// where no part will do.
double Equilibrium::find_step(Work& work, mechanics::State& state,
                              const mechanics::Controls& controls, double shortest,
                              NewtonReport& report) const {
  Descent before;
  before.in_time = controls.time_step != nullptr;
  if (!work.moving) before.energy = model_.energy(state, controls);
  work.increment = work.moves;
  for (std::size_t k = 0; k < work.step.size(); ++k)
    work.increment[at(assembly_.equations().dof_of_equation[k])] = work.step[k];
  Trial trial;
  double step = 1.0;
  double free_part = almost_all;
  while (step >= shortest) {
    const bool admissible = try_step(work, state, controls, step, trial, report);
    if (trial.free_way < 1.0) {
      step *= std::min(trial.free_way, free_part);
      free_part = notably_less;
      continue;
    }
    double shorten = 0.5;
    if (admissible) {
      const bool downhill = trial.work_before > 0.0;
      if (work.moving || (downhill && is_nearer(before, trial, step))) {
        if (step == 1.0 && !work.moving && !before.in_time)
          step = go_on(work, state, controls, trial, report);
        state = std::move(trial.state);
        work.gain = before.energy - trial.energy;
        work.way.swap(trial.way);
        work.r_before.swap(work.r);
        work.r.swap(trial.r);
        return step;
      }
      if (downhill && trial.work_after > 0.0)
        shorten = std::clamp(trial.work_before / (trial.work_before + trial.work_after), 0.1, 0.5);
    }
    step *= shorten;
  }
  return 0.0;
}

/// From the end of a whole step on, twice as far each time while the energy keeps falling and its slope stays steep.
double Equilibrium::go_on(const Work& work, const mechanics::State& state,
                          const mechanics::Controls& controls, Trial& best,
                          NewtonReport& report) const {
  double step = 1.0;
  Trial farther;
  while (step < longest_stretch && -best.work_after > still_steep * best.work_before &&
         try_step(work, state, controls, 2.0 * step, farther, report) &&
         farther.energy < best.energy) {
    std::swap(best, farther);
    step *= 2.0;
  }
  return step;
}

}  // namespace facies::solve
