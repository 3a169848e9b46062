// SPDX-License-Identifier: Apache-2.0
// The jaw of the built-in face: bones as drawn, changed with the face.
#pragma once

#include <filesystem>
#include <functional>

#include "facies/anatomy/jaw.hpp"
#include "facies/base/error.hpp"

namespace facies::anatomy {

/// Where a point of the drawing goes [mm].
using PointMap = std::function<Vec3(const Vec3&)>;

/// The jaw of the tables and drawings in `folder` after its points have moved. Muscles are as much longer than their optimal length as
/// they were, the mass follows the volume of the mandible and its teeth. Surfaces are the smooth ones of the drawings, refined twice.
/// Adds what is wrong with files to `problems`; their names to `files`.
[[nodiscard]] Jaw make_builtin_jaw(const std::filesystem::path& folder, const PointMap& move,
                                   std::vector<std::filesystem::path>& files, Problems& problems);

}  // namespace facies::anatomy
