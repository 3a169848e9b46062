// SPDX-License-Identifier: Apache-2.0
// A start in which no tissue is in a bone or on its wrong side.
#pragma once

#include <string>
#include <vector>

#include "facies/mechanics/contact.hpp"

namespace facies::anatomy {
struct FaceAnatomy;
}

namespace facies::scenario {

/// A surface of bone in a model.
struct BoneObstacle {
  mechanics::ContactSurface surface;
  /// Inner nodes of the tissue begin on the side that the triangles look to, and are put there where they do not.
  bool pushes_out = true;
  bool closed = true;    ///< it encloses the bone, without a border
  bool presses = false;  ///< tissue may not pass its vertices either (bone_points)
  std::string where;     ///< the file that it comes from, for messages
};

/// By how much farther than the contact distance something is put away from a bone, so that rounding leaves no force.
inline constexpr double clear_of_contact = 1.0 + 1e-6;

/// How far each node has to go so that no contact point begins inside a bone, on its far side or nearer to one than
/// `distance` [n_nodes] [mm].
/// - Inside a closed surface is where its winding number is not 0: the side that the nearest triangle shows is wrong where
///   the two sides of a thin bone run through each other. An open surface has no inside; behind it is a point that its nearest
///   triangle looks away from and that sees it in more than a quarter of all directions: not one beside its border.
/// - On the far side is a point whose way to the skin, through the nodes above it in its column of elements, passes through
///   the bone. It goes to where that way leaves the bone for the last time; what is above it is pressed together.
/// Any other point goes the shortest way.
/// Throws DataError for a bone that no point is near to, that has most points around it on its inner side, that
/// leaves a point no place between itself and another, or that elements would be turned inside out by.
[[nodiscard]] std::vector<Vec3> resolve_overlaps(const anatomy::FaceAnatomy& face,
                                                 const std::vector<mechanics::ContactPoint>& points,
                                                 const std::vector<BoneObstacle>& obstacles,
                                                 double distance);

}  // namespace facies::scenario
