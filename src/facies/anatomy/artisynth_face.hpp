// SPDX-License-Identifier: Apache-2.0
// The paper's own face, read from the folder layout of the public repository artisynth/artisynth_models.
#pragma once

#include <filesystem>

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// Reads the face in `folder` (src/artisynth/models of a clone: it holds face/geometry and face/data) with the tables
/// of `tables` (data/reference-face). What is read, and what is made of it: docs/howto/run-on-the-reference-face.md.
/// Throws DataError with everything found wrong in all files and tables, surfaces of bones among them (read_bone_surface).
[[nodiscard]] FaceAnatomy read_artisynth_face(const std::filesystem::path& folder,
                                              const std::filesystem::path& tables);

}  // namespace facies::anatomy
