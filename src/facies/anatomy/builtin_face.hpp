// SPDX-License-Identifier: Apache-2.0
// The built-in face: a face of our own, drawn after published measurements and changed to any others
// (docs/theory/builtin-face.md).
#pragma once

#include <filesystem>
#include <string>

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// The face that `options` describes (builtin_options.hpp) from the drawings and tables in `folder` (data/builtin). Throws UsageError
/// for options that are wrong or contradict each other, DataError with everything wrong with the files.
[[nodiscard]] FaceAnatomy make_builtin_face(const std::string& options,
                                            const std::filesystem::path& folder);

}  // namespace facies::anatomy
