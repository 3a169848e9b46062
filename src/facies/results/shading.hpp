// SPDX-License-Identifier: Apache-2.0
// How a point of a surface looks: three soft lights that stay beside the camera, a dim sky, a trace of gloss.
#pragma once

#include "facies/results/render.hpp"

namespace facies::results {

/// Lights fixed to the camera's frame, so that every view is lit alike.
class Studio {
 public:
  explicit Studio(const Camera& camera);

  /// Light that reaches the eye from a point of colour `albedo` (as light), unit `normal` and `openness`: the part of the
  /// hemisphere above it that is free, 0..1. A normal that points away from the camera is turned round.
  [[nodiscard]] Vec3f shade(const Vec3f& albedo, Vec3f normal, float openness) const;

 private:
  struct Light {
    Vec3f towards, half;  ///< unit: to the light; half way between light and eye
    Vec3f colour;
    float wrap =
        0.0F;  ///< how far the light reaches beyond the terminator: 0 sharp .. 1 everywhere
    float gloss = 0.0F;
  };

  std::array<Light, 3> lights_;
  Vec3f eye_, up_;
};

}  // namespace facies::results
