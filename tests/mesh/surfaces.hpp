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

/// A square blade in the plane x, y of side 2 `half`, `cells` by `cells`, twisted to z = twist x y: two walls `thickness`
/// apart that meet in a rim, closed, normals outwards. Their squares are cut along different diagonals, so that the walls
/// run through each other where the blade is thinner than twist (2 half / cells)^2 / 2, as those of scanned bones do.
inline TriangleSurface blade(double half, int cells, double twist, double thickness) {
  TriangleSurface surface;
  const int n = cells + 1;
  for (const double side : {0.5, -0.5}) {
    for (int i = 0; i < n * n; ++i) {
      const double x = half * (2.0 * (i % n) / cells - 1.0);
      const double y = half * (2.0 * (i / n) / cells - 1.0);
      surface.X.emplace_back(x, y, twist * x * y + side * thickness);
    }
  }
  const auto wall = [&](int i, int j, int side) { return Index{side * n * n + j * n + i}; };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      surface.triangles.push_back({wall(i, j, 0), wall(i + 1, j, 0), wall(i, j + 1, 0)});
      surface.triangles.push_back({wall(i + 1, j, 0), wall(i + 1, j + 1, 0), wall(i, j + 1, 0)});
      surface.triangles.push_back({wall(i, j, 1), wall(i + 1, j + 1, 1), wall(i + 1, j, 1)});
      surface.triangles.push_back({wall(i, j, 1), wall(i, j + 1, 1), wall(i + 1, j + 1, 1)});
    }
  }
  const auto rim = [&](int i, int j, int k, int l) {
    surface.triangles.push_back({wall(i, j, 0), wall(i, j, 1), wall(k, l, 1)});
    surface.triangles.push_back({wall(i, j, 0), wall(k, l, 1), wall(k, l, 0)});
  };
  for (int i = 0; i < cells; ++i) {
    rim(i, 0, i + 1, 0);
    rim(cells, i, cells, i + 1);
    rim(i + 1, cells, i, cells);
    rim(0, i + 1, 0, i);
  }
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
