// SPDX-License-Identifier: Apache-2.0
// Closed surfaces with known geometry.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "facies/mesh/triangle_surface.hpp"

namespace facies::mesh {

/// A box of these half lengths about the origin, two triangles a side, normals outwards.
inline TriangleSurface box(const Vec3& half) {
  TriangleSurface surface;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                      (i & 4) != 0 ? 1.0 : -1.0);
    surface.X.emplace_back(corner.cwiseProduct(half));
  }
  surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return surface;
}

/// A sphere about the origin: an octahedron, each triangle cut into four `cuts` times, vertices on the sphere.
inline TriangleSurface sphere(double radius, int cuts) {
  TriangleSurface surface{
      {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitZ()},
      {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index i, Index j) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax({i, j}), to_index(surface.X.size()));
      if (is_new) surface.X.emplace_back((surface.X[at(i)] + surface.X[at(j)]).normalized());
      return entry->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [i, j, k] : surface.triangles) {
      const Index ij = middle(i, j);
      const Index jk = middle(j, k);
      const Index ki = middle(k, i);
      finer.insert(finer.end(), {{i, ij, ki}, {ij, j, jk}, {ki, jk, k}, {ij, jk, ki}});
    }
    surface.triangles = std::move(finer);
  }
  for (Vec3& x : surface.X)
    x *= radius;
  return surface;
}

/// Both surfaces as one, the second moved by `shift`.
inline TriangleSurface together(TriangleSurface first, const TriangleSurface& second,
                                const Vec3& shift) {
  const Index offset = to_index(first.X.size());
  for (const Vec3& x : second.X)
    first.X.emplace_back(x + shift);
  for (const auto& t : second.triangles)
    first.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return first;
}

}  // namespace facies::mesh
