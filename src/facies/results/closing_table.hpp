// SPDX-License-Identifier: Apache-2.0
// The text that a run ends with on the terminal: what it measured, beside what was published.
#pragma once

#include "facies/results/published.hpp"
#include "facies/results/summary.hpp"

namespace facies::results {

/// Landmark displacements [mm]: name, model, paper, difference; "-" where nothing is published. Then, where the paper
/// gives one, the largest displacement of a group of landmarks.
[[nodiscard]] std::string landmark_table(const std::vector<LandmarkMeasure>& landmarks,
                                         const std::vector<PublishedValue>& published);

/// Distances at rest and now [mm], change [%], the paper's change, difference [percentage points].
[[nodiscard]] std::string distance_table(const std::vector<PairMeasure>& pairs,
                                         const std::vector<PublishedValue>& published);

/// The distance of the incisors [mm] and the paper's.
[[nodiscard]] std::string jaw_line(const JawMeasure& jaw,
                                   const std::vector<PublishedValue>& published);

/// For every surface that may be touched how many points press on it, how near, how hard.
[[nodiscard]] std::string contact_table(const std::vector<ContactMeasure>& contacts);

/// All of these, extremes of J with their places, volume changes and the share of tensioned skin. `published` are the
/// rows about this expression; none where the face is not that of the publication.
[[nodiscard]] std::string closing_text(const Headline& headline,
                                       const std::vector<PublishedValue>& published);

}  // namespace facies::results
