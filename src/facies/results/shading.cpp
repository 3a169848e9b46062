// SPDX-License-Identifier: Apache-2.0
#include "facies/results/shading.hpp"

#include <algorithm>
#include <cmath>

namespace facies::results {

namespace {

const Vec3f sky{0.30F, 0.31F, 0.33F};
const Vec3f ground{0.17F, 0.15F, 0.14F};

}  // namespace

Studio::Studio(const Camera& camera)
    : eye_((-camera.direction).cast<float>()), up_(camera.up.cast<float>()) {
  const Vec3f right = camera.right().cast<float>();
  const auto light = [&](float r, float u, float e, const Vec3f& colour, float wrap, float gloss) {
    const Vec3f towards = (r * right + u * up_ + e * eye_).normalized();
    return Light{towards, (towards + eye_).normalized(), colour, wrap, gloss};
  };
  lights_ = {light(-0.60F, 0.65F, 0.75F, {0.80F, 0.77F, 0.73F}, 0.25F, 0.07F),   // key, upper left
             light(0.85F, 0.10F, 0.55F, {0.25F, 0.265F, 0.285F}, 0.40F, 0.02F),  // fill, right
             light(0.50F, 0.60F, -0.65F, {0.30F, 0.31F, 0.33F}, 0.10F, 0.0F)};   // rim, behind
}

Vec3f Studio::shade(const Vec3f& albedo, Vec3f normal, float openness) const {
  if (normal.dot(eye_) < 0.0F) normal = -normal;
  const float elevation = 0.5F * (1.0F + normal.dot(up_));
  Vec3f diffuse = openness * (ground + elevation * (sky - ground));
  float gloss = 0.0F;
  // Soft lights are large: what closes a point off from the sky dims them too, though less.
  const float unshadowed = 0.35F + 0.65F * openness;
  for (const Light& light : lights_) {
    const float cosine = (normal.dot(light.towards) + light.wrap) / (1.0F + light.wrap);
    if (cosine <= 0.0F) continue;
    diffuse += unshadowed * cosine * light.colour;
    gloss += openness * light.gloss * std::pow(std::max(normal.dot(light.half), 0.0F), 24.0F);
  }
  return albedo.cwiseProduct(diffuse) + Vec3f::Constant(gloss);
}

}  // namespace facies::results
