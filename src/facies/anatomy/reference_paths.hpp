// SPDX-License-Identifier: Apache-2.0
// Muscle paths of the reference face: from point numbers to polylines inside the tissue.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "facies/anatomy/face_tables.hpp"
#include "facies/anatomy/reference_mesh.hpp"

namespace facies::anatomy {

/// What a fibre's row of the table refers to.
struct FibreFiles {
  std::vector<PointRow> points;  ///< of all fibres of both sides
  std::string points_file;
  std::map<std::string, std::vector<NumberAt>> rings;  ///< element numbers by the table's file name
};

/// Adds to `problems`: fibres that name points which do not exist or lie on the right side, points far outside the face,
/// rings that name unknown elements. Empty lists (files that could not be read) are passed over.
void check_fibres(const FaceTables& tables, const FibreFiles& files, const ReferenceMesh& mesh,
                  Problems& problems);

struct ReferencePaths {
  std::vector<MusclePaths> muscles;
  std::size_t n_points = 0;         ///< of fibres, both sides
  std::size_t n_moved = 0;          ///< of these, moved to the surface of the tissue
  std::size_t n_wedges_passed = 0;  ///< wedges of the rings
};

/// The paths of muscles whose tables and files have no problem.
///
/// As the reference program does: a left fibre's points that lie outside the tissue are moved to its surface; the right
/// fibre is the mirror image of the moved left one (y to -y), moved again where it lies outside, the face being not
/// symmetric. A ring goes through the centroids of the hexahedra of its list, in that order, and closes; wedges are
/// passed over.
[[nodiscard]] ReferencePaths make_reference_paths(const FaceTables& tables, const FibreFiles& files,
                                                  const ReferenceMesh& mesh);

}  // namespace facies::anatomy
