// SPDX-License-Identifier: Apache-2.0
// Whole files in and out. Nothing is ever left half-written: a file appears complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace facies {

/// The whole file. Throws DataError where it does not exist, is a folder or cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Replaces `path` by `content` in one move (a temporary file beside it, flushed, then renamed).
/// Throws UsageError where the folder is not writable or the disk is full; `path` is then as it was.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace facies
