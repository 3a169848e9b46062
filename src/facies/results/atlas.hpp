// SPDX-License-Identifier: Apache-2.0
// Pictures of the anatomy of a face as it is read: skin, bones, muscles by name, layers, skin tension lines, landmarks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "facies/results/pictures.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// The files that write_atlas may write.
[[nodiscard]] const std::vector<std::string>& atlas_files();

/// Writes PNG files into `folder`: overview, skin, layers, and, of what the face has, bones, muscles, muscles-one-by-one, tension-lines,
/// landmarks. All are drawn before the first is written. An element that belongs to several muscles has, among others, the
/// colour of the smallest of them. Returns the names of the files written. Throws UsageError where the folder cannot take them.
std::vector<std::string> write_atlas(const Subject& subject, const std::filesystem::path& folder,
                                     const PictureOptions& options);

}  // namespace facies::results
