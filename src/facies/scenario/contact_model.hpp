// SPDX-License-Identifier: Apache-2.0
// From the surfaces of a face and its bones to contact terms.
#pragma once

#include <set>
#include <span>
#include <string>

#include "facies/mechanics/contact.hpp"
#include "facies/mesh/mesh.hpp"
#include "facies/scenario/jaw_model.hpp"
#include "facies/scenario/overlaps.hpp"
#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

/// The bones that tissue may meet: where the choice says so the solid surfaces of the bones "jaw" and "maxilla", teeth
/// among them, and where the face says that its inner surface lies on bone which is not given (face set "on_bone"), that
/// surface itself, `distance` below it. `settled` is null where the model has no jaw.
[[nodiscard]] std::vector<BoneObstacle> bone_obstacles(const anatomy::FaceAnatomy& face,
                                                       const SettledJaw* settled,
                                                       const ContactChoice& choice);

/// The inner surface's nodes but those in `left_out`, each with its share of the surface's area.
[[nodiscard]] std::vector<mechanics::ContactPoint> inner_points(const anatomy::FaceAnatomy& face,
                                                                const std::set<Index>& left_out);

/// Faces of the mesh, cut into triangles, as a contact surface of this name: its vertices are their nodes, ascending.
[[nodiscard]] mechanics::ContactSurface tissue_surface(const mesh::Mesh& mesh,
                                                       std::span<const mesh::Face> faces,
                                                       const std::string& name);

/// Contacts that have been added to a model.
struct ContactTerms {
  std::vector<const mechanics::Contact*> contacts;
  std::vector<Vec3> start;  ///< resolve_overlaps; empty where no bone can be met
};

/// Adds what the choice asks for: tissue against bones, where nodes of `left_out` (held, or tied to the jaw) take no part,
/// the vertices of bones that press against the inner surface, and the face set "mouth" against itself. Throws as
/// bone_obstacles and resolve_overlaps.
ContactTerms add_contacts(mechanics::Model& model, const anatomy::FaceAnatomy& face,
                          const SettledJaw* settled, const ContactChoice& choice,
                          const std::set<Index>& left_out, int threads);

}  // namespace facies::scenario
