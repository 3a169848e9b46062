// SPDX-License-Identifier: Apache-2.0
// What takes energy out of a motion: Rayleigh's damping of the tissue, friction of bodies with their surroundings, viscosity of
// muscles between points. Nothing of it acts in statics.
//
// Each is a force c times the rate at the end of the step (TimeStep::rate), with the incremental potential h/4 c rate^2.
#pragma once

#include "facies/mechanics/hill_muscle.hpp"
#include "facies/mechanics/solid.hpp"

namespace facies::mechanics {

/// C = alpha M + beta K+ (Rayleigh 1877): M lumped, K+ the tangent of the solid at the beginning of the step, element
/// by element without its negative eigenvalues, so that it never drives a motion.
class RayleighDamping final : public Term {
 public:
  /// Masses [n_nodes] [kg], alpha [1/s], beta [s]. The solid must outlive the term.
  RayleighDamping(const Solid& solid, std::vector<double> mass, double alpha, double beta);

  [[nodiscard]] std::string_view name() const override { return "Rayleigh damping"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;
  [[nodiscard]] bool dissipates() const override { return true; }
  void begin(const Controls& controls, TimeStep& step) const override;

 private:
  [[nodiscard]] std::vector<double> rates(const State& state, const TimeStep& step) const;
  [[nodiscard]] std::size_t n_elements() const { return block_begin_.size() - 1; }

  const Solid& solid_;
  std::vector<double> mass_;
  double alpha_;
  double beta_;
  Stencils stencils_;                     // of the elements, then of the nodes
  std::vector<std::size_t> block_begin_;  // [n_elements + 1] among the numbers that are kept
};

/// A body in something viscous: force -translational v at its centre, moment -rotational omega.
struct BodyFriction {
  double translational = 0.0;  ///< [kg/s]
  double rotational = 0.0;     ///< [kg mm^2/s]
};

class BodyDamping final : public Term {
 public:
  /// One per body of the model, which must outlive the term.
  BodyDamping(const Model& model, std::vector<BodyFriction> friction);

  [[nodiscard]] std::string_view name() const override { return "friction of bodies"; }
  /// The part that begins with the velocity at the beginning turns and has no energy; as in Inertia.
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;
  [[nodiscard]] bool dissipates() const override { return true; }

 private:
  const Model& model_;
  std::vector<BodyFriction> friction_;
};

/// HillParameters::damping times the rate of lengthening, against it.
class MuscleDamping final : public Term {
 public:
  /// Both must outlive the term.
  MuscleDamping(const Model& model, const HillMuscles& muscles);

  [[nodiscard]] std::string_view name() const override { return "viscosity of muscles"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;
  [[nodiscard]] bool dissipates() const override { return true; }

  /// Rate of lengthening of muscle m at the end of the step [mm/s].
  [[nodiscard]] double rate(const State& state, const TimeStep& step, std::size_t m) const;

 private:
  const Model& model_;
  const HillMuscles& muscles_;
  std::vector<std::size_t> damped_;  // those that move and have damping
};

}  // namespace facies::mechanics
