// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/triangle_surface.hpp"

#include <algorithm>
#include <map>

#include <Eigen/Geometry>

#include "facies/math/point_triangle.hpp"
#include "facies/math/segment_triangle.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::mesh {
namespace {

using Triangle = std::array<Index, 3>;
using Corners = std::array<Vec3, 3>;

void require_sound(const TriangleSurface& surface) {
  for (const Vec3& x : surface.X)
    require(x.allFinite(), "a surface has a vertex whose coordinates are not finite");
  for (const Triangle& triangle : surface.triangles) {
    for (const Index vertex : triangle)
      require(vertex >= 0 && at(vertex) < surface.X.size(),
              "a triangle of a surface names a vertex that does not exist");
  }
}

Corners corners_of(const TriangleSurface& surface, const Triangle& triangle) {
  return {surface.X[at(triangle[0])], surface.X[at(triangle[1])], surface.X[at(triangle[2])]};
}

/// How often triangles run along an edge from the smaller vertex number to the larger, and back.
struct EdgeUse {
  int forward = 0;
  int backward = 0;
};

void check_edges(const TriangleSurface& surface, SurfaceReport& report) {
  std::map<VertexPair, EdgeUse> uses;
  for (const Triangle& t : surface.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k];
      const Index to = t[(k + 1) % 3];
      EdgeUse& use = uses[{std::min(from, to), std::max(from, to)}];
      ++(from < to ? use.forward : use.backward);
    }
  }
  for (const auto& [edge, use] : uses) {
    const int n = use.forward + use.backward;
    if (n == 1) report.border_edges.push_back(edge);
    if (n > 2) report.crowded_edges.push_back(edge);
    if (n == 2 && use.forward != 1) report.inconsistent_edges.push_back(edge);
  }
}

bool pierces(const Vec3& p, const Vec3& q, const Corners& x) {
  return segment_through_triangle(p, q, x[0], x[1], x[2]).has_value();
}

bool intersect(const Corners& x, const Corners& y) {
  for (const Vec3& a : x) {
    for (const Vec3& b : y) {
      if (a == b) return false;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (pierces(x[k], x[(k + 1) % 3], y) || pierces(y[k], y[(k + 1) % 3], x)) return true;
  }
  return false;
}

void check_intersections(const TriangleSurface& surface, SurfaceReport& report) {
  const NearestTriangles tree(surface.X, surface.triangles);
  std::vector<bool> is_flat(surface.triangles.size(), false);
  for (const Index triangle : report.flat_triangles)
    is_flat[at(triangle)] = true;
  std::vector<Index> near;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (is_flat[i]) continue;
    const Corners x = corners_of(surface, surface.triangles[i]);
    const Vec3 middle = (x[0] + x[1] + x[2]) / 3.0;
    const double radius =
        std::max({(x[0] - middle).norm(), (x[1] - middle).norm(), (x[2] - middle).norm()});
    tree.within(middle, radius, near);
    for (const Index other : near) {
      if (at(other) <= i || is_flat[at(other)]) continue;
      if (intersect(x, corners_of(surface, surface.triangles[at(other)])))
        report.intersections.push_back({to_index(i), other});
    }
  }
}

}  // namespace

TriangleSurface merge_coincident_vertices(const TriangleSurface& surface) {
  require_sound(surface);
  std::map<std::array<double, 3>, Index> known;
  std::vector<Index> renumbered;
  TriangleSurface merged;
  for (const Vec3& x : surface.X) {
    const auto [entry, is_new] =
        known.try_emplace({x.x(), x.y(), x.z()}, to_index(merged.X.size()));
    if (is_new) merged.X.push_back(x);
    renumbered.push_back(entry->second);
  }
  for (const Triangle& t : surface.triangles)
    merged.triangles.push_back({renumbered[at(t[0])], renumbered[at(t[1])], renumbered[at(t[2])]});
  return merged;
}

SurfaceReport check_surface(const TriangleSurface& surface) {
  require_sound(surface);
  SurfaceReport report;
  if (surface.X.empty()) return report;
  report.lower = report.upper = surface.X[0];
  for (const Vec3& x : surface.X) {
    report.lower = report.lower.cwiseMin(x);
    report.upper = report.upper.cwiseMax(x);
  }
  check_edges(surface, report);
  const Vec3 middle = 0.5 * (report.lower + report.upper);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Corners x = corners_of(surface, surface.triangles[i]);
    if (is_flat(x[0], x[1], x[2])) report.flat_triangles.push_back(to_index(i));
    report.volume += (x[0] - middle).dot((x[1] - middle).cross(x[2] - middle)) / 6.0;
  }
  check_intersections(surface, report);
  return report;
}

}  // namespace facies::mesh
