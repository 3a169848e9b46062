// SPDX-License-Identifier: Apache-2.0
// Muscles of the jaw: point-to-point Hill-type actuators (Flynn et al. 2015, which names the type; the force law is that
// of the authors' program). Theory: docs/theory/jaw.md.
#pragma once

#include <string>
#include <vector>

#include "facies/mechanics/anchor.hpp"

namespace facies::mechanics {

struct HillParameters {
  double max_force = 0.0;       ///< [mN]
  double optimal_length = 0.0;  ///< l_opt, where a full excitation gives max_force [mm]
  double max_length = 0.0;      ///< l_max, from where on the passive force is full [mm]
  double tendon_ratio = 0.0;    ///< part of l_opt that is tendon and does not contract, 0 <= t < 1
  double passive_fraction = 0.0;  ///< full passive force, as a part of max_force
  double damping = 0.0;           ///< force by rate of lengthening [mN s/mm]; none in statics
};

/// Force [mN] of a muscle at a length, its derivative by the length [mN/mm] and its integral from length 0 [uJ].
struct HillForce {
  double energy = 0.0;
  double force = 0.0;
  double stiffness = 0.0;
};

/// F = max_force (e f_act(l) + passive_fraction f_pas(l)) for excitation e, without damping:
/// f_act = (1 + cos 2 pi l_n) / 2 for 0.5 < l_n < 1.5, else 0, with l_n = (l - l_opt t) / (l_opt (1 - t));
/// f_pas = 0 below l_opt, 1 above l_max, linear between, its two corners rounded over one hundredth of l_max - l_opt to
/// either side, which changes it by at most 0.0025.
[[nodiscard]] HillForce hill_force(const HillParameters& muscle, double length, double excitation);

struct HillMuscle {
  std::string name;
  Anchor a, b;
  HillParameters parameters;
};

/// Pulls the two anchors of each muscle towards each other. Controls::excitation is in the order of the muscles.
class HillMuscles final : public Term {
 public:
  /// The model must outlive the term, which is usually one of its own. Throws DataError naming every muscle whose ends
  /// coincide when nothing has moved or whose parameters are impossible.
  HillMuscles(const Model& model, std::vector<HillMuscle> muscles);

  [[nodiscard]] std::string_view name() const override { return "muscles between points"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  [[nodiscard]] std::span<const HillMuscle> muscles() const { return muscles_; }
  /// Distance of the ends of muscle m [mm].
  [[nodiscard]] double length(const State& state, std::size_t m) const;
  /// Tension of muscle m [mN].
  [[nodiscard]] double force(const State& state, const Controls& controls, std::size_t m) const;

 private:
  [[nodiscard]] HillForce evaluate(const State& state, const Controls& controls,
                                   std::size_t m) const;

  const Model& model_;
  std::vector<HillMuscle> muscles_;
  std::vector<std::size_t> moving_;  // those with an end that has unknowns
};

}  // namespace facies::mechanics
