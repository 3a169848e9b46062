// SPDX-License-Identifier: Apache-2.0
// What the two halves of Equilibrium share: which step (newton.cpp) and how far (newton_search.cpp).
#pragma once

#include "facies/solve/newton.hpp"
#include "facies/solve/secant.hpp"

namespace facies::solve {

/// What the factor of an earlier tangent is still good for.
struct Equilibrium::Reuse {
  SecantPairs secants{10};
  bool possible = false;
  int steps = 0;         // that were taken with it after its own
  double gain = 0.0;     // energy that its own step took away [uJ]
  double largest = 0.0;  // component of its own step, whole [mm]
  double last_gain = 0.0;
  double last_length = 0.0;
};

/// What one call of solve() works on.
struct Equilibrium::Work {
  std::vector<double> r;          // [n_dofs]
  std::vector<double> r_before;   // [n_dofs] before the last step
  std::vector<double> way;        // [n_dofs] the last step, as it was gone
  double gain = 0.0;              // energy that it took away; 0 while prescribed unknowns move [uJ]
  std::vector<double> values;     // nonzeros of K
  std::vector<double> moves;      // [n_dofs] what prescribed unknowns still have to move
  std::vector<double> coupling;   // [n_equations]
  std::vector<double> rhs;        // [n_equations]
  std::vector<double> step;       // [n_equations]
  std::vector<double> increment;  // [n_dofs] the step and the moves
  bool moving = false;            // some prescribed unknown still has to move
  double positivity = 1.0;        // to be tried next where K is indefinite
  int times_at_once = 0;          // that it did, in a row
  int wait_for_exact = 0;         // iterations until K itself is tried again
  int next_exact = 0;             // the iteration in which it is, at the latest
  int overgrown = 0;              // states in a row with an overgrown element
  Reuse reuse;
};

/// What a step starts from.
struct Equilibrium::Descent {
  double energy = 0.0;  // [uJ]
  bool in_time = false;
};

/// Where a part of a step leads.
struct Equilibrium::Trial {
  mechanics::State state;
  std::vector<double> way;  // [n_dofs] the bent step
  std::vector<double> r;    // [n_dofs]
  double free_way = 1.0;    // of the bent step
  double energy = 0.0;      // [uJ]
  double work_before =
      0.0;  // minus the slope of the energy along the bent step, per whole step, where it begins [uJ]
  double work_after = 0.0;  // the slope where it ends [uJ]
};

}  // namespace facies::solve
