// SPDX-License-Identifier: Apache-2.0
// The result folder: made or emptied before anything is calculated, so that no run ends with nowhere to put its results.
#pragma once

#include <filesystem>
#include <string>

namespace facies::results {

/// Whether a run of facies writes a file of this name, relative to its result folder ("fields/01-tension.vtu").
/// Temporary files (".part") that a killed run may have left count too.
[[nodiscard]] bool is_result_file(const std::string& relative);

/// Makes `folder` with fields/ and figures/ in it, empty. A folder that exists has to be empty, or, with `force`, to hold
/// nothing but result files: those are removed. Throws UsageError, with nothing changed, where the folder holds results
/// and `force` is not given, holds anything else, is a file, cannot be written to, or where the folder that it should stand in
/// does not exist.
void prepare_folder(const std::filesystem::path& folder, bool force);

/// The same for a folder with pictures of a face (atlas_files) and nothing else.
void prepare_picture_folder(const std::filesystem::path& folder, bool force);

/// What a study is called in its folder; where this file is, a study is.
inline constexpr const char* study_file = "study.yaml";

/// Makes `folder` for the results of a study, or leaves it as it is where it holds one. Anything else is refused or, with
/// `force`, removed as by prepare_folder. Throws UsageError.
void prepare_study_folder(const std::filesystem::path& folder, bool force);

}  // namespace facies::results
