// SPDX-License-Identifier: Apache-2.0
// Static equilibrium by Newton's method, on tangents that may be indefinite and trial states that may be inadmissible.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "facies/solve/assembly.hpp"
#include "facies/solve/factor.hpp"
#include "facies/solve/observer.hpp"

namespace facies::solve {

struct NewtonSettings {
  double relative_tolerance =
      1e-6;  ///< of |r| over the free unknowns, against the reactions, applied forces and, in a time step, what drives it
  double absolute_tolerance = 1e-6;  ///< [mN], for models that carry no load at all
  int max_iterations = 80;
};

/// How a solution ended. `converged` comes from the criterion, never from a counter, and never where an element has grown
/// beyond what its law holds for (mechanics::Term::overgrown).
struct NewtonReport {
  bool converged = false;
  std::string reason;
  int iterations = 0;
  int factorisations = 0;
  double residual = 0.0;  ///< |r| over the free unknowns [mN]
  double relative = 0.0;  ///< residual / load; infinity where there is a residual and no load
  Index worst_node =
      -1;  ///< carries the largest remaining residual; -1 where nothing was evaluated
  mechanics::Inadmissible
      inadmissible;  ///< the last element that stood in the way; element -1: none did
};

/// Finds equilibria of one model with one set of prescribed unknowns; pattern, numbering and symbolic factorisation are
/// made once. Method: docs/theory/solver.md.
class Equilibrium {
 public:
  /// The model must outlive this. Prescribed unknowns ascending.
  Equilibrium(const mechanics::Model& model, std::vector<Index> prescribed);

  [[nodiscard]] const mechanics::Model& model() const { return model_; }
  [[nodiscard]] std::span<const Index> prescribed() const { return prescribed_; }

  /// Moves `state` to equilibrium under `controls` with the prescribed unknowns at `values` [mm]. Where that fails the
  /// state is left at the last iterate. `listen` hears every iteration.
  [[nodiscard]] NewtonReport solve(mechanics::State& state, const mechanics::Controls& controls,
                                   std::span<const double> values, const NewtonSettings& settings,
                                   const std::function<void(const Iteration&)>& listen = {});

  /// |r| over the free unknowns [mN]; +infinity for an inadmissible state.
  [[nodiscard]] double residual_norm(const mechanics::State& state,
                                     const mechanics::Controls& controls) const;

 private:
  struct Reuse;
  struct Work;
  struct Descent;
  struct Trial;

  void update_moves(Work& work, const mechanics::State& state,
                    std::span<const double> values) const;
  [[nodiscard]] bool is_over(Work& work, const mechanics::State& state,
                             const NewtonSettings& settings, NewtonReport& report) const;
  void measure(Work& work, const mechanics::Controls& controls, NewtonReport& report) const;
  [[nodiscard]] bool factorise(Work& work, const mechanics::State& state,
                               const mechanics::Controls& controls, double positivity,
                               Iteration& iteration);
  static void learn_positivity(Work& work, double positivity, bool at_once);
  static void learn_patience(Work& work, bool fit, int iteration);
  [[nodiscard]] bool take_step(Work& work, mechanics::State& state,
                               const mechanics::Controls& controls, bool exact,
                               Iteration& iteration, NewtonReport& report);
  [[nodiscard]] bool take_step_with_old_factor(Work& work, mechanics::State& state,
                                               const mechanics::Controls& controls,
                                               Iteration& iteration, NewtonReport& report) const;
  void learn_secant(Work& work) const;
  void begin_reuse(Work& work, const Iteration& iteration) const;
  [[nodiscard]] double find_step(Work& work, mechanics::State& state,
                                 const mechanics::Controls& controls, double shortest,
                                 NewtonReport& report) const;
  [[nodiscard]] double go_on(const Work& work, const mechanics::State& state,
                             const mechanics::Controls& controls, Trial& best,
                             NewtonReport& report) const;
  [[nodiscard]] bool try_step(const Work& work, const mechanics::State& state,
                              const mechanics::Controls& controls, double step, Trial& trial,
                              NewtonReport& report) const;
  [[nodiscard]] bool is_nearer(const Descent& before, const Trial& trial, double step) const;
  [[nodiscard]] double work_of_free(std::span<const double> r,
                                    std::span<const double> increments) const;

  const mechanics::Model& model_;
  std::vector<Index> prescribed_;
  Assembly assembly_;
  std::unique_ptr<SymmetricFactor> factor_;  // of the assembly's present pattern
};

/// One-shot: equilibrium under `controls` with the given unknowns prescribed.
[[nodiscard]] NewtonReport solve_equilibrium(const mechanics::Model& model, mechanics::State& state,
                                             const mechanics::Controls& controls,
                                             const mechanics::Prescribed& prescribed,
                                             const NewtonSettings& settings = {});

}  // namespace facies::solve
