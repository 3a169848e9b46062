// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "facies/base/error.hpp"
#include "facies/math/barrier.hpp"
#include "facies/math/point_triangle.hpp"
#include "facies/mechanics/contact_geometry.hpp"

namespace facies::mechanics {

namespace {

void sort_each_once(std::vector<Index>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

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

/// Nothing where a point has gone astray.
std::shared_ptr<const Contact::Scene> Contact::scene(const State& state) const {
  const Geometry here = places(state);
  const std::lock_guard<std::mutex> lock(recent_.mutex);
  for (std::shared_ptr<const Scene>& recent : recent_.scenes) {
    if (recent && recent->geometry.points == here.points &&
        recent->geometry.vertices == here.vertices) {
      std::swap(recent, recent_.scenes.front());
      return recent_.scenes.front();
    }
  }
  std::optional<Geometry> now = geometry(state);
  if (!now) return nullptr;
  std::vector<Pair> near = pairs(*now, settings_.d_hat);
  recent_.scenes.back() = std::make_shared<const Scene>(Scene{std::move(*now), std::move(near)});
  std::swap(recent_.scenes.front(), recent_.scenes.back());
  return recent_.scenes.front();
}

std::shared_ptr<const Contact::Scene> Contact::known(const State& state) const {
  std::shared_ptr<const Scene> now = scene(state);
  require(now != nullptr, "contact is looked at in states that have an energy");
  return now;
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
  const std::shared_ptr<const Scene> now = scene(state);
  if (!now) return infinite;
  double E = 0.0;
  for (const Pair& pair : now->near) {
    const double distance_squared = closest(now->geometry, pair.point, pair.part).distance_squared;
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
  const std::shared_ptr<const Scene> now = scene(state);
  if (!now) return false;
  for (const Pair& pair : now->near) {
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
  push_groups(known(state)->near, stencils);
}

void Contact::likely_stencils(const State& state, Stencils& stencils) const {
  push_groups(pairs(known(state)->geometry, settings_.reach), stencils);
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
  const std::shared_ptr<const Scene> now = known(state);
  std::span<const Pair> left = now->near;
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
  const std::shared_ptr<const Scene> now = known(state);
  for (const Pair& pair : now->near) {
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
