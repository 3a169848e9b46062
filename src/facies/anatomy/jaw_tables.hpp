// SPDX-License-Identifier: Apache-2.0
// The jaw of a face from tables of ours: data/reference-face/jaw-*.csv.
#pragma once

#include <filesystem>
#include <vector>

#include "facies/anatomy/jaw.hpp"
#include "facies/base/error.hpp"

namespace facies::anatomy {

/// The tables that read_jaw_tables reads.
[[nodiscard]] std::vector<std::filesystem::path> jaw_table_files(
    const std::filesystem::path& folder);

/// The jaw of the tables in `folder`; files of surfaces as they stand there, relative to the folder of the face. A guide's
/// curve begins, and a stop's plane lies, where its point is in the intercuspal pose (the plane `offset_mm` behind it).
/// Adds everything wrong with the tables to `problems`: unreadable files, names that occur twice, rows that name bones,
/// points or muscles which the other tables do not have, muscles whose ends coincide or are on one bone, numbers that are
/// impossible. The jaw is then not to be used. Surfaces are not read.
[[nodiscard]] Jaw read_jaw_tables(const std::filesystem::path& folder, Problems& problems);

}  // namespace facies::anatomy
