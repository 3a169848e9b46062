// SPDX-License-Identifier: Apache-2.0
// How thick the skin of the built-in face is, region by region (docs/theory/builtin-face.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "facies/anatomy/cage.hpp"

namespace facies::anatomy {

/// Points of the drawing of the skin where its thickness is known.
struct SkinRegion {
  std::string name;
  std::vector<Index> points;        ///< of both halves
  double male = 0.0, female = 0.0;  ///< [mm]
};

/// A table of regions (skin-thickness.csv). Adds everything that is wrong to `problems`: among it points that two regions have.
[[nodiscard]] std::vector<SkinRegion> read_skin_regions(const std::filesystem::path& path,
                                                        const Cage& skin, Problems& problems);

/// The thickness at each point of the drawing [mm]: what its region says, and the mean of the net's neighbours at points of no region.
/// Throws BugError where there is no region.
[[nodiscard]] std::vector<double> skin_thickness(const Cage& skin,
                                                 const std::vector<SkinRegion>& regions,
                                                 bool female);

}  // namespace facies::anatomy
