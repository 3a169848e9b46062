// SPDX-License-Identifier: Apache-2.0
#include "facies/results/render.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "facies/base/error.hpp"
#include "facies/base/parallel.hpp"
#include "facies/results/ray_tree.hpp"
#include "facies/results/shading.hpp"

namespace facies::results {

namespace {

/// Farther than this nothing takes light away from a point [mm].
constexpr float shelter_reach = 35.0F;
constexpr int shelter_rays = 48;
/// What a ray has hit it leaves this far behind before it looks for more [mm].
constexpr float hit_gap = 1e-3F;
/// A veil shows only where it is at least this far in front of something [mm]: one that lies on it would come and go by rounding.
constexpr float veil_gap = 0.01F;
/// Pixels that differ by more than this from a neighbour are sampled again (parts of full light).
constexpr float edge_contrast = 0.04F;

Vec3f to_vector(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
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

/// Part of the hemisphere above a point that is free within shelter_reach.
float openness_at(const RayTree& tree, const Vec3f& point, const Vec3f& normal,
                  const std::vector<Vec3f>& directions) {
  const Vec3f helper = std::abs(normal.z()) < 0.9F ? Vec3f::UnitZ() : Vec3f::UnitX();
  const Vec3f s = normal.cross(helper).normalized();
  const Vec3f t = normal.cross(s);
  const Vec3f origin = point + 0.15F * normal;
  int free = 0;
  for (const Vec3f& d : directions) {
    const Vec3f direction = d.x() * s + d.y() * t + d.z() * normal;
    if (!tree.blocks({origin, direction, 0.05F, shelter_reach})) ++free;
  }
  return static_cast<float>(free) / static_cast<float>(directions.size());
}

void check(const Surface& surface) {
  require(surface.sides.empty() || surface.sides.size() == surface.triangles.size(),
          "Scene: one pair of sides per triangle, or none");
  const auto n_fills = static_cast<int>(surface.fills.size());
  for (const Sides& sides : surface.sides)
    require(std::max(sides.inside, sides.outside) < n_fills, "Scene: a side without a colour");
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

/// What one sees along a ray.
struct Sight {
  Vec3f light = Vec3f::Ones();
  float distance = std::numeric_limits<float>::infinity();  ///< to what is seen [mm]
  float facing = 0.0F;  ///< cosine between the line of sight and the surface's normal, 0..1
};

/// The veil in front of what is seen behind it.
Vec3f behind_veil(const Sight& veil, float density, const Vec3f& behind) {
  const float aside = 1.0F - veil.facing;
  return behind + (density + (1.0F - density) * aside * aside) * (veil.light - behind);
}

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

void append(Surface& surface, const Surface& more) {
  const auto n_vertices = static_cast<std::uint32_t>(surface.positions.size());
  const auto n_fills = static_cast<int>(surface.fills.size());
  const auto join = [](auto& list, const auto& other) {
    list.insert(list.end(), other.begin(), other.end());
  };
  if (!surface.values.empty() || !more.values.empty()) {
    surface.values.resize(n_vertices, std::numeric_limits<float>::quiet_NaN());
    join(surface.values, more.values);
    surface.values.resize(n_vertices + more.positions.size(),
                          std::numeric_limits<float>::quiet_NaN());
  }
  if (!surface.sides.empty() || !more.sides.empty()) {
    surface.sides.resize(surface.triangles.size());
    for (const Sides& sides : more.sides)
      surface.sides.push_back({sides.inside < 0 ? -1 : sides.inside + n_fills,
                               sides.outside < 0 ? -1 : sides.outside + n_fills});
    surface.sides.resize(surface.triangles.size() + more.triangles.size());
  }
  join(surface.positions, more.positions);
  join(surface.normals, more.normals);
  join(surface.round, more.round);
  join(surface.colours, more.colours);
  join(surface.fills, more.fills);
  for (const auto& t : more.triangles)
    surface.triangles.push_back({t[0] + n_vertices, t[1] + n_vertices, t[2] + n_vertices});
}

struct Scene::Parts {
  explicit Parts(Surface given) : surface(std::move(given)), tree(surface) {}

  Surface surface;
  RayTree tree;
  std::vector<Vec3f> albedos = {};   ///< colour of each vertex, as light
  std::vector<float> openness = {};  ///< of each vertex
  float size = 0.0F;                 ///< no point is farther than this from the origin

  /// What is seen along a ray.
  [[nodiscard]] Sight look(const Studio& studio, const Ray& ray, const ColourScale& scale,
                           bool is_cut) const;
  /// What lies on the ray's side of the triangle that it hit, and on the other.
  [[nodiscard]] Sides sides_of(const RayHit& hit) const;
  /// The colour of what a cut goes through where this ray begins in it, given its first hit; nullptr where that is nothing.
  [[nodiscard]] const Colour* cut_at(const Ray& ray, const RayHit& first) const;
  /// The light from a point of a triangle with these weights of its vertices.
  [[nodiscard]] Vec3f shade(const Studio& studio, const std::array<std::uint32_t, 3>& triangle,
                            const Vec3f& w, const Vec3f& normal, const ColourScale& scale) const;
};

Scene::Scene(Surface surface, int threads) {
  check(surface);
  parts_ = std::make_unique<Parts>(std::move(surface));
  Parts& parts = *parts_;
  for (const Vec3f& p : parts.surface.positions)
    parts.size = std::max(parts.size, p.norm());
  for (const Colour& colour : parts.surface.colours)
    parts.albedos.push_back(to_vector(to_light(colour)));
  parts.openness.resize(parts.surface.positions.size());
  const std::vector<Vec3f> directions = hemisphere();
  parallel_for(parts.openness.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      parts.openness[i] =
          openness_at(parts.tree, parts.surface.positions[i], parts.surface.normals[i], directions);
    }
  });
}

Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Vec3f Scene::Parts::shade(const Studio& studio, const std::array<std::uint32_t, 3>& triangle,
                          const Vec3f& w, const Vec3f& normal, const ColourScale& scale) const {
  Vec3f albedo = Vec3f::Zero();
  float open = 0.0F;
  float value = surface.values.empty() ? std::numeric_limits<float>::quiet_NaN() : 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const float weight = w[static_cast<Eigen::Index>(k)];
    const std::uint32_t vertex = triangle[k];
    albedo += weight * albedos[vertex];
    open += weight * openness[vertex];
    if (!surface.values.empty()) value += weight * surface.values[vertex];
  }
  if (!std::isnan(value)) albedo = to_vector(to_light(scale.colour_of(value)));
  return studio.shade(albedo, normal, open);
}

Sides Scene::Parts::sides_of(const RayHit& hit) const {
  const Sides& sides = surface.sides[hit.triangle];
  return hit.from_inside ? sides : Sides{sides.outside, sides.inside};
}

/// The ray begins in something if it leaves things more often than it enters them; where a surface passes through itself its
/// first hit alone could be the far side of a fold.
const Colour* Scene::Parts::cut_at(const Ray& ray, const RayHit& first) const {
  if (surface.sides.empty()) return nullptr;
  const int fill = sides_of(first).inside;
  if (fill < 0) return nullptr;
  int left = 0;
  for (std::optional<RayHit> hit = first; hit;) {
    const Sides sides = sides_of(*hit);
    left += static_cast<int>(sides.inside >= 0) - static_cast<int>(sides.outside >= 0);
    hit = tree.first_hit({ray.origin, ray.direction, hit->distance + hit_gap, ray.far});
  }
  return left > 0 ? &surface.fills[static_cast<std::size_t>(fill)] : nullptr;
}

Sight Scene::Parts::look(const Studio& studio, const Ray& ray, const ColourScale& scale,
                         bool is_cut) const {
  const std::optional<RayHit> hit = tree.first_hit(ray);
  if (!hit) return {};
  if (const Colour* fill = is_cut ? cut_at(ray, *hit) : nullptr)
    return {to_vector(to_light(*fill)), 0.0F, 1.0F};
  const std::array<std::uint32_t, 3>& triangle = surface.triangles[hit->triangle];
  Vec3f normal = Vec3f::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    normal += hit->weights[static_cast<Eigen::Index>(k)] * surface.normals[triangle[k]];
  normal.normalize();
  const Vec3f light = shade(studio, triangle, hit->weights, normal, scale);
  return {light.cwiseMin(1.0F), hit->distance, std::abs(normal.dot(ray.direction))};
}

/// One look at an actor. It is not the actor that moves but the camera, the other way.
class Gaze {
 public:
  Gaze(const Actor& actor, const Camera& camera)
      : parts_(actor.scene->parts_.get()),
        density_(actor.density),
        camera_(carried(camera, actor)),
        studio_(camera_),
        direction_(camera_.direction.cast<float>()),
        reach_(parts_->size + static_cast<float>(camera_.target.norm())),
        start_(std::max(static_cast<float>(camera.cut), -reach_)) {
    for (const Vec3& corner : parts_->tree.corners())
      silhouette_.extend(camera_.project(corner));
  }

  [[nodiscard]] float density() const { return density_; }
  [[nodiscard]] bool is_veil() const { return density_ < 1.0F; }
  /// What is seen of the actor at a place of the picture [pixels] before `far`; distances count from the camera's target.
  [[nodiscard]] Sight look(double column, double row, const ColourScale& scale, float far) const {
    if (!silhouette_.contains(Eigen::Vector2d(column, row))) return {};
    const Vec3 place =
        camera_.target + camera_.mm_per_pixel * ((column - 0.5 * camera_.width) * camera_.right() +
                                                 (0.5 * camera_.height - row) * camera_.up);
    const Vec3f origin = place.cast<float>() + start_ * direction_;
    const bool is_cut = std::isfinite(camera_.cut);
    // What a cut goes through is told by what the ray hits behind it, however far.
    const float end = is_cut ? 2.0F * reach_ : std::min(2.0F * reach_, far - start_);
    const Ray ray{origin, direction_, 0.0F, end};
    Sight sight = parts_->look(studio_, ray, scale, is_cut);
    sight.distance += start_;
    return sight;
  }

 private:
  static Camera carried(const Camera& camera, const Actor& actor) {
    Camera other = camera;
    other.target = actor.R.transpose() * (camera.target - actor.t);
    other.direction = actor.R.transpose() * camera.direction;
    other.up = actor.R.transpose() * camera.up;
    return other;
  }

  const Scene::Parts* parts_;
  float density_;
  Camera camera_;
  Studio studio_;
  Vec3f direction_;
  float reach_, start_;
  Eigen::AlignedBox2d silhouette_;  ///< nothing of the actor is outside [pixels]
};

namespace {

/// What is seen of all actors: the nearest, and the veils in front of it.
Vec3f look_at_all(std::span<const Gaze> gazes, double column, double row,
                  const ColourScale& scale) {
  Sight nearest;
  for (const Gaze& gaze : gazes) {
    if (gaze.is_veil()) continue;
    const Sight sight = gaze.look(column, row, scale, nearest.distance);
    if (sight.distance <= nearest.distance) nearest = sight;
  }
  Vec3f light = nearest.light;
  for (const Gaze& gaze : gazes) {
    if (!gaze.is_veil()) continue;
    const Sight veil = gaze.look(column, row, scale, nearest.distance);
    if (veil.distance + veil_gap < nearest.distance)
      light = behind_veil(veil, gaze.density(), light);
  }
  return light;
}

}  // namespace

Image Scene::render(const Camera& camera, const ColourScale& scale, int threads) const {
  const std::array<Actor, 1> alone = {{{.scene = this}}};
  return results::render(alone, camera, scale, threads);
}

Image render(std::span<const Actor> actors, const Camera& camera, const ColourScale& scale,
             int threads) {
  std::vector<Gaze> gazes;
  for (const Actor& actor : actors)
    gazes.emplace_back(actor, camera);
  constexpr std::array<double, 3> thirds{1.0 / 6.0, 3.0 / 6.0, 5.0 / 6.0};
  const auto sample_finely = [&](int column, int row) {
    Vec3f sum = Vec3f::Zero();
    for (const double y : thirds) {
      for (const double x : thirds)
        sum += look_at_all(gazes, column + x, row + y, scale);
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
  in_rows([&](int column, int row) {
    light(column, row) = look_at_all(gazes, column + 0.5, row + 0.5, scale);
  });
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
  return !parts_->tree.blocks({origin.cast<float>(), (-camera.direction).cast<float>(), 0.0F, far});
}

}  // namespace facies::results
