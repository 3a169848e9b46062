// SPDX-License-Identifier: Apache-2.0
// Nodes that are tied to a rigid body: ligaments.
#pragma once

#include <vector>

#include "facies/mechanics/anchor.hpp"

namespace facies::mechanics {

/// Ties pairs of anchors together where they are when nothing has moved, by springs so stiff that they give way by micrometres:
/// E = stiffness/2 |x_a - x_b - (X_a - X_b)|^2. Elimination would give the same to within that, with tangents of
/// changed size in every term that touches such a node.
class Attachment final : public Term {
 public:
  struct Tie {
    Anchor a, b;
  };

  /// The model must outlive the term, which is usually one of its own. One end of each tie has unknowns. `stiffness`
  /// [mN/mm].
  Attachment(const Model& model, std::vector<Tie> ties, double stiffness)
      : model_(model), ties_(std::move(ties)), stiffness_(stiffness) {}

  [[nodiscard]] std::string_view name() const override { return "attachment"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  /// Nodes follow the body where it goes: on its circle, not on the tangent, and no farther than it.
  void bend(const State& from, std::span<const double> straight,
            std::span<double> increments) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  /// The largest distance that a tie has given way [mm].
  [[nodiscard]] double largest_gap(const State& state) const;

 private:
  [[nodiscard]] Vec3 gap(const State& state, const Tie& tie) const;

  const Model& model_;
  std::vector<Tie> ties_;
  double stiffness_;
};

}  // namespace facies::mechanics
