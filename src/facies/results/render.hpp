// SPDX-License-Identifier: Apache-2.0
// Pictures of triangle surfaces by ray casting. No display, no randomness: the same surface gives the same bytes with any
// number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "facies/math/tensor.hpp"
#include "facies/results/colour.hpp"

namespace facies::results {

using Vec3f = Eigen::Vector3f;

/// What a triangle separates, for pictures of a cut: positions in Surface::fills, nothing where negative.
struct Sides {
  int inside = -1, outside = -1;

  friend bool operator==(const Sides&, const Sides&) = default;
};

/// Triangles with shared vertices, seen from both sides. Between vertices that are `round` the surface bulges towards
/// their tangent planes (T. Boubekeur and M. Alexa, "Phong tessellation", 2008); the vertices themselves stay in place.
struct Surface {
  std::vector<Vec3f> positions;  ///< [n] [mm]
  std::vector<Vec3f> normals;    ///< [n] unit, outward
  std::vector<bool> round;       ///< [n]
  std::vector<Colour> colours;   ///< [n]
  std::vector<float> values;     ///< [n] shown by a colour scale instead, NaN: not; or empty
  std::vector<std::array<std::uint32_t, 3>>
      triangles;              ///< vertices, counter-clockwise seen from outside
  std::vector<Sides> sides;   ///< of each triangle; empty: there is nothing on either side
  std::vector<Colour> fills;  ///< of what is cut
};

/// Adds the triangles of another surface. Where only one of the two has values, the other's are NaN.
void append(Surface& surface, const Surface& more);

/// An orthographic camera: parallel rays, so that a length in the picture is a length on the face.
struct Camera {
  Vec3 target = Vec3::Zero();      ///< what stands in the middle of the picture [mm]
  Vec3 direction = Vec3::UnitX();  ///< unit; where the camera looks
  Vec3 up = Vec3::UnitZ();         ///< unit, perpendicular to direction
  double mm_per_pixel = 0.25;
  int width = 800, height = 800;
  /// Everything nearer than this along `direction` is cut away [mm from the target]. Where the cut goes through what
  /// triangles enclose, it shows the colour of that (Surface::sides), unshaded.
  double cut = -std::numeric_limits<double>::infinity();

  /// Unit vector that points to the right in the picture.
  [[nodiscard]] Vec3 right() const { return direction.cross(up); }
  /// Column and row of a point (pixel centres are at halves; row 0 is the top).
  [[nodiscard]] Eigen::Vector2d project(const Vec3& point) const;
};

/// Rows from the top, three sRGB bytes a pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< [height * width * 3]

  /// Where a pixel's bytes begin in rgb.
  [[nodiscard]] std::size_t place(int column, int row) const {
    return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column));
  }
};

/// Half the size: the mean of every 2 x 2 pixels. An odd last row or column is dropped.
[[nodiscard]] Image halved(const Image& image);

/// A surface ready to be looked at. How much of the sky each vertex sees is worked out once, at construction.
class Scene {
 public:
  /// Throws BugError where the lists of the surface do not fit each other; std::runtime_error where Embree fails.
  Scene(Surface surface, int threads);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// The surface on white. Where neighbouring pixels differ, each is the mean of 3 x 3 samples. `scale` colours the
  /// surface's values; it is not used without them.
  [[nodiscard]] Image render(const Camera& camera, const ColourScale& scale, int threads) const;

  /// Whether nothing stands between the camera and a point (within `tolerance` [mm] of the surface).
  [[nodiscard]] bool sees(const Camera& camera, const Vec3& point, double tolerance) const;

 private:
  friend class Gaze;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A scene among others, carried from where it was made to x = R X + t.
struct Actor {
  const Scene* scene = nullptr;
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();  ///< [mm]
  /// 1: opaque. Else one looks through it: this dense where one looks straight at it, denser towards its outlines.
  float density = 1.0F;
};

/// Several scenes in one picture. They hide each other but take no light from each other; where a cut goes through more than
/// one, the last of them is shown.
[[nodiscard]] Image render(std::span<const Actor> actors, const Camera& camera,
                           const ColourScale& scale, int threads);

}  // namespace facies::results
