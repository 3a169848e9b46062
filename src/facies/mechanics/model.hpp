// SPDX-License-Identifier: Apache-2.0
// The model: nodes and rigid bodies, and the terms that act on them. Const once built.
#pragma once

#include <memory>
#include <vector>

#include "facies/mechanics/term.hpp"

namespace facies::mechanics {

/// Unknowns of a rigid body: the way of its centre, then its rotation in space times RigidBody::arm, all in mm.
inline constexpr std::size_t dofs_of_body = 6;

class Model {
 public:
  explicit Model(std::size_t n_nodes, std::vector<RigidBody> bodies = {})
      : n_nodes_(n_nodes), bodies_(std::move(bodies)) {}

  [[nodiscard]] std::size_t n_nodes() const { return n_nodes_; }
  [[nodiscard]] std::span<const RigidBody> bodies() const { return bodies_; }
  [[nodiscard]] std::size_t n_dofs() const { return 3 * n_nodes_ + dofs_of_body * bodies_.size(); }
  /// Unknown number of component 0..5 of a body.
  [[nodiscard]] Index body_dof(Index body, int component) const {
    return to_index(3 * n_nodes_ + dofs_of_body * at(body)) + component;
  }
  [[nodiscard]] std::span<const std::unique_ptr<const Term>> terms() const { return terms_; }

  /// Adds a term; the reference stays valid as long as the model.
  template <class T>
  const T& add(std::unique_ptr<T> term) {
    const T& reference = *term;
    terms_.push_back(std::move(term));
    return reference;
  }

  /// The undeformed state.
  [[nodiscard]] State initial_state() const {
    return {std::vector<Vec3>(n_nodes_, Vec3::Zero()), std::vector<Pose>(bodies_.size())};
  }

  /// The state after a further `ratio` times these increments of the unknowns [n_dofs] [mm].
  [[nodiscard]] State moved(const State& state, std::span<const double> increments,
                            double ratio) const;

  /// `ratio` times these increments [n_dofs] [mm], bent by all terms in their order.
  [[nodiscard]] std::vector<double> bent(const State& state, std::span<const double> increments,
                                         double ratio) const;

  /// What is held or led has this value [mm]: a node's displacement; 0 for a body.
  [[nodiscard]] double value_of(const State& state, Index dof) const;

  /// Total energy [uJ]; +infinity for an inadmissible state.
  [[nodiscard]] double energy(const State& state, const Controls& controls) const;

  /// r = internal - external [n_dofs] [mN]. False where the state is inadmissible.
  [[nodiscard]] bool residual(const State& state, const Controls& controls, std::span<double> r,
                              Inadmissible* why = nullptr) const;

  /// That part of the residual which takes energy out of a motion [n_dofs] [mN]; the state is admissible.
  void damping(const State& state, const Controls& controls, std::span<double> r) const;

  /// Where an admissible state lies beyond what the laws hold for (Term::overgrown); element -1: nowhere.
  [[nodiscard]] Inadmissible overgrown(const State& state) const;

  /// How much of the straight way from one state to the other can be gone without anything passing through something else,
  /// 0..1; what Term::longest_step says of it.
  [[nodiscard]] double longest_step(const State& from, const State& to) const;

 private:
  std::size_t n_nodes_;
  std::vector<RigidBody> bodies_;
  std::vector<std::unique_ptr<const Term>> terms_;
};

}  // namespace facies::mechanics
