// SPDX-License-Identifier: Apache-2.0
// What moves (State), what drives it (Controls), and which unknowns are given (Prescribed).
#pragma once

#include <vector>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mechanics {

/// Everything that moves during a run. A value: copy it, save it, restore it.
struct State {
  std::vector<Vec3> u;  ///< displacement of each node from the mesh configuration [mm]
};

/// What drives the model at a moment.
struct Controls {
  std::vector<double> activation;  ///< alpha of each muscle, 0..1
  Vec3 gravity = Vec3::Zero();     ///< acceleration [mm/s^2]
  std::vector<Vec3> nodal_force;   ///< external force on each node [mN]; empty: none
};

/// Controls on the straight line from `a` (s = 0) to `b` (s = 1). An empty nodal_force counts as zero.
[[nodiscard]] Controls interpolate(const Controls& a, const Controls& b, double s);

/// Unknown number 3*node + axis.
[[nodiscard]] constexpr Index dof(Index node, int axis) {
  return 3 * node + axis;
}

/// Displacements that are given: dofs ascending, each with the value it has at the end of the step [mm].
struct Prescribed {
  std::vector<Index> dofs;
  std::vector<double> values;
};

}  // namespace facies::mechanics
