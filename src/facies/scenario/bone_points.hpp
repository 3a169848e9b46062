// SPDX-License-Identifier: Apache-2.0
// Bones that press on tissue with their own vertices, where they are sharper than its mesh is fine.
#pragma once

#include <vector>

#include "facies/mechanics/contact.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::scenario {

/// The vertices of a bone that the inner surface of the tissue may not pass, each with its share of the bone's area.
/// `start` is how far each node goes first (resolve_overlaps; empty: nowhere). Vertices that then lie in the tissue, or
/// nearer to it than 0.3 of the contact `distance` [mm], are left out: a coarse mesh cuts the corners of a bone.
[[nodiscard]] std::vector<mechanics::ContactPoint> bone_points(
    const mesh::Mesh& mesh, const std::vector<Vec3>& start, const mechanics::ContactSurface& bone,
    double distance);

}  // namespace facies::scenario
