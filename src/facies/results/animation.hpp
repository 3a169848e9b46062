// SPDX-License-Identifier: Apache-2.0
// A step as a moving picture: the face in the light and cut open, state after state.
#pragma once

#include "facies/results/pictures.hpp"

namespace facies::results {

/// Writes NN-STEP-animation.png, an animated PNG file, into `folder` and returns its name. `frames`: states of one step in the order
/// in which they are shown, at least one; of each only step, step_number, load and state are used. The first and the last stay
/// for a second, all between them together for about two. Throws UsageError where the folder cannot take it.
std::string write_animation(const Subject& subject, std::span<const Snapshot> frames,
                            const std::filesystem::path& folder, const PictureOptions& options);

}  // namespace facies::results
