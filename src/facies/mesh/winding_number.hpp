// SPDX-License-Identifier: Apache-2.0
// How often a surface of triangles goes round a point: whether the point lies inside.
#pragma once

#include <array>
#include <span>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mesh {

/// The signed solid angle under which p sees the triangles (counter-clockwise from outside; vertices X [mm]), by 4 pi
/// (vanoosterom1983, jacobson2013). Of a closed surface 1 inside, 0 outside, and whole numbers where it runs through
/// itself, however thin or twisted it is; of an open one a fraction, 1/2 right behind it and 1/4 right behind a straight
/// border. Without meaning on the surface itself.
[[nodiscard]] double winding_number(std::span<const Vec3> X,
                                    std::span<const std::array<Index, 3>> triangles, const Vec3& p);

}  // namespace facies::mesh
