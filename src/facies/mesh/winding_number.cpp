// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/winding_number.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace facies::mesh {

double winding_number(std::span<const Vec3> X, std::span<const std::array<Index, 3>> triangles,
                      const Vec3& p) {
  std::vector<Vec3> directions;  // from p to the vertices
  directions.reserve(X.size());
  for (const Vec3& x : X)
    directions.push_back((x - p).normalized());
  // vanoosterom1983: tan(angle / 2) = a.(b x c) / (1 + a.b + b.c + c.a) for unit vectors.
  double half_angles = 0.0;
  for (const auto& [i, j, k] : triangles) {
    const Vec3& a = directions[at(i)];
    const Vec3& b = directions[at(j)];
    const Vec3& c = directions[at(k)];
    half_angles += std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return half_angles / (2.0 * std::numbers::pi);
}

}  // namespace facies::mesh
