// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/secant.hpp"

#include <cmath>
#include <numeric>

namespace facies::solve {

namespace {

/// Cosine between a step and the change of the residual below which the pair says nothing but rounding.
constexpr double least_cosine = 1e-10;

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void add(double factor, std::span<const double> a, std::span<double> sum) {
  for (std::size_t k = 0; k < a.size(); ++k)
    sum[k] += factor * a[k];
}

}  // namespace

void SecantPairs::learn(std::vector<double> step, std::vector<double> change) {
  const double work = dot(step, change);
  const double lengths = std::sqrt(dot(step, step) * dot(change, change));
  if (!(work > least_cosine * lengths)) return;
  pairs_.push_back({std::move(step), std::move(change), work});
  if (pairs_.size() > most_) pairs_.pop_front();
}

/// The two loops of nocedal1980.
void SecantPairs::solve(std::span<const double> rhs, const Inverse& inverse,
                        std::span<double> x) const {
  std::vector<double> left(rhs.begin(), rhs.end());
  std::vector<double> alpha(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    alpha[k] = dot(pairs_[k].step, left) / pairs_[k].work;
    add(-alpha[k], pairs_[k].change, left);
  }
  inverse(left, x);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double beta = dot(pairs_[k].change, x) / pairs_[k].work;
    add(alpha[k] - beta, pairs_[k].step, x);
  }
}

}  // namespace facies::solve
