// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/state.hpp"

#include <algorithm>

#include "facies/base/error.hpp"

namespace facies::mechanics {

namespace {

/// The list on the straight line from `a` to `b`; an empty one counts as `zero`.
template <class T>
std::vector<T> between(const std::vector<T>& a, const std::vector<T>& b, double s, const T& zero) {
  std::vector<T> result(std::max(a.size(), b.size()), zero);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const T& from = a.empty() ? zero : a[i];
    const T& to = b.empty() ? zero : b[i];
    result[i] = (1.0 - s) * from + s * to;
  }
  return result;
}

bool fit(std::size_t a, std::size_t b) {
  return a == b || a == 0 || b == 0;
}

}  // namespace

Controls interpolate(const Controls& a, const Controls& b, double s) {
  require(a.activation.size() == b.activation.size(), "both controls must drive the same muscles");
  require(fit(a.excitation.size(), b.excitation.size()),
          "both controls must drive the same point-to-point muscles");
  require(fit(a.nodal_force.size(), b.nodal_force.size()),
          "both controls must load the same nodes");
  Controls result;
  result.activation = between(a.activation, b.activation, s, 0.0);
  result.excitation = between(a.excitation, b.excitation, s, 0.0);
  result.gravity = (1.0 - s) * a.gravity + s * b.gravity;
  result.body_gravity = (1.0 - s) * a.body_gravity + s * b.body_gravity;
  result.nodal_force = between(a.nodal_force, b.nodal_force, s, Vec3(Vec3::Zero()));
  return result;
}

}  // namespace facies::mechanics
