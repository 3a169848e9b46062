// SPDX-License-Identifier: Apache-2.0
// What the built-in face is made of: drawings of its surfaces and tables about them, all in data/builtin.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facies/anatomy/builtin_depths.hpp"
#include "facies/anatomy/builtin_measures.hpp"
#include "facies/anatomy/builtin_skin.hpp"
#include "facies/anatomy/cage.hpp"
#include "facies/anatomy/skin_sites.hpp"

namespace facies::anatomy {

/// A point of a curve in the frontal view of the drawing.
struct DrawnPoint {
  double lateral = 0.0, up = 0.0;  ///< [mm]
  double depth = 0.0;              ///< from the skin's surface (0) to the inner surface (1)
  std::string where = {};          ///< file, line and column, for messages
};

/// What is wrong with a point where no site is (SkinSites).
[[nodiscard]] Problem beside_the_face(const DrawnPoint& point);

/// How the points of a fibre go on: it ends with the last one; its mirror image closes it, from the midline to the
/// midline; it comes back to the first one on its own side.
enum class FibreForm { fibre, ring, loop };

/// A fibre of the right half of a muscle. At least two points, a loop three.
struct DrawnFibre {
  std::string muscle, name;
  FibreForm form = FibreForm::fibre;
  std::vector<DrawnPoint> points;
};

struct DrawnMuscle {
  std::string name, meaning;
  double width = 0.0;      ///< of the band along each fibre, in the plane of the skin [mm]
  double thickness = 0.0;  ///< of that band [mm]
};

/// A point that is followed through a run (Landmark).
struct DrawnLandmark {
  std::string name;
  std::string point;  ///< of the drawing of the skin
  std::string meaning;
  bool in_paper = false;
};

/// Everything but the jaw, whose tables are jaw_tables.hpp's. Names that point from one file into another have been looked up.
struct Drawings {
  std::vector<std::filesystem::path> files;  ///< all that were read
  MeasureTables measures;
  std::vector<DepthSite> depths;
  Cage skin;
  std::vector<Vec3> inner;  ///< below each point of the skin [mm]
  std::vector<SkinRegion> skin_regions;
  std::vector<DrawnMuscle> muscles;
  std::vector<DrawnFibre> fibres;
  std::vector<std::vector<DrawnPoint>>
      tension_lines;  ///< of the right half; at least two points each
  std::vector<DrawnLandmark> landmarks;
  std::vector<std::array<std::string, 2>> pairs;  ///< of landmarks
  std::map<std::string, std::vector<Index>>
      regions;  ///< points of the skin, both halves, by node set
};

/// Reads everything. Throws DataError with everything wrong.
[[nodiscard]] Drawings read_drawings(const std::filesystem::path& folder);

}  // namespace facies::anatomy
