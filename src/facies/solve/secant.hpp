// SPDX-License-Identifier: Apache-2.0
// What steps that were taken teach about the stiffness between two factorisations.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace facies::solve {

/// Limited-memory BFGS (liu1989) on top of any factor: an inverse stiffness H that is symmetric, positive definite where the
/// factor's is, and answers the change of residual of the last step with that step.
class SecantPairs {
 public:
  /// The last `most` steps are remembered.
  explicit SecantPairs(std::size_t most) : most_(most) {}

  void forget() { pairs_.clear(); }

  /// A step [n] and the change of the residual along it [n]. One along which the residual's work did not grow is passed by:
  /// it would make H indefinite.
  void learn(std::vector<double> step, std::vector<double> change);

  /// Solves with the factor: x [n] from a right-hand side [n].
  using Inverse = std::function<void(std::span<const double> rhs, std::span<double> x)>;

  /// x = H rhs.
  void solve(std::span<const double> rhs, const Inverse& inverse, std::span<double> x) const;

 private:
  struct Pair {
    std::vector<double> step;
    std::vector<double> change;
    double work = 0.0;  // step . change
  };

  std::size_t most_;
  std::deque<Pair> pairs_;  // the oldest first
};

}  // namespace facies::solve
