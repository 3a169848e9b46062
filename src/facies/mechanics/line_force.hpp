// SPDX-License-Identifier: Apache-2.0
// Forces along the line between two anchors that depend on its length: muscles and what damps them.
#pragma once

#include "facies/mechanics/anchor.hpp"

namespace facies::mechanics {

/// From b to a [mm].
[[nodiscard]] Vec3 line_between(const Model& model, const State& state, const Anchor& a,
                                const Anchor& b);

/// Adds the residual of a tension [mN] that pulls the anchors together. They are apart.
void add_tension(const Model& model, const State& state, const Anchor& a, const Anchor& b,
                 double tension, std::span<double> r);

/// The tangent by dofs_of({a, b}) of a tension with this derivative by the length [mN/mm].
[[nodiscard]] Eigen::MatrixXd tension_tangent(const Model& model, const State& state,
                                              const Anchor& a, const Anchor& b, double tension,
                                              double stiffness);

}  // namespace facies::mechanics
