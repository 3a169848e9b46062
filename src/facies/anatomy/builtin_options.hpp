// SPDX-License-Identifier: Apache-2.0
// What a user may say about the built-in face: "builtin:preset=female,size=coarse,mouth_width=47 mm".
#pragma once

#include <string>
#include <vector>

#include "facies/anatomy/builtin_depths.hpp"
#include "facies/anatomy/builtin_measures.hpp"

namespace facies::anatomy {

/// How fine the mesh is: each size has four times the columns of the one before; from fine on twice the layers too.
enum class FaceSize { coarse, standard, fine, finer };

struct BuiltinOptions {
  FaceSize size = FaceSize::standard;
  bool female = false;
  MeasureValues given;   ///< measures that are not the preset's [mm]
  MeasureValues depths;  ///< of soft tissue, where they are not as drawn [mm]
};

/// The options with their defaults, for messages and `facies list faces`.
[[nodiscard]] std::string builtin_usage();

/// Reads "key=value,key=value" ("" for the defaults). Throws UsageError with all unknown keys, impossible words, lengths
/// without a unit and lengths out of their ranges.
[[nodiscard]] BuiltinOptions parse_builtin_options(const std::string& text,
                                                   const std::vector<FaceMeasure>& measures,
                                                   const std::vector<DepthSite>& depths);

}  // namespace facies::anatomy
