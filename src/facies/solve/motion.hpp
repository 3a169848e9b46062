// SPDX-License-Identifier: Apache-2.0
// A model on its way through time: what a time step needs from the one before, and the books of its energy.
#pragma once

#include <vector>

#include "facies/mechanics/state.hpp"

namespace facies::solve {

/// Where the energy of a motion is and where it went [uJ]. Work, dissipation and numerical change count from the beginning.
struct EnergyBooks {
  double kinetic = 0.0;
  double potential = 0.0;   ///< of the model under the present controls, weight included
  double work = 0.0;        ///< that changing controls did: muscles that become active
  double dissipated = 0.0;  ///< by damping
  double numerical = 0.0;   ///< what the method added (or, negative, took): the rest of the balance
};

/// Vectors [n_dofs] as in mechanics::Inertia; 0 for prescribed unknowns, which stay where they are.
struct Motion {
  double time = 0.0;  ///< [s]
  mechanics::State state;
  std::vector<double> momentum;  ///< [mN s]
  std::vector<double> rate;   ///< of the momentum, as the method carries it from step to step [mN]
  std::vector<double> force;  ///< of everything but inertia, on the unknowns [mN]
  std::vector<double> damping;  ///< the part of it that dissipates, as a residual [mN]
  EnergyBooks energy;
};

}  // namespace facies::solve
