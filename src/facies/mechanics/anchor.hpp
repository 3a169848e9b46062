// SPDX-License-Identifier: Apache-2.0
// Points that forces act on, whatever they belong to: derivatives by their places become residuals and tangents by the
// unknowns of the model.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "facies/mechanics/model.hpp"

namespace facies::mechanics {

/// A place in space, a node of the mesh, or a point of a rigid body.
struct Anchor {
  enum class Kind { space, node, body };
  Kind kind = Kind::space;
  Index index = -1;       ///< of the node or the body
  Vec3 X = Vec3::Zero();  ///< where it is when nothing has moved [mm]

  [[nodiscard]] static Anchor in_space(const Vec3& X) { return {Kind::space, -1, X}; }
  [[nodiscard]] static Anchor on_node(Index node, const Vec3& X) { return {Kind::node, node, X}; }
  [[nodiscard]] static Anchor on_body(Index body, const Vec3& X) { return {Kind::body, body, X}; }
};

/// Where the anchor is now [mm].
[[nodiscard]] Vec3 place_of(const Model& model, const State& state, const Anchor& anchor);

/// How far these increments of the unknowns [n_dofs] take the anchor in first order [mm].
[[nodiscard]] Vec3 way_of(const Model& model, const State& state, const Anchor& anchor,
                          std::span<const double> increments);

/// Adds the residual of an energy whose derivative by the anchor's place is `dE_dx` [mN] to r [n_dofs].
void add_gradient(const Model& model, const State& state, const Anchor& anchor, const Vec3& dE_dx,
                  std::span<double> r);

/// The unknowns that the anchors hang on, each once: first those of nodes, then of bodies, in the order of the anchors.
[[nodiscard]] std::vector<Index> dofs_of(const Model& model, std::span<const Anchor> anchors);

/// The second derivative by dofs_of(anchors) of an energy with the given first [3k] and second [3k, 3k] derivatives by the
/// anchors' places: J^T H J and what the curvature of rotations adds. For unknown rotations w of a body this is the
/// second derivative of E(exp([w]) R) at w = 0, which is symmetric; the tangent of the moments differs from it by a
/// part proportional to the total moment, which vanishes in equilibrium.
[[nodiscard]] Eigen::MatrixXd pull_back(const Model& model, const State& state,
                                        std::span<const Anchor> anchors,
                                        const Eigen::VectorXd& gradient,
                                        const Eigen::MatrixXd& hessian);

}  // namespace facies::mechanics
