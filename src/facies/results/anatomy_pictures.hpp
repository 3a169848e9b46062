// SPDX-License-Identifier: Apache-2.0
// Pictures of what lies below the skin: bones and teeth in their places, and a cut through the tissue.
#pragma once

#include "facies/results/figure.hpp"
#include "facies/results/pictures.hpp"
#include "facies/results/stage.hpp"

namespace facies::results {

/// Writes PNG files into `folder` for each of the snapshots, all in one frame: NN-STEP-bones.png (front, three-quarter, profile;
/// for a subject with bones) and NN-STEP-section.png (section_views). NN is the number of the step. Returns the names of the files
/// written. Throws UsageError where the folder cannot take them.
std::vector<std::string> write_anatomy_pictures(const Subject& subject,
                                                std::span<const Snapshot> snapshots,
                                                const std::filesystem::path& folder,
                                                const PictureOptions& options);

/// What the colours of a cut mean: the layers, and bone where the subject has any.
[[nodiscard]] std::vector<LegendEntry> section_legend(const Subject& subject);

}  // namespace facies::results
