// SPDX-License-Identifier: Apache-2.0
// How far points can go in a step, and how their ways bend before what they would run into.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "facies/base/error.hpp"
#include "facies/math/continuous_collision.hpp"
#include "facies/math/point_triangle.hpp"
#include "facies/mechanics/contact_geometry.hpp"

namespace facies::mechanics {

namespace {

/// No point comes nearer in one step than this part of its distance.
constexpr double kept_fraction = 0.1;

/// A point that may hit something goes no farther with respect to it in one step than this [mm]: what it may hit would be
/// too much to look at.
constexpr double longest_way = 6.0;

/// How deep a point may get into the layer d_hat of a surface in one step: this part of it, or twice as deep as it is. It is
/// felt as about four times the force: what Newton's method foresees of a barrier holds no farther.
constexpr double first_depth = 0.1;
constexpr double deeper = 2.0;

/// A point never loses more than this part of its distance in one step.
constexpr double kept_part = 0.5;

}  // namespace

Contact::Ways Contact::ways(const Geometry& from, const Geometry& to) {
  Ways ways{to.points, to.vertices, {}, {}};
  for (std::size_t p = 0; p < from.points.size(); ++p)
    ways.points[p] -= from.points[p];
  for (std::size_t v = 0; v < from.vertices.size(); ++v)
    ways.vertices[v] -= from.vertices[v];
  ways.least = ways.most = ways.vertices.front();
  for (const Vec3& way : ways.vertices) {
    ways.least = ways.least.cwiseMin(way);
    ways.most = ways.most.cwiseMax(way);
    if (!way.allFinite()) return {ways.points, ways.vertices, way, way};
  }
  return ways;
}

/// At least as far as a point goes with respect to any vertex of the surface [mm].
double Contact::relative_way(const Ways& ways, std::size_t p) {
  const Vec3& way = ways.points[p];
  const double reach = (way - ways.least).cwiseAbs().cwiseMax((ways.most - way).cwiseAbs()).norm();
  return reach < farthest ? reach : farthest;  // neither where it is not a number
}

/// How much of its way point `p` can go.
double Contact::safe_part(const Geometry& from, const Ways& ways, std::size_t p) const {
  const double reach = relative_way(ways, p);
  if (reach == 0.0) return 1.0;
  if (!(reach < farthest)) return 0.0;
  std::vector<Index>
      near;  // triangles: nothing comes to their edges and vertices before it comes to them
  const double looked_at = std::min(1.0, longest_way / reach);
  from.nearest->within(from.points[p], looked_at * reach, near);
  double safe = looked_at;
  for (const Index triangle : near) {
    if (is_own(p, triangle)) continue;
    const auto [a, b, c] = surface_.triangles[at(triangle)];
    const PointAndTriangle start{from.points[p], from.vertices[at(a)], from.vertices[at(b)],
                                 from.vertices[at(c)]};
    const PointAndTriangle motion{looked_at * ways.points[p], looked_at * ways.vertices[at(a)],
                                  looked_at * ways.vertices[at(b)],
                                  looked_at * ways.vertices[at(c)]};
    safe = std::min(safe, looked_at * safe_time(start, motion, kept_fraction));
  }
  // Nothing is near on the part looked at; beyond it something may be.
  if (safe == looked_at && looked_at < 1.0) {
    from.nearest->within(from.points[p], reach, near);
    const bool alone =
        std::all_of(near.begin(), near.end(), [&](Index triangle) { return is_own(p, triangle); });
    return alone ? 1.0 : looked_at;
  }
  return safe;
}

/// The triangle within `reach` of a point that is nearest to it, of those that it feels; where there is one.
std::optional<Contact::Nearest> Contact::nearest_within(const Geometry& geometry, std::size_t p,
                                                        double reach) const {
  std::vector<Index> near;
  geometry.nearest->within(geometry.points[p], reach, near);
  std::optional<Nearest> nearest;
  for (const Index triangle : near) {
    if (is_own(p, triangle)) continue;
    const ClosestOnTriangle here = closest(geometry, p, triangle);
    const double distance = std::sqrt(here.distance_squared);
    if (!nearest || distance < nearest->distance) nearest = {distance, here.offset};
  }
  return nearest;
}

/// The distance that point `p` keeps in a step [mm].
double Contact::kept_gap(const Geometry& from, std::size_t p) const {
  const double d_hat = settings_.d_hat;
  const std::optional<Nearest> nearest = nearest_within(from, p, d_hat);
  const double distance = nearest ? nearest->distance : d_hat;
  const double depth = std::max(first_depth * d_hat, deeper * (d_hat - distance));
  return std::max(d_hat - depth, kept_part * distance);
}

/// What point and surface have to do of a way that keeps them apart: bone nothing; of tissue, whose nodes are points as
/// well, each half.
double Contact::share() const {
  return is_rigid() ? 1.0 : 0.5;
}

/// The way of a point, turned so that it comes no nearer than `gap` to any part that it would run into.
Vec3 Contact::way_around(const Geometry& from, const Ways& straight, std::size_t p,
                         double gap) const {
  const Vec3& way = straight.points[p];
  const double reach = std::min(relative_way(straight, p), longest_way);
  std::vector<Index> near = parts_near(from, p, reach + gap);
  std::erase_if(near, [&](Index part) { return is_own(p, part); });
  Vec3 allowed = way;
  constexpr int sweeps = 3;  // what one part allows another may not
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const Index part : near) {
      const ClosestOnTriangle there = closest(from, p, part);
      Vec3 approach = way;  // to what is nearest
      for (std::size_t k = 0; k < 3; ++k)
        approach -= there.barycentric[static_cast<Eigen::Index>(k)] *
                    straight.vertices[at(parts_[at(part)].corners[k])];
      const double distance = std::sqrt(there.distance_squared);
      const Vec3 outwards = there.offset / distance;
      const double closing = -outwards.dot(approach);
      const double too_far = closing - (distance - std::min(gap, distance));
      const double missing = share() * too_far - outwards.dot(allowed - way);
      if (too_far > 0.0 && missing > 0.0) allowed += missing * outwards;
    }
  }
  return allowed;
}

/// What lifts the end of a point's way to `gap` above what it comes nearest to.
Vec3 Contact::lift(const Geometry& to, std::size_t p, double gap) const {
  const std::optional<Nearest> nearest = nearest_within(to, p, gap);
  if (!nearest || nearest->distance == 0.0) return Vec3::Zero();
  return share() * (gap / nearest->distance - 1.0) * nearest->offset;
}

void Contact::bend(const State& from, std::span<const double> /*straight*/,
                   std::span<double> increments) const {
  const State to = model_.moved(from, increments, 1.0);
  const std::shared_ptr<const Scene> scene_before = scene(from);
  const std::optional<Geometry> after = geometry(to);
  if (!scene_before || !after) return;
  const Geometry& before = scene_before->geometry;
  const Ways straight = ways(before, *after);
  const Anchor& first = surface_.vertices.front();
  const Mat3 R = first.kind == Anchor::Kind::body ? to.bodies[at(first.index)].R : Mat3::Identity();
  std::vector<Vec3> change(points_.size(), Vec3::Zero());
  for_each_point([&](std::size_t p) {
    if (points_[p].anchor.kind != Anchor::Kind::node) return;
    const double gap = kept_gap(before, p);
    const bool is_free = safe_part(before, straight, p) == 1.0;
    change[p] = R * (is_free ? lift(*after, p, gap)
                             : way_around(before, straight, p, gap) - straight.points[p]);
  });
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (points_[p].anchor.kind != Anchor::Kind::node) continue;
    Eigen::Map<Vec3>(increments.data() + dof(points_[p].anchor.index, 0)) += change[p];
  }
}

double Contact::longest_step(const State& from, const State& to) const {
  const std::shared_ptr<const Scene> before = known(from);
  const Ways straight = ways(before->geometry, places(to));
  std::vector<double> safe(points_.size(), 1.0);
  for_each_point([&](std::size_t p) { safe[p] = safe_part(before->geometry, straight, p); });
  return std::accumulate(safe.begin(), safe.end(), 1.0,
                         [](double a, double b) { return std::min(a, b); });
}

}  // namespace facies::mechanics
