// SPDX-License-Identifier: Apache-2.0
// Rotations: their vectors (axis times angle [rad]) and matrices.
#pragma once

#include "facies/math/tensor.hpp"

namespace facies {

/// [w]: the matrix with [w] v = w x v.
[[nodiscard]] Mat3 cross_matrix(const Vec3& w);

/// exp([w]): the rotation by |w| about w.
[[nodiscard]] Mat3 rotation_matrix(const Vec3& w);

/// The w with |w| <= pi and exp([w]) = R, for a rotation R.
[[nodiscard]] Vec3 rotation_vector(const Mat3& R);

}  // namespace facies
