// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/mechanics/time_step.hpp"

namespace facies::solve {

namespace {

// Shifts of the diagonal, relative to it, where nothing else helps.
constexpr double first_shift = 0.01;
constexpr double grow = 8.0;
constexpr double largest_shift = 1e4;
constexpr double smallest_positivity = 1.0 / 64.0;
constexpr int patience_with_positivity = 3;
// When a tangent that was indefinite is tried again: where the residual fell that much, else after so many iterations, twice as
// many each time that it still is.
constexpr int patience_with_tangent = 6;
constexpr int most_patience_with_tangent = 48;
constexpr double promising_fall = 0.2;
constexpr double smallest_step = 1.0 / 65536.0;
constexpr double energy_rounding = 1e-10;  // relative
constexpr double sufficient = 1e-4;        // part of the expected decrease of energy that is enough
constexpr double almost_all =
    0.999;  // of a way that was found free, so that rounding does not block it
constexpr double notably_less = 0.9;      // of a way that was found free and, bent anew, is not
constexpr double longest_stretch = 16.0;  // times a whole step
constexpr double still_steep = 0.5;    // part of the starting slope that makes going on worth a try
constexpr double accepted_work = 0.9;  // part of the starting work that may remain after a step
// Iterations in a row that may pass through states with an overgrown element. Where one heals, it does so in a few; where
// the tissue tears, more only stretch it to infinity.
constexpr int overgrown_patience = 8;

double square_sum(std::span<const double> v) {
  double sum = 0.0;
  for (const double x : v)
    sum += x * x;
  return sum;
}

/// "3e-10 of the load"; where nothing is a load, "2e-7 mN".
std::string describe_residual(const NewtonReport& report) {
  return std::isfinite(report.relative) ? fmt::format("{:.1e} of the load", report.relative)
                                        : fmt::format("{:.1e} mN", report.residual);
}

}  // namespace

/// What one call of solve() works on.
struct Equilibrium::Work {
  std::vector<double> r;          // [n_dofs]
  std::vector<double> values;     // nonzeros of K
  std::vector<double> moves;      // [n_dofs] what prescribed unknowns still have to move
  std::vector<double> coupling;   // [n_equations]
  std::vector<double> rhs;        // [n_equations]
  std::vector<double> step;       // [n_equations]
  std::vector<double> increment;  // [n_dofs] the step and the moves
  bool moving = false;            // some prescribed unknown still has to move
  double positivity = 1.0;        // to be tried next where K is indefinite
  int times_at_once = 0;          // that it did, in a row
  int wait_for_exact = patience_with_tangent;  // iterations until K itself is tried again
  int next_exact = patience_with_tangent;      // the iteration in which it is, at the latest
  int overgrown = 0;                           // states in a row with an overgrown element
};

/// What a step starts from.
struct Equilibrium::Descent {
  double energy = 0.0;  // [uJ]
  bool in_time = false;
};

/// Where a part of a step leads.
struct Equilibrium::Trial {
  mechanics::State state;
  std::vector<double> r;  // [n_dofs]
  double free_way = 1.0;  // of the bent step
  double energy = 0.0;    // [uJ]
  double work_before =
      0.0;  // minus the slope of the energy along the bent step, per whole step, where it begins [uJ]
  double work_after = 0.0;  // the slope where it ends [uJ]
};

Equilibrium::Equilibrium(const mechanics::Model& model, std::vector<Index> prescribed)
    : model_(model),
      prescribed_(std::move(prescribed)),
      assembly_(model, prescribed_),
      factor_(std::make_unique<SymmetricFactor>(assembly_.pattern())) {}

/// Residual over the free unknowns, the scale it is compared with, and where the largest of it is.
void Equilibrium::measure(Work& work, const mechanics::Controls& controls,
                          NewtonReport& report) const {
  double free_sum = 0.0;
  double fixed_sum = 0.0;
  double largest = -1.0;
  const std::vector<Index>& equation = assembly_.equations().equation_of_dof;
  for (std::size_t dof = 0; dof < work.r.size(); ++dof) {
    const double square = work.r[dof] * work.r[dof];
    if (equation[dof] < 0) {
      fixed_sum += square;
      continue;
    }
    free_sum += square;
    if (square > largest) {
      largest = square;
      report.worst_node = dof < 3 * model_.n_nodes() ? to_index(dof / 3) : -1;
    }
  }
  double applied = 0.0;
  for (const Vec3& force : controls.nodal_force)
    applied += force.squaredNorm();
  if (controls.time_step) applied = std::max(applied, square_sum(controls.time_step->push));
  report.residual = std::sqrt(free_sum);
  const double load = std::sqrt(std::max(fixed_sum, applied));
  report.relative = report.residual == 0.0 ? 0.0 : report.residual / load;
}

/// Assembles and factorises; false where the matrix is not positive definite, so that its step might go uphill in energy.
bool Equilibrium::factorise(Work& work, const mechanics::State& state,
                            const mechanics::Controls& controls, double positivity,
                            Iteration& iteration) {
  if (!assembly_.covers(state)) {
    assembly_.widen(state);
    factor_ = std::make_unique<SymmetricFactor>(assembly_.pattern());
  }
  work.values.resize(assembly_.pattern().n_nonzeros());
  work.coupling.assign(work.rhs.size(), 0.0);
  assembly_.tangent(state, controls, positivity, work.values,
                    work.moving ? work.moves : std::span<const double>(), work.coupling);
  const SparsityPattern& pattern = assembly_.pattern();
  for (std::size_t row = 0; row < pattern.size(); ++row) {
    double& diagonal = work.values[at(pattern.row_begin[row])];
    diagonal += iteration.shift * std::abs(diagonal);
  }
  ++iteration.factorisations;
  return factor_->factorise(work.values) == 0;
}

/// What did several times at once may be more than it takes; what did not is what it takes.
void Equilibrium::learn_positivity(Work& work, double positivity, bool at_once) {
  work.positivity = positivity;
  work.times_at_once = at_once ? work.times_at_once + 1 : 0;
  if (work.times_at_once < patience_with_positivity) return;
  work.positivity = std::max(smallest_positivity, 0.5 * positivity);
  work.times_at_once = 0;
}

/// K itself was tried in this iteration, and it was fit for a step or not.
void Equilibrium::learn_patience(Work& work, bool fit, int iteration) {
  work.wait_for_exact =
      fit ? patience_with_tangent : std::min(2 * work.wait_for_exact, most_patience_with_tangent);
  work.next_exact = iteration + work.wait_for_exact;
}

/// A step from K itself where that is wanted and positive definite. Else from K with the negative eigenvalues of its blocks
/// made smaller, by as little as it takes: near a saddle that leads away from it fast. Where even blocks without any
/// lead nowhere, with a growing diagonal: shorter and shorter steps down the gradient.
bool Equilibrium::take_step(Work& work, mechanics::State& state,
                            const mechanics::Controls& controls, bool exact, Iteration& iteration,
                            NewtonReport& report) {
  const double first = work.positivity;
  double positivity = exact ? 0.0 : first;
  while (iteration.shift <= largest_shift) {
    const bool definite = factorise(work, state, controls, positivity, iteration);
    if (definite) {
      for (std::size_t k = 0; k < work.rhs.size(); ++k) {
        work.rhs[k] = -work.r[at(assembly_.equations().dof_of_equation[k])] - work.coupling[k];
      }
      factor_->solve(work.rhs, work.step);
      iteration.step_length = find_step(work, state, controls, report);
    }
    if (iteration.step_length > 0.0) {
      iteration.exact = positivity == 0.0;
      if (!iteration.exact) learn_positivity(work, positivity, positivity == first);
      return true;
    }
    if (positivity == 1.0) {
      iteration.shift = std::max(first_shift, grow * iteration.shift);
    } else if (definite) {
      positivity = 1.0;
    } else {
      positivity = positivity == 0.0 ? first : std::min(1.0, 4.0 * positivity);
    }
  }
  return false;
}

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
  const std::vector<double> bent = model_.bent(state, work.increment, step);
  trial.state = model_.moved(state, bent, 1.0);
  trial.r.resize(work.r.size());
  trial.free_way = model_.longest_step(state, trial.state);
  if (trial.free_way < 1.0) return false;
  if (!model_.residual(trial.state, controls, trial.r, &report.inadmissible)) return false;
  trial.work_before = -work_of_free(work.r, bent) / step;
  trial.work_after = work_of_free(trial.r, bent) / step;
  if (!std::isfinite(trial.work_after)) return false;
  if (!work.moving) trial.energy = model_.energy(trial.state, controls);
  return true;
}

/// Part of the Newton step, the longest that is found by shortening it, which leads, once bent, to an admissible state
/// nearer to equilibrium; where its end is still steep, more than the whole. Updates state and residual; 0 where no part
/// will do.
double Equilibrium::find_step(Work& work, mechanics::State& state,
                              const mechanics::Controls& controls, NewtonReport& report) const {
  Descent before;
  before.in_time = controls.time_step != nullptr;
  if (!work.moving) before.energy = model_.energy(state, controls);
  work.increment = work.moves;
  for (std::size_t k = 0; k < work.step.size(); ++k)
    work.increment[at(assembly_.equations().dof_of_equation[k])] = work.step[k];
  Trial trial;
  double step = 1.0;
  double free_part = almost_all;
  while (step >= smallest_step) {
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

void Equilibrium::update_moves(Work& work, const mechanics::State& state,
                               std::span<const double> values) const {
  work.moving = false;
  for (std::size_t k = 0; k < prescribed_.size(); ++k) {
    const Index dof = prescribed_[k];
    const double move = values[k] - model_.value_of(state, dof);
    work.moves[at(dof)] = move;
    const bool arrived =
        std::abs(move) <= 1e-14 * (1.0 + std::abs(values[k]));  // never, where a value is NaN
    work.moving = work.moving || !arrived;
  }
}

/// True where the state is the answer, or no iteration more is worth while; the report then says which and why.
bool Equilibrium::is_over(Work& work, const mechanics::State& state, const NewtonSettings& settings,
                          NewtonReport& report) const {
  const mechanics::Inadmissible overgrown = model_.overgrown(state);
  work.overgrown = overgrown.element >= 0 ? work.overgrown + 1 : 0;
  const bool small = report.residual <= settings.absolute_tolerance ||
                     report.relative <= settings.relative_tolerance;
  const bool balanced = !work.moving && small;
  if (overgrown.element >= 0 && (balanced || work.overgrown > overgrown_patience)) {
    report.inadmissible = overgrown;
    report.reason =
        balanced ? "tissue tears: the only balance found is beyond what its law holds"
                 : fmt::format("tissue tears: beyond what its law holds for {} states in a row",
                               work.overgrown);
    return true;
  }
  if (balanced) {
    report.converged = true;
    report.reason = "residual " + describe_residual(report);
    return true;
  }
  if (report.iterations == settings.max_iterations) {
    report.reason = fmt::format("residual still {} after {} iterations", describe_residual(report),
                                report.iterations);
    return true;
  }
  return false;
}

NewtonReport Equilibrium::solve(mechanics::State& state, const mechanics::Controls& controls,
                                std::span<const double> values, const NewtonSettings& settings,
                                const std::function<void(const Iteration&)>& listen) {
  require(values.size() == prescribed_.size(), "one value per prescribed unknown");
  NewtonReport report;
  Work work;
  work.r.resize(model_.n_dofs());
  work.moves.assign(model_.n_dofs(), 0.0);
  work.rhs.resize(assembly_.equations().size());
  work.step.resize(assembly_.equations().size());
  if (!model_.residual(state, controls, work.r, &report.inadmissible)) {
    report.reason = "the state to start from is inadmissible";
    return report;
  }
  Iteration iteration;
  double previous = std::numeric_limits<double>::infinity();
  while (true) {
    update_moves(work, state, values);
    measure(work, controls, report);
    iteration.residual = report.residual;
    iteration.relative = report.relative;
    if (listen) listen(iteration);
    if (is_over(work, state, settings, report)) return report;
    const bool promising = iteration.exact || report.residual < promising_fall * previous;
    previous = report.residual;
    iteration = Iteration{.number = ++report.iterations};
    const bool due = report.iterations >= work.next_exact;
    const bool stepped = take_step(work, state, controls, promising || due, iteration, report);
    if (promising || due) learn_patience(work, iteration.exact, report.iterations);
    report.factorisations += iteration.factorisations;
    if (!stepped) {
      report.reason = "no admissible state along any descent step carries less residual";
      if (work.overgrown > 0) {
        report.reason = "tissue tears: no step leads back to what its law holds";
        report.inadmissible = model_.overgrown(state);
      }
      return report;
    }
    for (const double component : work.step) {
      iteration.correction =
          std::max(iteration.correction, iteration.step_length * std::abs(component));
    }
  }
}

double Equilibrium::residual_norm(const mechanics::State& state,
                                  const mechanics::Controls& controls) const {
  std::vector<double> r(model_.n_dofs());
  if (!model_.residual(state, controls, r)) return std::numeric_limits<double>::infinity();
  for (const Index dof : prescribed_)
    r[at(dof)] = 0.0;
  const double value = std::sqrt(square_sum(r));
  return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

NewtonReport solve_equilibrium(const mechanics::Model& model, mechanics::State& state,
                               const mechanics::Controls& controls,
                               const mechanics::Prescribed& prescribed,
                               const NewtonSettings& settings) {
  Equilibrium equilibrium(model, prescribed.dofs);
  return equilibrium.solve(state, controls, prescribed.values, settings);
}

}  // namespace facies::solve
