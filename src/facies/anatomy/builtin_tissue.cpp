// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_tissue.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/even_shell.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::anatomy {
namespace {

constexpr double most_skin = 0.3;         // of a column's length
constexpr double flattest_corner = 0.05;  // a scaled Jacobian

/// How often the drawing's net is refined.
int levels_of(FaceSize size) {
  return static_cast<int>(size);
}

int elements_per_layer(FaceSize size) {
  return size == FaceSize::finer ? 4 : size == FaceSize::fine ? 2 : 1;
}

/// Skin of its `thickness` [mm, for each vertex] where there is room for it, the rest of each column in two equal layers of fat.
mesh::ShellParts parts_of(const mesh::Shell& shell, const std::vector<double>& thickness,
                          int per_layer) {
  mesh::ShellParts parts(static_cast<std::size_t>(3 * per_layer) + 1);
  for (std::size_t v = 0; v < shell.outer.size(); ++v) {
    const double length = (shell.inner[v] - shell.outer[v]).norm();
    const double skin = std::min(thickness[v], most_skin * length) / std::max(length, 1e-30);
    const std::array<double, 4> borders{0.0, skin, 0.5 * (skin + 1.0), 1.0};
    for (std::size_t depth = 0; depth < parts.size(); ++depth) {
      const auto layer = std::min<std::size_t>(depth / static_cast<std::size_t>(per_layer), 2);
      const double within = static_cast<double>(depth) / per_layer - static_cast<double>(layer);
      parts[depth].push_back(borders.at(layer) +
                             within * (borders.at(layer + 1) - borders.at(layer)));
    }
  }
  return parts;
}

/// How much farther than to the drawn inner surface a column looks for bone.
constexpr double look_farther = 1.3;
constexpr double look_at_least = 4.0;  // [mm]

/// For each column that meets a bone: in front of the bone that it meets first, by `gap` [mm].
std::vector<mesh::HalfSpace> sides_of(const mesh::Shell& shell,
                                      const std::vector<mesh::TriangleSurface>& bones, double gap) {
  std::vector<mesh::HalfSpace> sides(shell.outer.size());
  std::vector<double> nearest(shell.outer.size(), std::numeric_limits<double>::infinity());
  for (const mesh::TriangleSurface& bone : bones) {
    const mesh::NearestTriangles tree(bone.X, bone.triangles);
    for (std::size_t v = 0; v < shell.outer.size(); ++v) {
      const Vec3 column = shell.inner[v] - shell.outer[v];
      if (column.isZero()) continue;
      const double reach = std::max(look_farther, 1.0 + look_at_least / column.norm());
      const std::vector<double> passes =
          tree.passes(shell.outer[v], shell.outer[v] + reach * column);
      if (passes.empty() || passes.front() >= nearest[v]) continue;
      nearest[v] = passes.front();
      const Vec3 place = shell.outer[v] + passes.front() * reach * column;
      const auto& [a, b, c] = bone.triangles[at(tree.nearest(place).triangle)];
      Vec3 normal =
          (bone.X[at(b)] - bone.X[at(a)]).cross(bone.X[at(c)] - bone.X[at(a)]).normalized();
      if (normal.dot(column) > 0.0) normal = -normal;
      sides[v] = {place + gap * normal, normal};
    }
  }
  return sides;
}

/// Points of a mirrored drawing are symmetric to rounding.
bool are_symmetric(const Cage& skin, const std::vector<Vec3>& points) {
  constexpr double rounding = 1e-6;  // [mm]
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& twin = points[at(skin.mirrored[i])];
    if ((points[i] - Vec3(twin.x(), -twin.y(), twin.z())).norm() > rounding) return false;
  }
  return true;
}

/// The mean of points and their mirror image.
std::vector<Vec3> made_symmetric(const Cage& skin, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& twin = points[at(skin.mirrored[i])];
    result.push_back(0.5 * (points[i] + Vec3(twin.x(), -twin.y(), twin.z())));
  }
  return result;
}

/// Control points of the evened inner surface.
std::vector<Vec3> even(const Cage& skin, const mesh::Shell& shell, const BuiltinTissue& tissue,
                       const std::vector<mesh::TriangleSurface>& bones, double gap) {
  mesh::EvenShellOptions options;
  options.sides = sides_of(shell, bones, gap);
  std::vector<Vec3> control =
      mesh::even_inner_surface(shell, tissue.limit.limit, tissue.inner_control, options);
  // The search for the least ends a few micrometres from it, elsewhere on the one side than on the other.
  const bool is_symmetric =
      are_symmetric(skin, tissue.outer_control) && are_symmetric(skin, tissue.inner_control);
  return is_symmetric ? made_symmetric(skin, control) : control;
}

void check_shape(const mesh::Shell& shell) {
  const mesh::WorstCorner worst = mesh::worst_corner(shell);
  if (worst.scaled_jacobian >= flattest_corner) return;
  const Vec3& x = shell.outer[at(shell.net.quads[at(worst.quad)][0])];
  throw DataError(
      {{"builtin",
        fmt::format("an element with a flat corner (scaled Jacobian {:.2f}) near ({:.0f}, {:.0f}, "
                    "{:.0f}) mm",
                    worst.scaled_jacobian, x.x(), x.y(), x.z()),
        fmt::format("{:g} at least", flattest_corner), "choose measures nearer to the presets"}});
}

}  // namespace

BuiltinTissue make_tissue(const Cage& skin, const std::vector<Vec3>& outer,
                          const std::vector<Vec3>& inner, const std::vector<double>& thickness,
                          const std::vector<mesh::TriangleSurface>& bones, double gap,
                          FaceSize size) {
  BuiltinTissue tissue;
  tissue.limit = mesh::limit_mesh(skin.net, levels_of(size));
  tissue.outer_control = mesh::control_points_through(skin.net, outer);
  tissue.inner_control = mesh::control_points_through(skin.net, inner);
  const int per_layer = elements_per_layer(size);
  tissue.n_deep = 3 * per_layer;
  mesh::Shell shell;
  shell.net = tissue.limit.net;
  shell.outer = mesh::weighted(tissue.limit.limit, tissue.outer_control);
  shell.inner = mesh::weighted(tissue.limit.limit, tissue.inner_control);
  // As control points: what is between them stays between their values.
  const std::vector<double> skin_at = mesh::weighted(tissue.limit.limit, thickness);
  shell.parts = parts_of(shell, skin_at, per_layer);
  tissue.inner_control = even(skin, shell, tissue, bones, gap);
  shell.inner = mesh::weighted(tissue.limit.limit, tissue.inner_control);
  shell.parts = parts_of(shell, skin_at, per_layer);
  check_shape(shell);
  std::vector<mesh::ShellLayer> layers;
  for (const std::string& name : layer_names())
    layers.push_back({name, per_layer});
  tissue.mesh = mesh::make_layered_shell(shell, layers);
  return tissue;
}

}  // namespace facies::anatomy
