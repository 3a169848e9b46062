// SPDX-License-Identifier: Apache-2.0
#include "facies/results/render.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>

#include <embree3/rtcore.h>

#include "facies/base/error.hpp"
#include "facies/base/parallel.hpp"
#include "facies/results/shading.hpp"

namespace facies::results {

namespace {

/// Farther than this nothing takes light away from a point [mm].
constexpr float shelter_reach = 35.0F;
constexpr int shelter_rays = 48;
/// Every triangle is drawn as this many squared.
constexpr std::uint32_t cuts = 3;
/// How far the surface follows the tangent planes; the source's value is 3/4, less keeps flat things flat.
constexpr double roundness = 0.6;
/// Pixels that differ by more than this from a neighbour are sampled again (parts of full light).
constexpr float edge_contrast = 0.04F;

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Tree = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

Vec3f to_vector(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

RTCRay make_ray(const Vec3f& origin, const Vec3f& direction, float near, float far) {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = near;
  ray.tfar = far;
  ray.mask = std::numeric_limits<unsigned>::max();
  return ray;
}

/// Directions about +z whose density falls with the cosine (Malley's method on a Fibonacci spiral): always the same ones.
std::vector<Vec3f> hemisphere() {
  std::vector<Vec3f> directions;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < shelter_rays; ++i) {
    const double r2 = (i + 0.5) / shelter_rays;
    const double r = std::sqrt(r2);
    const double angle = golden_angle * i;
    directions.emplace_back(static_cast<float>(r * std::cos(angle)),
                            static_cast<float>(r * std::sin(angle)),
                            static_cast<float>(std::sqrt(1.0 - r2)));
  }
  return directions;
}

bool is_blocked(RTCScene tree, RTCRay ray) {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcOccluded1(tree, &context, &ray);
  return ray.tfar < 0.0F;
}

/// Part of the hemisphere above a point that is free within shelter_reach.
float openness_at(RTCScene tree, const Vec3f& point, const Vec3f& normal,
                  const std::vector<Vec3f>& directions) {
  const Vec3f helper = std::abs(normal.z()) < 0.9F ? Vec3f::UnitZ() : Vec3f::UnitX();
  const Vec3f s = normal.cross(helper).normalized();
  const Vec3f t = normal.cross(s);
  const Vec3f origin = point + 0.15F * normal;
  int free = 0;
  for (const Vec3f& d : directions) {
    const Vec3f direction = d.x() * s + d.y() * t + d.z() * normal;
    if (!is_blocked(tree, make_ray(origin, direction, 0.05F, shelter_reach))) ++free;
  }
  return static_cast<float>(free) / static_cast<float>(directions.size());
}

void check(const Surface& surface) {
  const std::size_t n = surface.positions.size();
  require(surface.normals.size() == n && surface.round.size() == n && surface.colours.size() == n,
          "Scene: one normal, roundness and colour per position");
  require(surface.values.empty() || surface.values.size() == n,
          "Scene: one value per position, or none");
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t vertex : triangle)
      require(vertex < n, "Scene: a triangle names a vertex that does not exist");
  }
}

using Weights = std::array<double, 3>;

/// The small triangles that a triangle is drawn as: the weights of its vertices at each of their corners.
std::vector<std::array<Weights, 3>> cut_triangle() {
  const auto corner = [](std::uint32_t i, std::uint32_t j) {
    return Weights{static_cast<double>(cuts - i - j) / cuts, static_cast<double>(i) / cuts,
                   static_cast<double>(j) / cuts};
  };
  std::vector<std::array<Weights, 3>> list;
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

/// One thread inside Embree: its tree, and with it the answer on a shared edge, is then the same every time.
Device make_device() {
  Device device(rtcNewDevice("threads=1,user_threads=1"));
  if (!device) throw std::runtime_error("cannot start the ray caster (Embree)");
  return device;
}

Tree make_tree(RTCDevice device, const Surface& surface,
               std::span<const std::array<Weights, 3>> pieces) {
  const std::size_t n = surface.triangles.size() * pieces.size();
  Tree tree(rtcNewScene(device));
  rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
  auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n));
  for (const auto& triangle : surface.triangles) {
    for (const auto& piece : pieces) {
      for (const Weights& w : piece) {
        const Vec3f p = rounded_point(surface, triangle, w);
        positions = std::copy(p.begin(), p.end(), positions);
      }
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

/// One sample for every pixel.
class Light {
 public:
  Light(int width, int height)
      : width_(width),
        height_(height),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  Vec3f& operator()(int column, int row) { return samples_[place(column, row)]; }
  [[nodiscard]] bool has_edge(int column, int row) const {
    const Vec3f& here = samples_[place(column, row)];
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, height_ - 1); ++r) {
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, width_ - 1); ++c) {
        if ((samples_[place(c, r)] - here).cwiseAbs().maxCoeff() > edge_contrast) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_, height_;
  std::vector<Vec3f> samples_;
};

}  // namespace

Eigen::Vector2d Camera::project(const Vec3& point) const {
  const Vec3 d = (point - target) / mm_per_pixel;
  return {0.5 * width + d.dot(right()), 0.5 * height - d.dot(up)};
}

Image halved(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  half.rgb.resize(half.place(0, half.height));
  std::uint8_t* out = half.rgb.data();
  for (int row = 0; row < half.height; ++row) {
    for (int column = 0; column < half.width; ++column) {
      const std::uint8_t* upper = image.rgb.data() + image.place(2 * column, 2 * row);
      const std::uint8_t* lower = image.rgb.data() + image.place(2 * column, 2 * row + 1);
      for (int c = 0; c < 3; ++c) {
        const int sum = upper[c] + upper[c + 3] + lower[c] + lower[c + 3];
        *out++ = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

struct Scene::Parts {
  Surface surface;
  std::vector<float> openness;  ///< of each vertex
  std::vector<std::array<Weights, 3>> pieces;
  float size = 0.0F;  ///< no point is farther than this from the origin
  Device device;
  Tree tree;

  /// The light along one ray of the camera.
  [[nodiscard]] Vec3f look(const Studio& studio, const RTCRay& from,
                           const ColourScale& scale) const;
  /// The light from a point of a triangle with these weights of its vertices.
  [[nodiscard]] Vec3f shade(const Studio& studio, const std::array<std::uint32_t, 3>& triangle,
                            const Vec3f& w, const ColourScale& scale) const;
};

Scene::Scene(Surface surface, int threads) : parts_(std::make_unique<Parts>()) {
  check(surface);
  Parts& parts = *parts_;
  parts.surface = std::move(surface);
  for (const Vec3f& p : parts.surface.positions)
    parts.size = std::max(parts.size, p.norm());
  parts.device = make_device();
  parts.pieces = cut_triangle();
  parts.tree = make_tree(parts.device.get(), parts.surface, parts.pieces);
  parts.openness.resize(parts.surface.positions.size());
  const std::vector<Vec3f> directions = hemisphere();
  parallel_for(parts.openness.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      parts.openness[i] = openness_at(parts.tree.get(), parts.surface.positions[i],
                                      parts.surface.normals[i], directions);
    }
  });
}

Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Vec3f Scene::Parts::shade(const Studio& studio, const std::array<std::uint32_t, 3>& triangle,
                          const Vec3f& w, const ColourScale& scale) const {
  Vec3f normal = Vec3f::Zero();
  Vec3f albedo = Vec3f::Zero();
  float open = 0.0F;
  float value = surface.values.empty() ? std::numeric_limits<float>::quiet_NaN() : 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const float weight = w[static_cast<Eigen::Index>(k)];
    const std::uint32_t vertex = triangle[k];
    normal += weight * surface.normals[vertex];
    albedo += weight * to_vector(to_light(surface.colours[vertex]));
    open += weight * openness[vertex];
    if (!surface.values.empty()) value += weight * surface.values[vertex];
  }
  if (!std::isnan(value)) albedo = to_vector(to_light(scale.colour_of(value)));
  return studio.shade(albedo, normal.normalized(), open);
}

Vec3f Scene::Parts::look(const Studio& studio, const RTCRay& from, const ColourScale& scale) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit ray{};
  ray.ray = from;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tree.get(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return Vec3f::Ones();
  const std::array<Weights, 3>& piece = pieces[ray.hit.primID % pieces.size()];
  const std::array<float, 3> within{1.0F - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
  Vec3f w = Vec3f::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    w += within[k] * Vec3(piece[k][0], piece[k][1], piece[k][2]).cast<float>();
  return shade(studio, surface.triangles[ray.hit.primID / pieces.size()], w, scale).cwiseMin(1.0F);
}

Image Scene::render(const Camera& camera, const ColourScale& scale, int threads) const {
  const Studio studio(camera);
  const Vec3f direction = camera.direction.cast<float>();
  const float distance = parts_->size + static_cast<float>(camera.target.norm());
  const auto sample = [&](double column, double row) {
    const Vec3 place =
        camera.target + camera.mm_per_pixel * ((column - 0.5 * camera.width) * camera.right() +
                                               (0.5 * camera.height - row) * camera.up);
    const Vec3f origin = place.cast<float>() - distance * direction;
    return parts_->look(studio, make_ray(origin, direction, 0.0F, 2.0F * distance), scale);
  };
  constexpr std::array<double, 3> thirds{1.0 / 6.0, 3.0 / 6.0, 5.0 / 6.0};
  const auto sample_finely = [&](int column, int row) {
    Vec3f sum = Vec3f::Zero();
    for (const double y : thirds) {
      for (const double x : thirds)
        sum += sample(column + x, row + y);
    }
    return Vec3f(sum / 9.0F);
  };
  const auto in_rows = [&](const auto& pixel) {
    parallel_for(static_cast<std::size_t>(camera.height), threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
                     for (int column = 0; column < camera.width; ++column)
                       pixel(column, row);
                   }
                 });
  };
  Light light(camera.width, camera.height);
  in_rows([&](int column, int row) { light(column, row) = sample(column + 0.5, row + 0.5); });
  Image image{camera.width, camera.height, {}};
  image.rgb.resize(image.place(0, image.height));
  in_rows([&](int column, int row) {
    const Vec3f l = light.has_edge(column, row) ? sample_finely(column, row) : light(column, row);
    const Colour colour = from_light({l.x(), l.y(), l.z()});
    std::uint8_t* out = image.rgb.data() + image.place(column, row);
    for (const float s : {colour.r, colour.g, colour.b})
      *out++ = static_cast<std::uint8_t>(std::lround(255.0F * s));
  });
  return image;
}

bool Scene::sees(const Camera& camera, const Vec3& point, double tolerance) const {
  const Vec3 origin = point - tolerance * camera.direction;
  const float far = parts_->size + static_cast<float>(point.norm());
  return !is_blocked(parts_->tree.get(),
                     make_ray(origin.cast<float>(), (-camera.direction).cast<float>(), 0.0F, far));
}

}  // namespace facies::results
