// SPDX-License-Identifier: Apache-2.0
// A face with its bones and teeth, ready to be looked at in any state: in the light, through the skin, or cut open.
#pragma once

#include <vector>

#include "facies/results/framing.hpp"
#include "facies/results/section.hpp"
#include "facies/results/shell.hpp"

namespace facies::results {

/// Prepared once per subject, which must outlive it: bones do not change, only their places do.
class Stage {
 public:
  Stage(const Subject& subject, int threads);

  /// The boundary of the tissue, with teeth and bones where they show. `node_values` [n_nodes] are what a colour scale
  /// shows; empty: natural colours.
  [[nodiscard]] Scene in_light(const mechanics::State& state,
                               std::span<const double> node_values = {}) const;

  /// Bones and teeth in their places, with these others.
  [[nodiscard]] std::vector<Image> with_bones(const mechanics::State& state,
                                              std::span<const Actor> others,
                                              std::span<const View> views) const;

  /// Whether no bone stands between a camera and a point while no bone has moved.
  [[nodiscard]] bool is_before_bones(const Camera& camera, const Vec3& point) const;

  /// The boundary of the tissue alone, its holes open: a veil for with_bones.
  [[nodiscard]] Scene skin(const mechanics::State& state) const;

  /// Bones and teeth in their places, the skin as a veil in front of them.
  [[nodiscard]] std::vector<Image> through_skin(const mechanics::State& state,
                                                std::span<const View> views) const;

  /// What is left behind the cut of each camera (Camera::cut): layers and bones have their colours in the cut.
  [[nodiscard]] std::vector<Image> cut_open(const mechanics::State& state,
                                            std::span<const View> views) const;

  [[nodiscard]] int threads() const { return threads_; }

 private:
  [[nodiscard]] std::vector<Actor> bones_in(const mechanics::State& state) const;
  [[nodiscard]] std::vector<Image> take(std::span<const Actor> actors,
                                        std::span<const View> views) const;

  const Subject* subject_;
  int threads_;
  Shell shell_;
  LayeredTissue tissue_;
  std::vector<Scene> bones_;
};

}  // namespace facies::results
