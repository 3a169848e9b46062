// SPDX-License-Identifier: Apache-2.0
// Where faces come from: "patch", "patch:key=value,...", "artisynth:DIR". One line per source in sources.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

struct SourceSpec {
  std::string name;     ///< "artisynth"
  std::string usage;    ///< "artisynth:DIR"
  std::string summary;  ///< one line for `facies list faces`
};

[[nodiscard]] const std::vector<SourceSpec>& sources();

/// The face that `spec` names. `data` is the folder of our own tables (landmarks, fibres).
/// Throws UsageError for an unknown source, DataError for unusable files, naming file, line and remedy.
[[nodiscard]] FaceAnatomy load_face(const std::string& spec, const std::filesystem::path& data);

}  // namespace facies::anatomy
