// SPDX-License-Identifier: Apache-2.0
// Embree finds candidates in single precision, with a search radius that is larger than all its rounding; distances in
// double precision decide.
#include "facies/mesh/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <type_traits>

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

#include "facies/base/error.hpp"
#include "facies/math/point_triangle.hpp"
#include "facies/math/segment_triangle.hpp"

namespace facies::mesh {
namespace {

using Triangle = std::array<Index, 3>;

/// Embree drops what is larger than about 2e18.
constexpr double largest_coordinate = 1e15;
/// Rounding in Embree as a part of the coordinates: 2^-24 for each number, with a margin.
constexpr double single_rounding = 1e-6;

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Tree = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

Tree make_tree(RTCDevice device, std::span<const Vec3> X, std::span<const Triangle> triangles) {
  Tree tree(rtcNewScene(device));
  // Contact builds a tree for every state that it looks at: four times as fast to build, queries hardly slower.
  rtcSetSceneBuildQuality(tree.get(), RTC_BUILD_QUALITY_LOW);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), X.size()));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.size()));
  for (const Vec3& x : X) {
    for (const double coordinate : x)
      *positions++ = static_cast<float>(coordinate);
  }
  for (const Triangle& triangle : triangles) {
    for (const Index vertex : triangle)
      *corners++ = static_cast<std::uint32_t>(vertex);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(tree.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree.get());
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw std::runtime_error("the search tree (Embree) cannot take the surface");
  return tree;
}

void check(std::span<const Vec3> X, std::span<const Triangle> triangles) {
  for (const Vec3& x : X) {
    // Written so that NaN fails.
    require((x.array().abs() < largest_coordinate).all(),
            "NearestTriangles: a coordinate is not finite or too large");
  }
  for (const Triangle& triangle : triangles) {
    for (const Index vertex : triangle)
      require(vertex >= 0 && at(vertex) < X.size(),
              "NearestTriangles: a triangle names a vertex that does not exist");
  }
}

/// The unit normal; zero for a flat triangle.
Vec3 unit_normal(const std::array<Vec3, 3>& x) {
  if (is_flat(x[0], x[1], x[2])) return Vec3::Zero();
  return (x[1] - x[0]).cross(x[2] - x[0]).normalized();
}

/// The angle of the triangle at its corner `k`.
double angle_at(const std::array<Vec3, 3>& x, std::size_t k) {
  const Vec3 a = x[(k + 1) % 3] - x[k];
  const Vec3 b = x[(k + 2) % 3] - x[k];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

struct NearestTriangles::Parts {
  std::vector<Vec3> X;
  std::vector<Triangle> triangles;
  /// Triangles around vertex v: around[first[v]] to around[first[v + 1] - 1].
  std::vector<std::size_t> first;
  std::vector<Index> around;
  std::vector<Eigen::AlignedBox3d> boxes;  ///< around the triangles
  double size = 0.0;                       ///< largest coordinate
  Device device;
  Tree tree;

  void link_vertices();
  void put_into_boxes();

  [[nodiscard]] std::array<Vec3, 3> corners(Index triangle) const {
    const Triangle& t = triangles[at(triangle)];
    return {X[at(t[0])], X[at(t[1])], X[at(t[2])]};
  }
  [[nodiscard]] ClosestOnTriangle closest(Index triangle, const Vec3& point) const {
    const std::array<Vec3, 3> x = corners(triangle);
    return closest_on_triangle(point, x[0], x[1], x[2]);
  }
  /// A radius for Embree that misses nothing at most `radius` away.
  [[nodiscard]] float search_radius(const Vec3& point, double radius) const {
    const double scale = size + point.cwiseAbs().maxCoeff() + radius;
    return static_cast<float>(radius + single_rounding * scale);
  }
  [[nodiscard]] Vec3 pseudonormal(Index triangle, TriangleFeature feature) const;
  void query(const Vec3& point, float radius, RTCPointQueryFunction function, void* search) const;
};

void NearestTriangles::Parts::link_vertices() {
  first.assign(X.size() + 1, 0);
  for (const Triangle& triangle : triangles) {
    for (const Index vertex : triangle)
      ++first[at(vertex) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  around.resize(3 * triangles.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Index vertex : triangles[i])
      around[next[at(vertex)]++] = to_index(i);
  }
}

void NearestTriangles::Parts::put_into_boxes() {
  boxes.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Index vertex : triangles[i])
      boxes[i].extend(X[at(vertex)]);
  }
}

/// baerentzen2005: the normal of a face, the sum of those at an edge, their sum weighted with the angles at a vertex.
Vec3 NearestTriangles::Parts::pseudonormal(Index triangle, TriangleFeature feature) const {
  if (feature == TriangleFeature::face) return unit_normal(corners(triangle));
  const bool is_edge = feature <= TriangleFeature::edge2;
  const std::size_t k = std::size_t(feature) -
                        std::size_t(is_edge ? TriangleFeature::edge0 : TriangleFeature::vertex0);
  const Index vertex = triangles[at(triangle)][k];
  const Index other = triangles[at(triangle)][(k + 1) % 3];
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = first[at(vertex)]; i < first[at(vertex) + 1]; ++i) {
    const Triangle& t = triangles[at(around[i])];
    const std::array<Vec3, 3> x = corners(around[i]);
    if (!is_edge) {
      sum += angle_at(x, std::size_t(std::ranges::find(t, vertex) - t.begin())) * unit_normal(x);
    } else if (std::ranges::find(t, other) != t.end()) {
      sum += unit_normal(x);
    }
  }
  return sum;
}

void NearestTriangles::Parts::query(const Vec3& point, float radius, RTCPointQueryFunction function,
                                    void* search) const {
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x());
  query.y = static_cast<float>(point.y());
  query.z = static_cast<float>(point.z());
  query.radius = radius;
  RTCPointQueryContext context{};
  rtcInitPointQueryContext(&context);
  rtcPointQuery(tree.get(), &query, &context, function, search);
}

NearestTriangles::NearestTriangles(std::span<const Vec3> X, std::span<const Triangle> triangles) {
  check(X, triangles);
  auto parts = std::make_unique<Parts>();
  parts->X.assign(X.begin(), X.end());
  parts->triangles.assign(triangles.begin(), triangles.end());
  parts->link_vertices();
  parts->put_into_boxes();
  for (const Vec3& x : X)
    parts->size = std::max(parts->size, x.cwiseAbs().maxCoeff());
  parts->device = Device(rtcNewDevice("threads=1,user_threads=1"));
  if (!parts->device) throw std::runtime_error("cannot start the search tree (Embree)");
  parts->tree = make_tree(parts->device.get(), X, triangles);
  parts_ = std::move(parts);
}

NearestTriangles::NearestTriangles(NearestTriangles&&) noexcept = default;
NearestTriangles& NearestTriangles::operator=(NearestTriangles&&) noexcept = default;
NearestTriangles::~NearestTriangles() = default;

void NearestTriangles::within(const Vec3& point, double radius,
                              std::vector<Index>& triangles) const {
  struct Search {
    const Parts& parts;
    const Vec3& point;
    double radius_squared;
    double too_far_squared;
    std::vector<Index>& found;
  };
  triangles.clear();
  if (!(radius >= 0.0)) return;
  const float too_far = parts_->search_radius(point, radius);
  Search search{*parts_, point, radius * radius, double{too_far} * too_far, triangles};
  const auto add = [](RTCPointQueryFunctionArguments* candidate) {
    auto& s = *static_cast<Search*>(candidate->userPtr);
    const auto triangle = static_cast<Index>(candidate->primID);
    // Embree tells whole leaves of its tree; most triangles in them are too far as their boxes are.
    if (s.parts.boxes[at(triangle)].squaredExteriorDistance(s.point) > s.too_far_squared)
      return false;
    if (s.parts.closest(triangle, s.point).distance_squared <= s.radius_squared)
      s.found.push_back(triangle);
    return false;
  };
  parts_->query(point, too_far, add, &search);
  std::ranges::sort(triangles);
}

std::vector<double> NearestTriangles::passes(const Vec3& p, const Vec3& q) const {
  std::vector<Index> candidates;
  within(0.5 * (p + q), 0.5 * (q - p).norm(), candidates);
  std::vector<double> found;
  for (const Index triangle : candidates) {
    const std::array<Vec3, 3> x = parts_->corners(triangle);
    if (const auto place = segment_through_triangle(p, q, x[0], x[1], x[2]))
      found.push_back(*place);
  }
  std::ranges::sort(found);
  return found;
}

NearestPoint NearestTriangles::nearest(const Vec3& point) const {
  struct Search {
    const Parts& parts;
    const Vec3& point;
    Index triangle = -1;
    ClosestOnTriangle closest = {};
  };
  require(!parts_->triangles.empty(), "NearestTriangles: no triangle is nearest among none");
  require(point.allFinite(), "NearestTriangles: the point is not finite");
  Search search{*parts_, point};
  const auto compare = [](RTCPointQueryFunctionArguments* candidate) {
    auto& s = *static_cast<Search*>(candidate->userPtr);
    const auto triangle = static_cast<Index>(candidate->primID);
    const ClosestOnTriangle closest = s.parts.closest(triangle, s.point);
    const double before = s.closest.distance_squared;
    const bool is_nearer = s.triangle < 0 || closest.distance_squared < before ||
                           (closest.distance_squared == before && triangle < s.triangle);
    if (!is_nearer) return false;
    s.triangle = triangle;
    s.closest = closest;
    candidate->query->radius = s.parts.search_radius(s.point, std::sqrt(closest.distance_squared));
    return true;
  };
  parts_->query(point, std::numeric_limits<float>::infinity(), compare, &search);
  const Vec3 normal = parts_->pseudonormal(search.triangle, search.closest.feature);
  return {search.triangle, point - search.closest.offset,
          std::sqrt(search.closest.distance_squared), normal.dot(search.closest.offset) < 0.0};
}

}  // namespace facies::mesh
