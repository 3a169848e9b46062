// SPDX-License-Identifier: Apache-2.0
// The muscles of expression of the built-in face: drawn fibres in its tissue.
#pragma once

#include <vector>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// Points about `step` [mm] apart in the frontal view, on a smooth curve (Catmull and Rom 1974) through those of a fibre. A fibre keeps its
/// ends, a ring its two places in the midline, which it crosses at a right angle; a loop does not repeat its first point.
[[nodiscard]] std::vector<DrawnPoint> smooth_points(const DrawnFibre& fibre, double step);

/// The muscles of the drawings between an outer and an inner surface, given at the vertices that sites refer to [mm]: bands
/// on both sides, their normals those of the layers at their depth. Adds a problem for each drawn point beside the face.
[[nodiscard]] std::vector<MusclePaths> place_muscles(const Drawings& drawings,
                                                     const SkinSites& sites,
                                                     const std::vector<Vec3>& outer,
                                                     const std::vector<Vec3>& inner,
                                                     Problems& problems);

}  // namespace facies::anatomy
