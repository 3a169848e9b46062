// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "facies/base/error.hpp"
#include "facies/base/parallel.hpp"
#include "facies/math/barrier.hpp"
#include "facies/math/continuous_collision.hpp"
#include "facies/math/point_triangle.hpp"

namespace facies::mechanics {

namespace {

/// No point comes nearer in one step than this part of its distance.
constexpr double kept_fraction = 0.1;

/// A point that may hit something goes no farther with respect to it in one step than this [mm]: what it may hit would be
/// too much to look at.
constexpr double longest_way = 6.0;

/// A point that is bent away from a bone keeps this part of d_hat from it, or of its distance where that is less.
constexpr double kept_gap = 0.6;
constexpr double kept_part = 0.5;

/// A trial state with anything beyond this has gone astray [mm].
constexpr double farthest = 1e9;

void sort_each_once(std::vector<Index>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

/// Points and surface at a state, in the frame of the surface where that is rigid: there it does not move.
struct Contact::Geometry {
  std::vector<Vec3> points;
  std::vector<Vec3> vertices;
  std::shared_ptr<const mesh::NearestTriangles> nearest;  // of the triangles alone
};

/// From there to another state, in the same frame.
struct Contact::Ways {
  std::vector<Vec3> points;
  std::vector<Vec3> vertices;
};

Contact::Contact(const Model& model, std::vector<ContactPoint> points, ContactSurface surface,
                 const ContactSettings& settings)
    : model_(model), points_(std::move(points)), surface_(std::move(surface)), settings_(settings) {
  require(!surface_.vertices.empty(), "a contact surface has vertices");
  const Anchor& first = surface_.vertices.front();
  const bool tissue = first.kind == Anchor::Kind::node;
  for (const Anchor& vertex : surface_.vertices) {
    require(vertex.kind == first.kind && (tissue || vertex.index == first.index),
            "a contact surface belongs to one body or to the tissue");
  }
  list_parts();
  list_own_parts();
  if (!is_rigid()) return;
  std::vector<Vec3> vertices;
  for (const Anchor& vertex : surface_.vertices)
    vertices.push_back(vertex.X);
  rigid_ = std::make_shared<const mesh::NearestTriangles>(vertices, surface_.triangles);
}

void Contact::list_parts() {
  std::map<std::pair<Index, Index>, std::vector<Index>> edges;  // with the triangles beside them
  std::map<Index, std::vector<Index>> vertices;
  for (const std::array<Index, 3>& triangle : surface_.triangles) {
    const Index number = to_index(parts_.size());
    parts_.push_back({triangle, 1.0});
    for (std::size_t k = 0; k < 3; ++k) {
      edges[std::minmax(triangle[k], triangle[(k + 1) % 3])].push_back(number);
      vertices[triangle[k]].push_back(number);
    }
  }
  rims_.resize(surface_.triangles.size());
  const auto add = [&](const Part& part, const std::vector<Index>& triangles) {
    for (const Index triangle : triangles)
      rims_[at(triangle)].push_back(to_index(parts_.size()));
    parts_.push_back(part);
  };
  for (const auto& [edge, beside] : edges) {
    const bool on_border = beside.size() == 1;
    if (on_border) {
      vertices.erase(edge.first);
      vertices.erase(edge.second);
    } else {
      add({{edge.first, edge.second, edge.second}, -1.0}, beside);
    }
  }
  for (const auto& [vertex, around] : vertices)
    add({{vertex, vertex, vertex}, 1.0}, around);
}

void Contact::list_own_parts() {
  own_.resize(points_.size());
  if (is_rigid()) return;
  std::map<Index, Index> vertex_of_node;
  for (std::size_t v = 0; v < surface_.vertices.size(); ++v)
    vertex_of_node[surface_.vertices[v].index] = to_index(v);
  std::vector<std::vector<Index>> around(surface_.vertices.size());  // triangles of a vertex
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    for (const Index vertex : surface_.triangles[t])
      around[at(vertex)].push_back(to_index(t));
  }
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Anchor& anchor = points_[p].anchor;
    if (anchor.kind != Anchor::Kind::node) continue;
    const auto vertex = vertex_of_node.find(anchor.index);
    if (vertex == vertex_of_node.end()) continue;
    std::vector<Index>& own = own_[p];
    for (const Index inner : around[at(vertex->second)]) {
      for (const Index corner : surface_.triangles[at(inner)])
        own.insert(own.end(), around[at(corner)].begin(), around[at(corner)].end());
    }
    sort_each_once(own);
    const std::vector<Index> triangles = own;
    for (const Index triangle : triangles)
      own.insert(own.end(), rims_[at(triangle)].begin(), rims_[at(triangle)].end());
    sort_each_once(own);
  }
}

double Contact::weight(const Pair& pair) const {
  return parts_[at(pair.part)].sign * points_[pair.point].area * settings_.stiffness;
}

bool Contact::is_rigid() const {
  return surface_.vertices.front().kind != Anchor::Kind::node;
}

Contact::Geometry Contact::places(const State& state) const {
  Geometry now;
  now.nearest = rigid_;
  const Anchor& first = surface_.vertices.front();
  for (const ContactPoint& point : points_) {
    Vec3 x = place_of(model_, state, point.anchor);
    if (first.kind == Anchor::Kind::body) {
      const RigidBody& body = model_.bodies()[at(first.index)];
      const Pose& pose = state.bodies[at(first.index)];
      x = body.centre + pose.R.transpose() * (x - body.centre - pose.u);
    }
    now.points.push_back(x);
  }
  for (const Anchor& vertex : surface_.vertices)
    now.vertices.push_back(is_rigid() ? vertex.X : place_of(model_, state, vertex));
  return now;
}

std::optional<Contact::Geometry> Contact::geometry(const State& state) const {
  Geometry now = places(state);
  const auto is_near = [](const Vec3& x) { return x.cwiseAbs().maxCoeff() < farthest; };
  if (!std::all_of(now.points.begin(), now.points.end(), is_near) ||
      !std::all_of(now.vertices.begin(), now.vertices.end(), is_near)) {
    return std::nullopt;
  }
  if (!is_rigid()) {
    now.nearest = std::make_shared<const mesh::NearestTriangles>(now.vertices, surface_.triangles);
  }
  return now;
}

Contact::Ways Contact::ways(const Geometry& from, const Geometry& to) {
  Ways ways{to.points, to.vertices};
  for (std::size_t p = 0; p < from.points.size(); ++p)
    ways.points[p] -= from.points[p];
  for (std::size_t v = 0; v < from.vertices.size(); ++v)
    ways.vertices[v] -= from.vertices[v];
  return ways;
}

/// Calls work(p) for every point, on several threads.
template <class Work>
void Contact::for_each_point(const Work& work) const {
  parallel_for(points_.size(), settings_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      work(p);
  });
}

std::vector<Contact::Pair> Contact::pairs(const State& state, double distance) const {
  const std::optional<Geometry> now = geometry(state);
  require(now.has_value(), "contact is looked at in states that have an energy");
  return pairs(*now, distance);
}

bool Contact::is_own(std::size_t point, Index part) const {
  return std::binary_search(own_[point].begin(), own_[point].end(), part);
}

ClosestOnTriangle Contact::closest(const Geometry& geometry, std::size_t point, Index part) const {
  const std::array<Index, 3>& corners = parts_[at(part)].corners;
  return closest_on_triangle(geometry.points[point], geometry.vertices[at(corners[0])],
                             geometry.vertices[at(corners[1])], geometry.vertices[at(corners[2])]);
}

/// All parts at most this far from a point, ascending. No edge or vertex is nearer than its triangles are.
std::vector<Index> Contact::parts_near(const Geometry& geometry, std::size_t point,
                                       double distance) const {
  std::vector<Index> near;
  geometry.nearest->within(geometry.points[point], distance, near);
  std::vector<Index> rims;
  for (const Index triangle : near)
    rims.insert(rims.end(), rims_[at(triangle)].begin(), rims_[at(triangle)].end());
  sort_each_once(rims);
  for (const Index part : rims) {
    if (closest(geometry, point, part).distance_squared <= distance * distance)
      near.push_back(part);
  }
  return near;
}

std::vector<Contact::Pair> Contact::pairs(const Geometry& geometry, double distance) const {
  std::vector<std::vector<Index>> near(points_.size());
  for_each_point([&](std::size_t p) {
    near[p] = parts_near(geometry, p, distance);
    std::erase_if(near[p], [&](Index part) { return is_own(p, part); });
  });
  std::vector<Pair> found;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    for (const Index part : near[p])
      found.push_back({p, part});
  }
  return found;
}

std::array<Anchor, 4> Contact::anchors_of(const Pair& pair) const {
  const std::array<Index, 3>& corners = parts_[at(pair.part)].corners;
  return {points_[pair.point].anchor, surface_.vertices[at(corners[0])],
          surface_.vertices[at(corners[1])], surface_.vertices[at(corners[2])]};
}

double Contact::energy(const State& state, const Controls& /*controls*/) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::optional<Geometry> somewhere = geometry(state);
  if (!somewhere) return infinite;
  const Geometry& now = *somewhere;
  double E = 0.0;
  for (const Pair& pair : pairs(now, settings_.d_hat)) {
    const double distance_squared = closest(now, pair.point, pair.part).distance_squared;
    if (distance_squared == 0.0) return infinite;
    E += weight(pair) * barrier(std::sqrt(distance_squared), settings_.d_hat).b;
  }
  return E;
}

std::optional<Contact::Touch> Contact::touch(const State& state, const Pair& pair) const {
  Touch touch;
  touch.anchors = anchors_of(pair);
  std::array<Vec3, 4> x;
  for (std::size_t k = 0; k < 4; ++k)
    x[k] = place_of(model_, state, touch.anchors[k]);
  if (closest_on_triangle(x[0], x[1], x[2], x[3]).distance_squared == 0.0) return std::nullopt;
  touch.distance = distance_response(x[0], x[1], x[2], x[3]);
  touch.barrier = barrier(touch.distance.d, settings_.d_hat);
  return touch;
}

bool Contact::add_residual(const State& state, const Controls& /*controls*/, std::span<double> r,
                           Inadmissible* /*why*/) const {
  const std::optional<Geometry> now = geometry(state);
  if (!now) return false;
  for (const Pair& pair : pairs(*now, settings_.d_hat)) {
    const std::optional<Touch> near = touch(state, pair);
    if (!near) return false;
    const double force = weight(pair) * near->barrier.db_dd;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto row = static_cast<Eigen::Index>(3 * k);
      add_gradient(model_, state, near->anchors[k], force * near->distance.gradient.segment<3>(row),
                   r);
    }
  }
  return true;
}

/// The farthest that a point goes with respect to any vertex of the surface [mm].
double Contact::relative_way(const Ways& ways, std::size_t p) const {
  const Vec3& way = ways.points[p];
  if (is_rigid()) return way.norm();
  double most_squared = 0.0;
  for (const Vec3& vertex : ways.vertices) {
    const double squared = (way - vertex).squaredNorm();
    if (!(squared < farthest * farthest)) return farthest;  // not a number, or as good as none
    most_squared = std::max(most_squared, squared);
  }
  return std::sqrt(most_squared);
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

/// The way of a point, turned so that it comes no nearer to any part that it would run into than it may in one step.
Vec3 Contact::way_around(const Geometry& from, std::size_t p, const Vec3& way) const {
  const std::vector<Index> near = parts_near(from, p, way.norm() + kept_gap * settings_.d_hat);
  Vec3 allowed = way;
  constexpr int sweeps = 3;  // what one part allows another may not
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const Index part : near) {
      const ClosestOnTriangle there = closest(from, p, part);
      const double distance = std::sqrt(there.distance_squared);
      const Vec3 outwards = there.offset / distance;
      const double kept = std::min(kept_gap * settings_.d_hat, kept_part * distance);
      const double too_far = kept - distance - outwards.dot(allowed);
      if (too_far > 0.0) allowed += too_far * outwards;
    }
  }
  return allowed;
}

void Contact::bend(const State& from, std::span<double> increments) const {
  if (!is_rigid()) return;
  const State to = model_.moved(from, increments, 1.0);
  const std::optional<Geometry> before = geometry(from);
  const std::optional<Geometry> after = geometry(to);
  if (!before || !after) return;
  const Ways straight = ways(*before, *after);
  const Anchor& first = surface_.vertices.front();
  const Mat3 R = first.kind == Anchor::Kind::body ? to.bodies[at(first.index)].R : Mat3::Identity();
  std::vector<Vec3> change(points_.size(), Vec3::Zero());
  for_each_point([&](std::size_t p) {
    if (points_[p].anchor.kind != Anchor::Kind::node) return;
    const Vec3& way = straight.points[p];
    if (safe_part(*before, straight, p) < 1.0) change[p] = R * (way_around(*before, p, way) - way);
  });
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (points_[p].anchor.kind != Anchor::Kind::node) continue;
    Eigen::Map<Vec3>(increments.data() + dof(points_[p].anchor.index, 0)) += change[p];
  }
}

double Contact::longest_step(const State& from, const State& to) const {
  const std::optional<Geometry> before = geometry(from);
  require(before.has_value(), "steps begin at states that have an energy");
  const Ways straight = ways(*before, places(to));
  std::vector<double> safe(points_.size(), 1.0);
  for_each_point([&](std::size_t p) { safe[p] = safe_part(*before, straight, p); });
  return std::accumulate(safe.begin(), safe.end(), 1.0,
                         [](double a, double b) { return std::min(a, b); });
}

/// The point that a run of pairs begins with, and the vertices of all its parts, each once.
Contact::Group Contact::group_of(std::span<const Pair> pairs) const {
  const std::size_t point = pairs.front().point;
  Group group;
  while (group.n_pairs < pairs.size() && pairs[group.n_pairs].point == point) {
    const std::array<Index, 3>& corners = parts_[at(pairs[group.n_pairs].part)].corners;
    group.vertices.insert(group.vertices.end(), corners.begin(), corners.end());
    ++group.n_pairs;
  }
  sort_each_once(group.vertices);
  group.anchors.push_back(points_[point].anchor);
  for (const Index vertex : group.vertices)
    group.anchors.push_back(surface_.vertices[at(vertex)]);
  return group;
}

void Contact::push_groups(std::span<const Pair> pairs, Stencils& stencils) const {
  while (!pairs.empty()) {
    const Group group = group_of(pairs);
    stencils.push_back(dofs_of(model_, group.anchors));
    pairs = pairs.subspan(group.n_pairs);
  }
}

void Contact::list_stencils(const State& state, Stencils& stencils) const {
  push_groups(pairs(state, settings_.d_hat), stencils);
}

void Contact::likely_stencils(const State& state, Stencils& stencils) const {
  push_groups(pairs(state, settings_.reach), stencils);
}

/// Derivatives by the places of the group's anchors, summed over its pairs: the sum is what has a sign, edges take back
/// what triangles give twice.
Eigen::MatrixXd Contact::group_tangent(const State& state, const Group& group,
                                       std::span<const Pair> pairs) const {
  const auto n = static_cast<Eigen::Index>(3 * group.anchors.size());
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n);
  for (const Pair& pair : pairs.first(group.n_pairs)) {
    const std::optional<Touch> near = touch(state, pair);
    require(near.has_value(), "tangents are wanted at admissible states");
    const DistanceResponse& d = near->distance;
    const double dE = weight(pair) * near->barrier.db_dd;
    const double d2E = weight(pair) * near->barrier.d2b_dd2;
    const auto place =
        [&](std::size_t k) -> Eigen::Index {  // of the pair's k-th place in the group
      if (k == 0) return 0;
      const Index vertex = parts_[at(pair.part)].corners[k - 1];
      const auto found = std::lower_bound(group.vertices.begin(), group.vertices.end(), vertex);
      return 3 * (1 + (found - group.vertices.begin()));
    };
    for (std::size_t a = 0; a < 4; ++a) {
      const auto row = static_cast<Eigen::Index>(3 * a);
      gradient.segment<3>(place(a)) += dE * d.gradient.segment<3>(row);
      for (std::size_t b = 0; b < 4; ++b) {
        const auto column = static_cast<Eigen::Index>(3 * b);
        hessian.block<3, 3>(place(a), place(b)) +=
            d2E * d.gradient.segment<3>(row) * d.gradient.segment<3>(column).transpose() +
            dE * d.hessian.block<3, 3>(row, column);
      }
    }
  }
  return pull_back(model_, state, group.anchors, gradient, hessian);
}

void Contact::add_tangent(const State& state, const Controls& /*controls*/, TangentSink& K) const {
  const std::vector<Pair> near = pairs(state, settings_.d_hat);
  std::span<const Pair> left = near;
  for (std::size_t number = 0; !left.empty(); ++number) {
    const Group group = group_of(left);
    const Eigen::MatrixXd block = group_tangent(state, group, left);
    K.add(number, {block.data(), static_cast<std::size_t>(block.size())});
    left = left.subspan(group.n_pairs);
  }
}

ContactReport Contact::report(const State& state) const {
  ContactReport report;
  report.smallest_distance = std::numeric_limits<double>::infinity();
  std::vector<double> pressure(points_.size(), 0.0);
  for (const Pair& pair : pairs(state, settings_.d_hat)) {
    const std::optional<Touch> near = touch(state, pair);
    if (!near) continue;
    const double force = weight(pair) * near->barrier.db_dd;
    pressure[pair.point] -= force / points_[pair.point].area;
    report.smallest_distance = std::min(report.smallest_distance, near->distance.d);
    report.force += force * near->distance.gradient.head<3>();
  }
  for (const double p : pressure) {
    if (p > 0.0) ++report.n_points;
    report.largest_pressure = std::max(report.largest_pressure, p);
  }
  return report;
}

}  // namespace facies::mechanics
