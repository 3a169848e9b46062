// SPDX-License-Identifier: Apache-2.0
// From the surfaces of a face and its bones to contact terms, and to a start in which nothing overlaps.
#pragma once

#include <set>

#include "facies/mechanics/contact.hpp"
#include "facies/scenario/jaw_model.hpp"
#include "facies/scenario/scenario.hpp"

namespace facies::anatomy {
struct FaceAnatomy;
}

namespace facies::scenario {

/// A surface of bone in a model.
struct BoneObstacle {
  mechanics::ContactSurface surface;
  /// Inner nodes of the tissue begin on the side that the triangles look to, and are put there where they do not.
  bool pushes_out = true;
  bool closed = true;  ///< it encloses the bone, without a border
  std::string where;   ///< the file that it comes from, for messages
};

/// The bones that tissue may meet: where the choice says so those of the jaw's surfaces "jaw" and "maxilla", and where the
/// face says that its inner surface lies on bone which is not given (face set "on_bone"), that surface itself, `distance`
/// below it. `settled` is null where the model has no jaw.
[[nodiscard]] std::vector<BoneObstacle> bone_obstacles(const anatomy::FaceAnatomy& face,
                                                       const SettledJaw* settled,
                                                       const ContactChoice& choice);

/// The inner surface's nodes but those in `left_out`, each with its share of the surface's area.
[[nodiscard]] std::vector<mechanics::ContactPoint> inner_points(const anatomy::FaceAnatomy& face,
                                                                const std::set<Index>& left_out);

/// How far each node has to go so that no contact point begins inside a bone or nearer to one than `distance` [n_nodes] [mm].
/// Inside a closed surface is where its winding number is not 0: the side that the nearest triangle shows is wrong where
/// the two sides of a thin bone run through each other. An open surface has no inside; behind it is a point that its nearest
/// triangle looks away from and that sees it in more than a quarter of all directions: not one beside its border.
/// Throws DataError for a bone that no point is near to, that has most points around it on its inner side, that
/// leaves a point no place between itself and another, or that elements would be turned inside out by.
[[nodiscard]] std::vector<Vec3> resolve_overlaps(const anatomy::FaceAnatomy& face,
                                                 const std::vector<mechanics::ContactPoint>& points,
                                                 const std::vector<BoneObstacle>& obstacles,
                                                 double distance);

/// Contacts that have been added to a model.
struct ContactTerms {
  std::vector<const mechanics::Contact*> contacts;
  std::vector<Vec3> start;  ///< resolve_overlaps; empty where no bone can be met
};

/// Adds what the choice asks for: tissue against bones, where nodes of `left_out` (held, or tied to the jaw) take no part,
/// and the face set "mouth" against itself. Throws as bone_obstacles and resolve_overlaps.
ContactTerms add_contacts(mechanics::Model& model, const anatomy::FaceAnatomy& face,
                          const SettledJaw* settled, const ContactChoice& choice,
                          const std::set<Index>& left_out, int threads);

}  // namespace facies::scenario
