// SPDX-License-Identifier: Apache-2.0
#include "facies/results/stage.hpp"

#include <algorithm>
#include <array>

#include "facies/results/eyes.hpp"

namespace facies::results {

namespace {

/// How dense the skin is when one looks through it, and bones that are given as open sheets.
constexpr float skin_density = 0.25F;
constexpr float shell_density = 0.12F;

}  // namespace

Stage::Stage(const Subject& subject, int threads)
    : subject_(&subject), threads_(threads), shell_(*subject.mesh, subject.eyes), tissue_(subject) {
  for (const BoneShape& bone : subject.bones)
    bones_.emplace_back(surface_of(bone), threads);
}

std::vector<Actor> Stage::bones_in(const mechanics::State& state) const {
  std::vector<Actor> actors;
  for (std::size_t b = 0; b < bones_.size(); ++b) {
    actors.push_back(carried(bones_[b], subject_->bones[b], *subject_, state));
    if (!subject_->bones[b].is_solid) actors.back().density = shell_density;
  }
  return actors;
}

std::vector<Image> Stage::take(std::span<const Actor> actors, std::span<const View> views) const {
  std::vector<Image> images;
  for (const View& view : views)
    images.push_back(render(actors, view.camera, {}, threads_));
  return images;
}

Scene Stage::in_light(const mechanics::State& state, std::span<const double> node_values) const {
  const Lids lids = subject_->bones.empty() ? Lids::all : Lids::open_mouth;
  Surface surface = shell_.pose(state.u, node_values, lids);
  for (const BoneShape& bone : subject_->bones) {
    if (bone.is_solid) append(surface, surface_of(bone, *subject_, state));
  }
  for (const EyeShape& eye : subject_->eyes)
    append(surface, surface_of(eye));
  return {std::move(surface), threads_};
}

std::vector<Image> Stage::with_bones(const mechanics::State& state, std::span<const Actor> others,
                                     std::span<const View> views) const {
  std::vector<Actor> actors = bones_in(state);
  actors.insert(actors.end(), others.begin(), others.end());
  return take(actors, views);
}

bool Stage::is_before_bones(const Camera& camera, const Vec3& point) const {
  return std::ranges::all_of(bones_,
                             [&](const Scene& bone) { return bone.sees(camera, point, 0.0); });
}

Scene Stage::skin(const mechanics::State& state) const {
  return {shell_.pose(state.u, {}, Lids::none), threads_};
}

std::vector<Image> Stage::through_skin(const mechanics::State& state,
                                       std::span<const View> views) const {
  const Scene veil = skin(state);
  const std::array<Actor, 1> others = {{{.scene = &veil, .density = skin_density}}};
  return with_bones(state, others, views);
}

std::vector<Image> Stage::cut_open(const mechanics::State& state,
                                   std::span<const View> views) const {
  const Scene tissue(tissue_.pose(state.u), threads_);
  std::vector<Actor> actors = {{.scene = &tissue}};
  for (const Actor& bone : bones_in(state)) {
    if (bone.density == 1.0F) actors.push_back(bone);
  }
  return take(actors, views);
}

}  // namespace facies::results
