// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/model.hpp"

#include <algorithm>

#include "facies/base/error.hpp"

namespace facies::mechanics {

double Model::energy(const State& state, const Controls& controls) const {
  double total = 0.0;
  for (const auto& term : terms_)
    total += term->energy(state, controls);
  return total;
}

bool Model::residual(const State& state, const Controls& controls, std::span<double> r,
                     Inadmissible* why) const {
  require(r.size() == n_dofs(), "a residual has one entry per unknown");
  std::fill(r.begin(), r.end(), 0.0);
  return std::all_of(terms_.begin(), terms_.end(),
                     [&](const auto& term) { return term->add_residual(state, controls, r, why); });
}

}  // namespace facies::mechanics
