// SPDX-License-Identifier: Apache-2.0
// What results need to know of a face.
#pragma once

#include <span>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/results/subject.hpp"
#include "facies/scenario/jaw_model.hpp"

namespace facies::scenario {

/// The face, which must outlive the subject, with these of its muscles. Its jaw is where it settled or, where `settled` is
/// null, in its starting pose, all bones fixed. Bodies are left empty: they are a model's.
[[nodiscard]] results::Subject subject_of(const anatomy::FaceAnatomy& face,
                                          std::span<const anatomy::Muscle> muscles,
                                          const SettledJaw* settled);

}  // namespace facies::scenario
