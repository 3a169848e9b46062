// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/skin_sites.hpp"

#include <algorithm>

#include "facies/math/point_triangle.hpp"

namespace facies::anatomy {
namespace {

constexpr int levels = 2;
/// A view from the front goes this far at a time [mm]: few triangles are near a short segment.
constexpr double step = 20.0;

}  // namespace

SkinSites::SkinSites(const Cage& skin) : refined_(mesh::limit_mesh(skin.net, levels)) {
  X_ = mesh::weighted(refined_.limit, mesh::control_points_through(skin.net, skin.points));
  triangles_ = mesh::cut_into_triangles(refined_.net);
  tree_ = std::make_unique<mesh::NearestTriangles>(X_, triangles_);
  const auto [front, back] =
      std::ranges::minmax_element(X_, {}, [](const Vec3& x) { return x.x(); });
  front_ = front->x();
  back_ = back->x();
}

std::optional<SkinSite> SkinSites::find(double lateral, double up) const {
  std::optional<Vec3> place;
  for (double x = front_ - 0.5 * step; !place && x < back_; x += step) {
    const Vec3 from(x, lateral, up);
    const std::vector<double> passes = tree_->passes(from, from + step * Vec3::UnitX());
    if (!passes.empty()) place = from + passes.front() * step * Vec3::UnitX();
  }
  if (!place) return std::nullopt;
  const std::array<Index, 3>& t = triangles_[at(tree_->nearest(*place).triangle)];
  return SkinSite{
      t, closest_on_triangle(*place, X_[at(t[0])], X_[at(t[1])], X_[at(t[2])]).barycentric};
}

}  // namespace facies::anatomy
