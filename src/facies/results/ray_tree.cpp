// SPDX-License-Identifier: Apache-2.0
#include "facies/results/ray_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>

#include <embree3/rtcore.h>

namespace facies::results {

namespace {

/// A triangle with a round corner is drawn as this many squared.
constexpr std::uint32_t cuts = 3;
/// How far the surface follows the tangent planes; the source's value is 3/4, less keeps flat things flat.
constexpr double roundness = 0.6;
struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Tree = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

RTCRay to_embree(const Ray& from) {
  RTCRay ray{};
  ray.org_x = from.origin.x();
  ray.org_y = from.origin.y();
  ray.org_z = from.origin.z();
  ray.dir_x = from.direction.x();
  ray.dir_y = from.direction.y();
  ray.dir_z = from.direction.z();
  ray.tnear = from.near;
  ray.tfar = from.far;
  ray.mask = std::numeric_limits<unsigned>::max();
  return ray;
}

using Weights = std::array<double, 3>;

/// The triangles that a triangle may be drawn as: the weights of its vertices at each of their corners. The first is the whole
/// triangle, all others together are a round one.
std::vector<std::array<Weights, 3>> cut_triangle() {
  const auto corner = [](std::uint32_t i, std::uint32_t j) {
    return Weights{static_cast<double>(cuts - i - j) / cuts, static_cast<double>(i) / cuts,
                   static_cast<double>(j) / cuts};
  };
  std::vector<std::array<Weights, 3>> list = {
      {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}};
  for (std::uint32_t j = 0; j < cuts; ++j) {
    for (std::uint32_t i = 0; i + j < cuts; ++i) {
      list.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
      if (i + j + 1 < cuts)
        list.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return list;
}

/// The point of the rounded surface. In double, so that the two triangles at an edge get the same bits in single.
Vec3f rounded_point(const Surface& surface, const std::array<std::uint32_t, 3>& triangle,
                    const Weights& w) {
  Vec3 flat = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    flat += w[k] * surface.positions[triangle[k]].cast<double>();
  Vec3 bulge = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!surface.round[triangle[k]]) continue;
    const Vec3 normal = surface.normals[triangle[k]].cast<double>();
    bulge -= w[k] * (flat - surface.positions[triangle[k]].cast<double>()).dot(normal) * normal;
  }
  return (flat + roundness * bulge).cast<float>();
}

/// A triangle of the tree: which triangle of the surface it is a piece of, and which piece.
struct Fragment {
  std::uint32_t triangle = 0, piece = 0;
};

std::vector<Fragment> cut_surface(const Surface& surface, std::size_t n_pieces) {
  std::vector<Fragment> fragments;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto is_round = [&](std::uint32_t vertex) { return surface.round[vertex]; };
    if (std::ranges::none_of(surface.triangles[t], is_round)) {
      fragments.push_back({t, 0});
    } else {
      for (std::uint32_t piece = 1; piece < n_pieces; ++piece)
        fragments.push_back({t, piece});
    }
  }
  return fragments;
}

/// One thread inside Embree: its tree, and with it the answer on a shared edge, is then the same every time.
Device make_device() {
  Device device(rtcNewDevice("threads=1,user_threads=1"));
  if (!device) throw std::runtime_error("cannot start the ray caster (Embree)");
  return device;
}

Tree make_tree(RTCDevice device, const Surface& surface,
               std::span<const std::array<Weights, 3>> pieces,
               std::span<const Fragment> fragments) {
  const std::size_t n = fragments.size();
  Tree tree(rtcNewScene(device));
  rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
  auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n));
  for (const Fragment& fragment : fragments) {
    for (const Weights& w : pieces[fragment.piece]) {
      const Vec3f p = rounded_point(surface, surface.triangles[fragment.triangle], w);
      positions = std::copy(p.begin(), p.end(), positions);
    }
  }
  std::iota(triangles, triangles + 3 * n, 0U);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(tree.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree.get());
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw std::runtime_error("the ray caster (Embree) cannot take the surface");
  return tree;
}

}  // namespace

struct RayTree::Parts {
  std::vector<std::array<Weights, 3>> pieces;
  std::vector<Fragment> fragments;
  Device device;
  Tree tree;
};

RayTree::RayTree(const Surface& surface) : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  parts.pieces = cut_triangle();
  parts.fragments = cut_surface(surface, parts.pieces.size());
  parts.device = make_device();
  parts.tree = make_tree(parts.device.get(), surface, parts.pieces, parts.fragments);
}

RayTree::RayTree(RayTree&&) noexcept = default;
RayTree& RayTree::operator=(RayTree&&) noexcept = default;
RayTree::~RayTree() = default;

std::optional<RayHit> RayTree::first_hit(const Ray& ray) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit found{};
  found.ray = to_embree(ray);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(parts_->tree.get(), &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const Fragment& fragment = parts_->fragments[found.hit.primID];
  const std::array<Weights, 3>& piece = parts_->pieces[fragment.piece];
  const std::array<float, 3> within{1.0F - found.hit.u - found.hit.v, found.hit.u, found.hit.v};
  RayHit hit{fragment.triangle, Vec3f::Zero(), found.ray.tfar, false};
  for (std::size_t k = 0; k < 3; ++k)
    hit.weights += within[k] * Vec3(piece[k][0], piece[k][1], piece[k][2]).cast<float>();
  const Vec3f outwards(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z);
  hit.from_inside = outwards.dot(ray.direction) > 0.0F;
  return hit;
}

bool RayTree::blocks(const Ray& from) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRay ray = to_embree(from);
  rtcOccluded1(parts_->tree.get(), &context, &ray);
  return ray.tfar < 0.0F;
}

std::array<Vec3, 8> RayTree::corners() const {
  RTCBounds b{};
  rtcGetSceneBounds(parts_->tree.get(), &b);
  std::array<Vec3, 8> corners;
  for (unsigned k = 0; k < corners.size(); ++k) {
    const auto [x, y, z] =
        std::tuple((k & 1U) != 0U ? b.upper_x : b.lower_x, (k & 2U) != 0U ? b.upper_y : b.lower_y,
                   (k & 4U) != 0U ? b.upper_z : b.lower_z);
    corners[k] = Vec3f(x, y, z).cast<double>();
  }
  return corners;
}

}  // namespace facies::results
