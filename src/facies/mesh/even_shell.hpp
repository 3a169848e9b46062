// SPDX-License-Identifier: Apache-2.0
// Moves the inner surface of a shell until its elements are well shaped.
#pragma once

#include "facies/mesh/layered_shell.hpp"

namespace facies::mesh {

/// The side of a plane on which a vertex of the inner surface is to be; everywhere where the normal is zero.
struct HalfSpace {
  Vec3 point = Vec3::Zero();   ///< [mm]
  Vec3 normal = Vec3::Zero();  ///< unit, towards that side
};

struct EvenShellOptions {
  /// Corners with a smaller scaled Jacobian are to become better.
  double wanted = 0.5;
  /// What it costs to move a vertex of the inner surface by 1 mm, where a corner that is flat costs wanted^2 [1/mm^2].
  double stiffness = 1e-3;
  /// One for each vertex of the net, or none at all. To be 1 mm on the wrong side costs `hardness`.
  std::vector<HalfSpace> sides;
  double hardness = 2.0;
  int most_iterations = 300;
};

/// Control points of a smooth inner surface near the one that `control` gives, for which the elements of the shell are better shaped: the
/// least sum over corners of (wanted - scaled Jacobian)^2, where that is positive, and of stiffness times the squared way of each
/// vertex (liu1989, by liblbfgs). `limit` [n_vertices x n_control] makes vertices of control points; the shell's own inner surface is not
/// looked at. Corners that begin inside out come right where there is room. Throws BugError where lists do not fit each other.
[[nodiscard]] std::vector<Vec3> even_inner_surface(const Shell& shell, const Weights& limit,
                                                   std::vector<Vec3> control,
                                                   const EvenShellOptions& options);

}  // namespace facies::mesh
