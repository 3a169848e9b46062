// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/mechanics/time_step.hpp"
#include "facies/solve/newton_work.hpp"

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
// The factor of a positive part serves for more steps: while each takes away this part of the energy that its own step did (a
// step without assembly and factorisation costs a sixth to a tenth), is not much longer than it, and is gone for a good part.
constexpr double worth_reusing = 0.05;
constexpr int most_reuses = 30;
constexpr double longest_reuse = 2.0;
constexpr double least_length_before = 0.25;
constexpr double least_length = 0.125;
// Iterations in a row that may pass through states with an overgrown element. Where one heals, it does so in a few; where
// the tissue tears, more only stretch it to infinity.
constexpr int overgrown_patience = 8;

double largest_of(std::span<const double> v) {
  double largest = 0.0;
  for (const double x : v)
    largest = std::max(largest, std::abs(x));
  return largest;
}

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
  work.reuse.possible = false;
  const double first = work.positivity;
  double positivity = exact ? 0.0 : first;
  while (iteration.shift <= largest_shift) {
    const bool definite = factorise(work, state, controls, positivity, iteration);
    if (definite) {
      for (std::size_t k = 0; k < work.rhs.size(); ++k) {
        work.rhs[k] = -work.r[at(assembly_.equations().dof_of_equation[k])] - work.coupling[k];
      }
      factor_->solve(work.rhs, work.step);
      iteration.step_length = find_step(work, state, controls, smallest_step, report);
    }
    if (iteration.step_length > 0.0) {
      iteration.exact = positivity == 0.0;
      if (!iteration.exact) learn_positivity(work, positivity, positivity == first);
      if (!iteration.exact && !work.moving && controls.time_step == nullptr)
        begin_reuse(work, iteration);
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

/// A step that was gone, and what became of the residual, over the free unknowns.
void Equilibrium::learn_secant(Work& work) const {
  const std::vector<Index>& dofs = assembly_.equations().dof_of_equation;
  std::vector<double> way, change;
  for (const Index dof : dofs) {
    way.push_back(work.way[at(dof)]);
    change.push_back(work.r[at(dof)] - work.r_before[at(dof)]);
  }
  work.reuse.secants.learn(std::move(way), std::move(change));
}

/// A step with a new factor has been taken.
void Equilibrium::begin_reuse(Work& work, const Iteration& iteration) const {
  Reuse& reuse = work.reuse;
  reuse.possible = true;
  reuse.steps = 0;
  reuse.gain = reuse.last_gain = work.gain;
  reuse.last_length = iteration.step_length;
  reuse.largest = largest_of(work.step);
  reuse.secants.forget();
  learn_secant(work);
}

/// A step from the factor of an earlier tangent, corrected by what the steps since then taught; false where there is none
/// or where it is not worth its while.
bool Equilibrium::take_step_with_old_factor(Work& work, mechanics::State& state,
                                            const mechanics::Controls& controls,
                                            Iteration& iteration, NewtonReport& report) const {
  Reuse& reuse = work.reuse;
  if (!reuse.possible || reuse.steps == most_reuses || reuse.last_length < least_length_before ||
      reuse.last_gain < worth_reusing * reuse.gain) {
    return false;
  }
  for (std::size_t k = 0; k < work.rhs.size(); ++k)
    work.rhs[k] = -work.r[at(assembly_.equations().dof_of_equation[k])];
  reuse.secants.solve(
      work.rhs,
      [this](std::span<const double> rhs, std::span<double> x) { factor_->solve(rhs, x); },
      work.step);
  if (largest_of(work.step) > longest_reuse * reuse.largest) return false;
  iteration.step_length = find_step(work, state, controls, least_length, report);
  if (iteration.step_length == 0.0) return false;
  iteration.exact = false;
  ++reuse.steps;
  reuse.last_gain = work.gain;
  reuse.last_length = iteration.step_length;
  learn_secant(work);
  return true;
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
  work.wait_for_exact = work.next_exact = patience_with_tangent;
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
    const bool exact = promising || report.iterations >= work.next_exact;
    const bool stepped =
        (!exact && take_step_with_old_factor(work, state, controls, iteration, report)) ||
        take_step(work, state, controls, exact, iteration, report);
    if (exact) learn_patience(work, iteration.exact, report.iterations);
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
