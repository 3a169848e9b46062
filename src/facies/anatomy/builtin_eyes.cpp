// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_eyes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace facies::anatomy {
namespace {

/// Half the axial length of an adult's eyeball, and the film of tears between it and the lids [mm] (Bron et al., Wolff's Anatomy of the
/// Eye and Orbit, 8th ed.: 24 mm).
constexpr double eyeball_radius = 12.0;
constexpr double gap_to_eyeball = 0.1;

}  // namespace

std::vector<Eye> place_eyes(const Drawings& drawings, const BuiltinTissue& tissue) {
  const auto node = [&](const std::string& point, int depth) {
    return mesh::shell_node(tissue.limit.net, drawings.skin.index.at(point), depth);
  };
  const auto x = [&](const std::string& point, int depth) {
    return tissue.mesh.X()[at(node(point, depth))];
  };
  Eye eye;
  eye.radius = eyeball_radius;
  eye.centre = 0.5 * (x("eye0.6", 0) + x("eye0.14", 0));
  eye.centre.z() = 0.5 * (x("eye0.2", 0).z() + x("eye0.10", 0).z());
  eye.centre.x() = -std::numeric_limits<double>::infinity();
  const double reach = eyeball_radius + gap_to_eyeball;
  for (const char* ring : {"eye0", "eye1"}) {
    for (int k = 0; k < 16; ++k) {
      const Vec3 lid = x(fmt::format("{}.{}", ring, k), tissue.n_deep);
      const double aside = (lid - eye.centre).tail<2>().norm();
      if (aside < reach)
        eye.centre.x() =
            std::max(eye.centre.x(), lid.x() + std::sqrt(reach * reach - aside * aside));
    }
  }
  const Eye left{{eye.centre.x(), -eye.centre.y(), eye.centre.z()}, eye.radius};
  return {eye, left};
}

}  // namespace facies::anatomy
