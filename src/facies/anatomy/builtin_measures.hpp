// SPDX-License-Identifier: Apache-2.0
// The measurements that the built-in face is made from, and where they put its landmarks (docs/theory/builtin-face.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facies/anatomy/cage.hpp"
#include "facies/base/error.hpp"
#include "facies/math/tensor.hpp"

namespace facies::anatomy {

/// A landmark of anthropometry: "ch", the mouth corner.
struct SkinLandmark {
  std::string name;
  std::string point;  ///< of the drawing of the skin; of its right half
  std::string meaning;
  bool both = false;  ///< each half has one; the others are in the midline
};

enum class MeasureKind {
  distance,  ///< from a to b in a straight line
  width,     ///< from a of the right half to a of the left
  forward,   ///< how far a lies in front of b
  up         ///< how far a lies above b
};

/// A measurement of a face [mm].
struct FaceMeasure {
  std::string key;  ///< "mouth_width"
  std::string meaning;
  MeasureKind kind = MeasureKind::distance;
  std::string a, b;     ///< landmarks; b is empty for a width
  std::string part_of;  ///< key of a height that this one changes with
  std::string rest_of;  ///< key of a height that this one is what is left of
  double male = 0.0, female = 0.0;
  double smallest = 0.0, largest = 0.0;
};

struct MeasureTables {
  std::vector<SkinLandmark> landmarks;
  std::vector<FaceMeasure> measures;
};

/// landmarks.csv and measures.csv of a folder. Adds everything that is wrong to `problems`: among it landmarks that the drawing
/// of the skin does not have, or has on the other side; an empty drawing, which could not be read, is passed over.
[[nodiscard]] MeasureTables read_measures(const std::filesystem::path& folder, const Cage& skin,
                                          Problems& problems);

/// Values of measures by key [mm].
using MeasureValues = std::map<std::string, double>;

/// What a face has to have: those given, and for the others the preset's, heights in proportion to the heights that they are
/// parts of. A height that is what is left of another is missing unless it is given, and then the other is, unless that is given too.
/// Throws UsageError for each value out of its range; keys of `given` that no measure has are passed over.
[[nodiscard]] MeasureValues complete_values(const std::vector<FaceMeasure>& measures, bool female,
                                            const MeasureValues& given);

/// Landmarks of the right half and the midline by name [mm], in the axes of a face.
using LandmarkPlaces = std::map<std::string, Vec3>;

/// The measure of these landmarks [mm]. Throws std::out_of_range where one is not there.
[[nodiscard]] double measured(const FaceMeasure& measure, const LandmarkPlaces& places);

/// The places likeliest to come from `drawn`, after it has been made as large as the values ask for on average, that give every
/// measure with a value its value: the smallest change where those of two landmarks go together the more the nearer they are, on
/// both halves alike. Landmarks of the midline stay in it, and landmarks of no measure go along with the others.
/// Throws UsageError where there are no such places, with every measure that is more than 0.5 mm off, and where a measure without a
/// value comes out of its range: the values contradict each other.
[[nodiscard]] LandmarkPlaces place_landmarks(const std::vector<FaceMeasure>& measures,
                                             const MeasureValues& values,
                                             const LandmarkPlaces& drawn);

}  // namespace facies::anatomy
