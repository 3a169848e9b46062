// SPDX-License-Identifier: Apache-2.0
// Dead loads: gravity, and forces given at nodes (reactions that are ramped out).
#pragma once

#include "facies/mechanics/term.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::mechanics {

/// Masses lumped to the nodes [n_nodes] [kg]: the integral of density N_a over the stress-free volume. `density`
/// [n_elements] [kg/mm^3] is that of the stress-free tissue; F0 as in SolidDescription (empty: identity).
[[nodiscard]] std::vector<double> lumped_mass(const mesh::Mesh& mesh,
                                              std::span<const double> density,
                                              std::span<const Mat3> F0);

/// Weight of nodes under Controls::gravity and of rigid bodies under Controls::body_gravity.
class Gravity final : public Term {
 public:
  /// mass [n_nodes] [kg]; `bodies` all those of the model, or none: they then have no weight.
  explicit Gravity(std::vector<double> mass, std::span<const RigidBody> bodies = {});

  [[nodiscard]] std::string_view name() const override { return "gravity"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  [[nodiscard]] std::span<const double> mass() const { return mass_; }

 private:
  std::vector<double> mass_;
  std::vector<double> body_mass_;
};

/// The forces of Controls::nodal_force.
class NodalForces final : public Term {
 public:
  [[nodiscard]] std::string_view name() const override { return "nodal forces"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
};

}  // namespace facies::mechanics
