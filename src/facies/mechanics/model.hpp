// SPDX-License-Identifier: Apache-2.0
// The model: a mesh and the terms that act on it. Const once built.
#pragma once

#include <memory>
#include <vector>

#include "facies/mechanics/term.hpp"

namespace facies::mechanics {

class Model {
 public:
  explicit Model(std::size_t n_nodes) : n_nodes_(n_nodes) {}

  [[nodiscard]] std::size_t n_nodes() const { return n_nodes_; }
  [[nodiscard]] std::size_t n_dofs() const { return 3 * n_nodes_; }
  [[nodiscard]] std::span<const std::unique_ptr<const Term>> terms() const { return terms_; }

  /// Adds a term; the reference stays valid as long as the model.
  template <class T>
  const T& add(std::unique_ptr<T> term) {
    const T& reference = *term;
    terms_.push_back(std::move(term));
    return reference;
  }

  /// The undeformed state.
  [[nodiscard]] State initial_state() const { return {std::vector<Vec3>(n_nodes_, Vec3::Zero())}; }

  /// Total energy [uJ]; +infinity for an inadmissible state.
  [[nodiscard]] double energy(const State& state, const Controls& controls) const;

  /// r = internal - external [n_dofs] [mN]. False where the state is inadmissible.
  [[nodiscard]] bool residual(const State& state, const Controls& controls, std::span<double> r,
                              Inadmissible* why = nullptr) const;

  /// Where an admissible state lies beyond what the laws hold for (Term::overgrown); element -1: nowhere.
  [[nodiscard]] Inadmissible overgrown(const State& state) const;

 private:
  std::size_t n_nodes_;
  std::vector<std::unique_ptr<const Term>> terms_;
};

}  // namespace facies::mechanics
