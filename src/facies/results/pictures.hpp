// SPDX-License-Identifier: Apache-2.0
// The pictures of a run: the same face from the same three sides in every state.
#pragma once

#include <filesystem>

#include "facies/results/callouts.hpp"
#include "facies/results/render.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

struct PictureOptions {
  std::string title;    ///< "smile-open"
  std::string subject;  ///< what is shown, in small print: the source of the face
  int height = 760;     ///< of each view [pixels]
  int threads = 1;      ///< has no influence on the pictures
};

/// The landmarks of the mesh as read that a camera sees, in its picture; `scene` is what it looks at.
[[nodiscard]] std::vector<Dot> landmarks_in(const Subject& subject, const Scene& scene,
                                            const Camera& camera);

/// Writes PNG files into `folder`, each with the views front, three-quarter and profile (the subject's right side):
/// rest.png (the mesh as read), landmarks.png (the same with the subject's landmarks that can be seen),
/// tensioned-rest.png (`rest`), expression.png (`last`), displacement.png (`last`, coloured by the distance from where
/// each point was at `rest`) and overview.png with all of them at half size. Without `rest`, displacements count from the
/// mesh as read; where `last` is `rest` itself there is no expression to show. Returns the names of the files written.
/// Throws UsageError where the folder cannot take them.
std::vector<std::string> write_pictures(const Subject& subject, const Snapshot* rest,
                                        const Snapshot& last, const std::filesystem::path& folder,
                                        const PictureOptions& options);

}  // namespace facies::results
