// SPDX-License-Identifier: Apache-2.0
#include "facies/results/eyes.hpp"

#include <cmath>
#include <numbers>

#include "facies/results/palette.hpp"

namespace facies::results {

namespace {

/// Seen from the front, of a globe of 12 mm radius: a visible iris 11.7 mm across, a pupil of 3.5 mm in daylight.
constexpr double iris_part = 5.85 / 12.0;
constexpr double pupil_part = 1.75 / 12.0;
/// What shows of a globe lies within this angle from where it looks.
constexpr double seen = 0.6 * std::numbers::pi;

constexpr int n_around = 64;

/// The zone of a globe between two angles from where it looks.
void add_zone(const EyeShape& eye, double from, double to, int n_rings, const Colour& colour,
              Surface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  for (int ring = 0; ring <= n_rings; ++ring) {
    const double theta = from + (to - from) * ring / n_rings;
    for (int k = 0; k < n_around; ++k) {
      const double phi = 2.0 * std::numbers::pi * k / n_around;
      const Vec3 normal(-std::cos(theta), std::sin(theta) * std::cos(phi),
                        std::sin(theta) * std::sin(phi));
      surface.positions.push_back((eye.centre + eye.radius * normal).cast<float>());
      surface.normals.push_back(normal.cast<float>());
      surface.round.push_back(true);
      surface.colours.push_back(colour);
    }
  }
  const auto vertex = [&](int ring, int k) {
    return first + static_cast<std::uint32_t>(ring * n_around + k % n_around);
  };
  for (int ring = 0; ring < n_rings; ++ring) {
    for (int k = 0; k < n_around; ++k) {
      surface.triangles.push_back({vertex(ring, k), vertex(ring, k + 1), vertex(ring + 1, k)});
      surface.triangles.push_back(
          {vertex(ring, k + 1), vertex(ring + 1, k + 1), vertex(ring + 1, k)});
    }
  }
}

}  // namespace

Surface surface_of(const EyeShape& eye) {
  const double pupil = std::asin(pupil_part);
  const double iris = std::asin(iris_part);
  Surface surface;
  add_zone(eye, 0.0, pupil, 2, palette::pupil, surface);
  add_zone(eye, pupil, iris, 4, palette::iris, surface);
  add_zone(eye, iris, seen, 16, palette::sclera, surface);
  return surface;
}

}  // namespace facies::results
