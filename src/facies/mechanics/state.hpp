// SPDX-License-Identifier: Apache-2.0
// What moves (State), what drives it (Controls), and which unknowns are given (Prescribed).
#pragma once

#include <memory>
#include <vector>

#include "facies/base/index.hpp"
#include "facies/mechanics/rigid_body.hpp"

namespace facies::mechanics {

struct TimeStep;

/// Everything that moves during a run. A value: copy it, save it, restore it.
struct State {
  std::vector<Vec3> u;            ///< displacement of each node from the mesh configuration [mm]
  std::vector<Pose> bodies = {};  ///< where each rigid body is
};

/// What drives the model at a moment.
struct Controls {
  std::vector<double> activation;  ///< alpha of each muscle of the tissue, 0..1
  std::vector<double> excitation;  ///< of each point-to-point muscle, 0..1; empty: none is excited
  Vec3 gravity = Vec3::Zero();     ///< acceleration of the tissue [mm/s^2]
  Vec3 body_gravity = Vec3::Zero();  ///< acceleration of rigid bodies [mm/s^2]
  std::vector<Vec3> nodal_force;     ///< external force on each node [mN]; empty: none
  std::shared_ptr<const TimeStep> time_step = {};  ///< that the state ends; none in statics
};

/// Controls on the straight line from `a` (s = 0) to `b` (s = 1). Where excitation or nodal_force is empty
/// it counts as zero. Of statics: no time step.
[[nodiscard]] Controls interpolate(const Controls& a, const Controls& b, double s);

/// Unknown number 3*node + axis. The six unknowns of each rigid body come after those of all nodes (Model::body_dof).
[[nodiscard]] constexpr Index dof(Index node, int axis) {
  return 3 * node + axis;
}

/// Displacements that are given: dofs ascending, each with the value it has at the end of the step [mm]. A body can be
/// held where it is but not led: the value of its unknowns is 0.
struct Prescribed {
  std::vector<Index> dofs;
  std::vector<double> values;
};

}  // namespace facies::mechanics
