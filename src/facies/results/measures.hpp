// SPDX-License-Identifier: Apache-2.0
// Numbers taken from states: how far landmarks moved, how long distances are, tension, volumes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facies/results/subject.hpp"

namespace facies::results {

/// Where a landmark is and how it came there.
struct LandmarkMeasure {
  std::string landmark;
  Vec3 x = Vec3::Zero();      ///< position [mm]
  Vec3 u = Vec3::Zero();      ///< from its position in the rest state [mm]
  double displacement = 0.0;  ///< |u| [mm]
};

/// Every landmark of the subject, in its order. `rest`: state that displacements count from; nullptr: the mesh.
[[nodiscard]] std::vector<LandmarkMeasure> measure_landmarks(const Subject& subject,
                                                             const mechanics::State& state,
                                                             const mechanics::State* rest);

/// A distance between two landmarks.
struct PairMeasure {
  std::string a, b;
  double rest = 0.0;    ///< [mm]
  double length = 0.0;  ///< [mm]
  double change_percent = 0.0;
};

/// Every pair of the subject, in its order; `rest` as above. Throws BugError for a pair of unknown landmarks.
[[nodiscard]] std::vector<PairMeasure> measure_pairs(const Subject& subject,
                                                     const mechanics::State& state,
                                                     const mechanics::State* rest);

/// The largest principal stress and its axis.
struct PrincipalTension {
  double value = 0.0;  ///< [kPa]
  Vec3 direction =
      Vec3::UnitX();  ///< unit; of the two ways the one whose largest component is positive
};

[[nodiscard]] PrincipalTension principal_tension(const Sym3<double>& sigma);

/// The smallest and largest J of a state and where they are.
struct DilatationExtremes {
  Index smallest_element = -1, largest_element = -1;
  double smallest = 1.0, largest = 1.0;
};

/// The first element of each extreme where several share it.
[[nodiscard]] DilatationExtremes measure_dilatation(const Snapshot& snapshot);

/// Volumes of the tissue [mm^3].
struct Volumes {
  double mesh = 0.0;         ///< as read
  double stress_free = 0.0;  ///< before any tension: the sum of deformed volume by J
  double deformed = 0.0;     ///< in this state
};

[[nodiscard]] Volumes measure_volumes(const Subject& subject, const Snapshot& snapshot);

/// How much of the outermost layer is under tension: parts of its deformed volume whose largest principal stress is
/// positive, 0..1.
struct TensionShare {
  double all = 0.0;
  /// Without elements that touch a border of the face set "outer" (rim, mouth, eyes, nostrils); nothing where none is left.
  std::optional<double> away_from_borders;
};

[[nodiscard]] TensionShare measure_tension_share(const Subject& subject, const Snapshot& snapshot);

/// The node positions X + u [n_nodes] [mm].
[[nodiscard]] std::vector<Vec3> positions(const mesh::Mesh& mesh, const mechanics::State& state);

}  // namespace facies::results
