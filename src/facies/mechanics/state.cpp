// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/state.hpp"

#include <algorithm>

#include "facies/base/error.hpp"

namespace facies::mechanics {

namespace {

Vec3 force_or_zero(const std::vector<Vec3>& force, std::size_t node) {
  return force.empty() ? Vec3(Vec3::Zero()) : force[node];
}

}  // namespace

Controls interpolate(const Controls& a, const Controls& b, double s) {
  require(a.activation.size() == b.activation.size(), "both controls must drive the same muscles");
  Controls result;
  result.activation.resize(a.activation.size());
  for (std::size_t m = 0; m < a.activation.size(); ++m) {
    result.activation[m] = (1.0 - s) * a.activation[m] + s * b.activation[m];
  }
  result.gravity = (1.0 - s) * a.gravity + s * b.gravity;
  result.nodal_force.resize(std::max(a.nodal_force.size(), b.nodal_force.size()));
  for (std::size_t node = 0; node < result.nodal_force.size(); ++node) {
    result.nodal_force[node] =
        (1.0 - s) * force_or_zero(a.nodal_force, node) + s * force_or_zero(b.nodal_force, node);
  }
  return result;
}

}  // namespace facies::mechanics
