// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "facies/base/error.hpp"
#include "facies/math/barrier.hpp"
#include "facies/math/continuous_collision.hpp"
#include "facies/math/point_triangle.hpp"

namespace facies::mechanics {

namespace {

/// No point comes nearer in one step than this part of its distance.
constexpr double kept_fraction = 0.1;

/// A point that may hit something goes no farther in one step than this [mm]: what it may hit would be too much to look at.
constexpr double longest_way = 3.0;

/// A trial state with anything beyond this has gone astray [mm].
constexpr double farthest = 1e9;

}  // namespace

/// Points and surface at a state, in the frame of the surface where that is rigid: there it does not move.
struct Contact::Geometry {
  std::vector<Vec3> points;
  std::vector<Vec3> vertices;
  std::shared_ptr<const mesh::NearestTriangles> nearest;
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
  list_surroundings();
  if (!is_rigid()) return;
  std::vector<Vec3> vertices;
  for (const Anchor& vertex : surface_.vertices)
    vertices.push_back(vertex.X);
  rigid_ = std::make_shared<const mesh::NearestTriangles>(vertices, corners_);
}

void Contact::list_parts() {
  std::map<std::pair<Index, Index>, int> edges;
  for (const std::array<Index, 3>& triangle : surface_.triangles) {
    parts_.push_back({triangle, 1.0});
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[std::minmax(triangle[k], triangle[(k + 1) % 3])];
  }
  std::set<Index> inside;
  for (const std::array<Index, 3>& triangle : surface_.triangles)
    inside.insert(triangle.begin(), triangle.end());
  for (const auto& [edge, n_triangles] : edges) {
    if (n_triangles > 1) {
      parts_.push_back({{edge.first, edge.second, edge.second}, -1.0});
    } else {
      inside.erase(edge.first);
      inside.erase(edge.second);
    }
  }
  for (const Index vertex : inside)
    parts_.push_back({{vertex, vertex, vertex}, 1.0});
  for (const Part& part : parts_)
    corners_.push_back(part.corners);
}

void Contact::list_surroundings() {
  surroundings_.resize(points_.size());
  if (is_rigid()) return;
  std::map<Index, Index> vertex_of_node;
  for (std::size_t v = 0; v < surface_.vertices.size(); ++v)
    vertex_of_node[surface_.vertices[v].index] = to_index(v);
  std::vector<std::set<Index>> around(surface_.vertices.size());
  for (const std::array<Index, 3>& triangle : surface_.triangles) {
    for (const Index vertex : triangle)
      around[at(vertex)].insert(triangle.begin(), triangle.end());
  }
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Anchor& anchor = points_[p].anchor;
    if (anchor.kind != Anchor::Kind::node) continue;
    const auto own = vertex_of_node.find(anchor.index);
    if (own == vertex_of_node.end()) continue;
    const std::set<Index>& vertices = around[at(own->second)];
    surroundings_[p].assign(vertices.begin(), vertices.end());
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
    now.nearest = std::make_shared<const mesh::NearestTriangles>(now.vertices, corners_);
  }
  return now;
}

std::vector<Contact::Pair> Contact::pairs(const State& state, double distance) const {
  const std::optional<Geometry> now = geometry(state);
  require(now.has_value(), "contact is looked at in states that have an energy");
  return pairs(*now, distance);
}

bool Contact::is_own(std::size_t point, Index part) const {
  const std::vector<Index>& around = surroundings_[point];
  const std::array<Index, 3>& corners = corners_[at(part)];
  return std::any_of(corners.begin(), corners.end(), [&](Index corner) {
    return std::binary_search(around.begin(), around.end(), corner);
  });
}

std::vector<Contact::Pair> Contact::pairs(const Geometry& geometry, double distance) const {
  std::vector<Pair> found;
  std::vector<Index> near;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    geometry.nearest->within(geometry.points[p], distance, near);
    for (const Index part : near) {
      if (!is_own(p, part)) found.push_back({p, part});
    }
  }
  return found;
}

std::array<Anchor, 4> Contact::anchors_of(const Pair& pair) const {
  const std::array<Index, 3>& corners = corners_[at(pair.part)];
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
    const std::array<Index, 3>& corners = corners_[at(pair.part)];
    const ClosestOnTriangle closest =
        closest_on_triangle(now.points[pair.point], now.vertices[at(corners[0])],
                            now.vertices[at(corners[1])], now.vertices[at(corners[2])]);
    if (closest.distance_squared == 0.0) return infinite;
    E += weight(pair) * barrier(std::sqrt(closest.distance_squared), settings_.d_hat).b;
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

/// How much of its way point `p` can go; `surface_way` is the farthest that a vertex of the surface goes [mm].
double Contact::safe_part(const Geometry& from, const Geometry& to, std::size_t p,
                          double surface_way) const {
  const Vec3 way = to.points[p] - from.points[p];
  const double reach = way.norm() + surface_way;
  if (reach == 0.0) return 1.0;
  if (!(reach < farthest)) return 0.0;
  std::vector<Index> near;
  const double looked_at = std::min(1.0, longest_way / reach);
  from.nearest->within(from.points[p], looked_at * reach, near);
  double safe = looked_at;
  for (const Index part : near) {
    if (is_own(p, part) || parts_[at(part)].corners[1] == parts_[at(part)].corners[2]) continue;
    const std::array<Index, 3>& corners = corners_[at(part)];
    const auto start = [&](std::size_t k) { return from.vertices[at(corners[k])]; };
    const auto motion = [&](std::size_t k) -> Vec3 {
      return looked_at * (to.vertices[at(corners[k])] - from.vertices[at(corners[k])]);
    };
    safe = std::min(safe, looked_at * safe_time({from.points[p], start(0), start(1), start(2)},
                                                {looked_at * way, motion(0), motion(1), motion(2)},
                                                kept_fraction));
  }
  // Nothing is near on the part looked at; beyond it something may be.
  if (safe == looked_at && looked_at < 1.0) {
    from.nearest->within(from.points[p], reach, near);
    const bool alone =
        std::all_of(near.begin(), near.end(), [&](Index part) { return is_own(p, part); });
    return alone ? 1.0 : looked_at;
  }
  return safe;
}

double Contact::longest_step(const State& from, const State& to) const {
  const std::optional<Geometry> here = geometry(from);
  require(here.has_value(), "steps begin at states that have an energy");
  const Geometry& before = *here;
  const Geometry after = places(to);
  double surface_way = 0.0;
  for (std::size_t v = 0; v < before.vertices.size(); ++v)
    surface_way = std::max(surface_way, (after.vertices[v] - before.vertices[v]).norm());
  double step = 1.0;
  for (std::size_t p = 0; p < points_.size(); ++p)
    step = std::min(step, safe_part(before, after, p, surface_way));
  return step;
}

/// Groups of unknowns: over a bone one per point, since all parts of a bone hang on the same; else one per pair.
void Contact::push_groups(const std::vector<Pair>& pairs, Stencils& stencils) const {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const bool same_group = is_rigid() && k > 0 && pairs[k].point == pairs[k - 1].point;
    if (!same_group) stencils.push_back(dofs_of(model_, anchors_of(pairs[k])));
  }
}

void Contact::list_stencils(const State& state, Stencils& stencils) const {
  push_groups(pairs(state, settings_.d_hat), stencils);
}

void Contact::likely_stencils(const State& state, Stencils& stencils) const {
  push_groups(pairs(state, settings_.reach), stencils);
}

Eigen::MatrixXd Contact::pair_tangent(const State& state, const Pair& pair) const {
  const std::optional<Touch> near = touch(state, pair);
  require(near.has_value(), "tangents are wanted at admissible states");
  const DistanceResponse& d = near->distance;
  const Eigen::VectorXd gradient = weight(pair) * near->barrier.db_dd * d.gradient;
  const Eigen::MatrixXd hessian =
      weight(pair) * (near->barrier.d2b_dd2 * d.gradient * d.gradient.transpose() +
                      near->barrier.db_dd * d.hessian);
  return pull_back(model_, state, near->anchors, gradient, hessian);
}

void Contact::add_tangent(const State& state, const Controls& /*controls*/, TangentSink& K) const {
  const std::vector<Pair> near = pairs(state, settings_.d_hat);
  std::size_t group = 0;
  for (std::size_t k = 0; k < near.size();) {
    Eigen::MatrixXd block = pair_tangent(state, near[k]);
    // Summed here, not in the matrix: the sum is what has a sign, edges take back what triangles give twice.
    const std::size_t point = near[k].point;
    for (++k; is_rigid() && k < near.size() && near[k].point == point; ++k)
      block += pair_tangent(state, near[k]);
    K.add(group++, {block.data(), static_cast<std::size_t>(block.size())});
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
