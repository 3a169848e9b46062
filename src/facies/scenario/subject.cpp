// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/subject.hpp"

#include <algorithm>

namespace facies::scenario {

namespace {

/// Bones and teeth, where they are while the jaw has not moved.
std::vector<results::BoneShape> bone_shapes(const anatomy::Jaw& jaw, const SettledJaw* settled) {
  std::vector<results::BoneShape> bones;
  for (std::size_t s = 0; s < jaw.surfaces.size(); ++s) {
    const anatomy::BoneSurface& part = jaw.surfaces[s];
    if (part.kind == anatomy::SurfaceKind::cast) continue;
    results::BoneShape& bone = bones.emplace_back();
    bone.name = part.name;
    bone.meaning = part.meaning;
    bone.is_solid = part.kind == anatomy::SurfaceKind::solid;
    bone.body = settled != nullptr && part.bone == jaw.mandible ? 0 : -1;
    bone.surface = part.surface;
    bone.is_tooth.resize(bone.surface.X.size());
    for (std::size_t v = 0; v < bone.surface.X.size(); ++v) {
      Vec3& X = bone.surface.X[v];
      bone.is_tooth[v] = std::ranges::any_of(jaw.crowns, [&](const anatomy::Crowns& crowns) {
        return at(crowns.surface) == s && crowns.holds(X);
      });
      const anatomy::BonePoint point{part.bone, X};
      X = settled != nullptr ? anchor_of(jaw, *settled, point).X : place_of(jaw, jaw.start, point);
    }
  }
  return bones;
}

/// [n_elements] skin lines; zero outside the skin.
std::vector<Vec3> skin_lines(const anatomy::FaceAnatomy& face) {
  std::vector<Vec3> lines(face.mesh.n_elements(), Vec3::Zero());
  for (const Index e : face.mesh.elements(anatomy::layer_names().front()))
    lines[at(e)] = face.axes.at(at(e)).col(0);
  return lines;
}

}  // namespace

results::Subject subject_of(const anatomy::FaceAnatomy& face,
                            std::span<const anatomy::Muscle> muscles, const SettledJaw* settled) {
  results::Subject subject;
  subject.mesh = &face.mesh;
  subject.layers = anatomy::layer_names();
  subject.layer_of_element.assign(face.mesh.n_elements(), 0);
  for (std::size_t layer = 0; layer < subject.layers.size(); ++layer) {
    for (const Index e : face.mesh.elements(subject.layers[layer]))
      subject.layer_of_element[at(e)] = static_cast<int>(layer);
  }
  subject.skin_lines = skin_lines(face);
  for (const anatomy::Landmark& landmark : face.landmarks)
    subject.landmarks.push_back({landmark.name, landmark.meaning, landmark.node});
  for (const anatomy::LandmarkPair& pair : face.pairs)
    subject.pairs.push_back({pair.a, pair.b});
  for (const anatomy::Muscle& muscle : muscles) {
    const auto paths =
        std::ranges::find(face.muscle_paths, muscle.group, &anatomy::MusclePaths::name);
    subject.muscles.push_back({muscle.name, muscle.elements, muscle.group,
                               paths == face.muscle_paths.end() ? "" : paths->meaning});
  }
  for (const anatomy::Eye& eye : face.eyes)
    subject.eyes.push_back({eye.centre, eye.radius});
  if (face.jaw) subject.bones = bone_shapes(*face.jaw, settled);
  return subject;
}

}  // namespace facies::scenario
