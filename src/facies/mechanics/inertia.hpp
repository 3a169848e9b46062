// SPDX-License-Identifier: Apache-2.0
// Mass: lumped at nodes, and of rigid bodies with their full inertia. What it does in a time step, and what it says of a motion.
#pragma once

#include "facies/mechanics/model.hpp"
#include "facies/mechanics/time_step.hpp"

namespace facies::mechanics {

/// In a time step: the force of inertia TimeStep::inertia * mass_way(from, state) - TimeStep::push. In statics: nothing.
///
/// Vectors over unknowns hold for a body the part of its centre, then that of its rotation in space by or times its arm, so that
/// momenta [mN s] times velocities [mm/s] are energies [uJ].
class Inertia final : public Term {
 public:
  /// Places X [mm] and masses [kg] of the nodes [n_nodes]. The model must outlive the term, which is usually one of its own.
  Inertia(const Model& model, std::vector<Vec3> X, std::vector<double> mass);

  [[nodiscard]] std::string_view name() const override { return "inertia"; }
  /// A part of `push` that turns has no energy; its work along the rotation vector stands for it.
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  [[nodiscard]] const Model& model() const { return model_; }

  /// Mass times way [n_dofs] [kg mm]: over the time, the mean momentum; for rotations TurnResponse::moment.
  [[nodiscard]] std::vector<double> mass_way(const State& from, const State& to) const;

  /// Ways of all unknowns from one state to another [n_dofs] [mm].
  [[nodiscard]] std::vector<double> way(const State& from, const State& to) const;

  /// Velocities [n_dofs] [mm/s] of momenta [n_dofs] [mN s]; 0 where there is no mass.
  [[nodiscard]] std::vector<double> velocity(const State& state,
                                             std::span<const double> momentum) const;

  /// Accelerations [n_dofs] [mm/s^2] where the momenta change at this rate [n_dofs] [mN].
  [[nodiscard]] std::vector<double> acceleration(const State& state,
                                                 std::span<const double> momentum,
                                                 std::span<const double> rate) const;

  [[nodiscard]] double kinetic_energy(const State& state, std::span<const double> momentum) const;
  [[nodiscard]] Vec3 linear_momentum(std::span<const double> momentum) const;
  /// About the origin [mN mm s].
  [[nodiscard]] Vec3 angular_momentum(const State& state, std::span<const double> momentum) const;

 private:
  /// Mass and rotational inertia, turned into space and divided by the square of the arm, of a body.
  [[nodiscard]] Mat3 inertia_in_space(const State& state, std::size_t body) const;

  const Model& model_;
  std::vector<Vec3> X_;
  std::vector<double> mass_;
};

}  // namespace facies::mechanics
