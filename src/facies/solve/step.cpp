// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/step.hpp"

#include <algorithm>
#include <cmath>

#include "facies/base/error.hpp"

namespace facies::solve {

namespace {

/// Iterations of a converged increment up to which the next one may be larger.
constexpr int easy = 8;

std::vector<double> current_values(const Equilibrium& equilibrium, const mechanics::State& state) {
  std::vector<double> values;
  values.reserve(equilibrium.prescribed().size());
  for (const Index dof : equilibrium.prescribed())
    values.push_back(equilibrium.model().value_of(state, dof));
  return values;
}

/// The state continued along the last converged increment, `ratio` times as far.
mechanics::State extrapolate(const mechanics::State& before, const mechanics::State& now,
                             double ratio) {
  mechanics::State guess = now;
  for (std::size_t node = 0; node < guess.u.size(); ++node)
    guess.u[node] += ratio * (now.u[node] - before.u[node]);
  for (std::size_t body = 0; body < guess.bodies.size(); ++body)
    guess.bodies[body] = mechanics::extrapolate(before.bodies[body], now.bodies[body], ratio);
  return guess;
}

/// The first k / stops beyond a part of the step.
double next_stop(double reached, int stops) {
  const double k = std::floor(reached * stops + 1e-9) + 1.0;
  return std::min(k / stops, 1.0);
}

}  // namespace

StepReport advance(Equilibrium& equilibrium, mechanics::State& state,
                   const mechanics::Controls& from, const mechanics::Controls& to,
                   std::span<const double> targets, const StepSettings& settings,
                   const Increment& label, Observer& observer, const StopListener& stop_reached) {
  const std::vector<double> start = current_values(equilibrium, state);
  mechanics::State before;  // the converged state before `state`; empty at first
  double last_size = 0.0;
  double size = std::clamp(settings.first_increment, settings.smallest_increment, 1.0);
  StepReport report;
  Increment increment = label;
  for (increment.number = 1; increment.number <= settings.max_increments; ++increment.number) {
    increment.from = report.reached;
    const double stop = next_stop(report.reached, settings.stops);
    const bool is_stop = report.reached + size > stop - 1e-9;
    increment.to = is_stop ? stop : report.reached + size;
    const mechanics::Controls controls = mechanics::interpolate(from, to, increment.to);
    std::vector<double> values(targets.begin(), targets.end());
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = start[k] + increment.to * (targets[k] - start[k]);

    observer.increment_begins(increment);
    mechanics::State trial = state;
    if (!before.u.empty()) {
      mechanics::State guess =
          extrapolate(before, state, (increment.to - increment.from) / last_size);
      const bool free_way = equilibrium.model().longest_step(state, guess) == 1.0;
      if (free_way &&
          equilibrium.residual_norm(guess, controls) < equilibrium.residual_norm(state, controls)) {
        trial = std::move(guess);
      }
    }
    report.last_increment = increment;
    try {
      report.last = equilibrium.solve(trial, controls, values, settings.newton,
                                      [&](const Iteration& iteration) {
                                        observer.iteration_done(increment, iteration);
                                        if (observer.stop_requested()) throw Interrupted();
                                      });
    } catch (const Interrupted&) {
      report.interrupted = true;
      return report;
    }
    report.iterations += report.last.iterations;
    report.factorisations += report.last.factorisations;
    observer.increment_ends(
        increment,
        {report.last.converged, report.last.reason, report.last.iterations, report.last.residual,
         report.last.relative, report.last.worst_node, report.last.inadmissible});
    if (report.last.converged) {
      ++report.increments;
      last_size = increment.to - increment.from;
      report.reached = increment.to;
      before = std::move(state);
      state = std::move(trial);
      if (is_stop && stop_reached) stop_reached(report.reached);
      if (report.reached >= 1.0) {
        report.converged = true;
        return report;
      }
      if (report.last.iterations <= easy) size = std::min(2.0 * last_size, 1.0);
    } else {
      ++report.cut_backs;
      size = 0.5 * (increment.to - increment.from);
      if (size < settings.smallest_increment) return report;
    }
  }
  return report;
}

}  // namespace facies::solve
