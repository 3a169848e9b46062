// SPDX-License-Identifier: Apache-2.0
// What terms need to know of a time step. A term sees the state at the end of the step and the rest here, so that a step in
// time is an equilibrium with two more kinds of force: inertia and damping (docs/theory/dynamics.md).
#pragma once

#include <map>
#include <vector>

#include "facies/mechanics/state.hpp"

namespace facies::mechanics {

class Term;

/// A step from a known state to the one that is sought. Vectors over unknowns [n_dofs] count rotations of a body as ways
/// at its arm, like the unknowns themselves: velocities [mm/s], forces [mN].
struct TimeStep {
  double h = 0.0;  ///< its length [s]
  State from;      ///< at its beginning
  std::vector<double>
      velocity;  ///< there [n_dofs]; of bodies: of the centre, then the angular one in space
  double inertia = 0.0;      ///< force of inertia by mass and way from the beginning [1/s^2]
  std::vector<double> push;  ///< force of inertia that does not depend on the end [n_dofs] [mN]
  std::map<const Term*, std::vector<double>>
      kept;  ///< what terms keep from the beginning (Term::begin)

  /// The rate at the end of something that changed by `change` and had the rate `before`: second order in h.
  template <class T>
  [[nodiscard]] T rate(const T& change, const T& before) const {
    return 2.0 / h * change - before;
  }
  /// The derivative of rate() by the change [1/s].
  [[nodiscard]] double rate_by_change() const { return 2.0 / h; }
};

}  // namespace facies::mechanics
