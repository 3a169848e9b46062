// SPDX-License-Identifier: Apache-2.0
// What is known about a face in the layout of artisynth_models beside its files: data/reference-face/*.csv. Numbers are
// those of the files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "facies/anatomy/artisynth_files.hpp"
#include "facies/anatomy/face_anatomy.hpp"

namespace facies::anatomy {

/// A row of default-sets.csv: the file that holds a set of nodes.
struct SetFile {
  std::string set;
  std::filesystem::path path;  ///< below the folder of the face
  ListForm form = ListForm::list;
  long first_number = 1;  ///< what the file calls the first node: 1, or 0 where it counts from 0
  std::size_t count = 0;  ///< entries of the complete file
};

/// A row of muscle-fibres.csv.
struct FibreRow {
  std::string muscle;
  std::string where;             ///< "file:line:column"
  std::vector<NumberAt> points;  ///< of the left side, mirrored for the right; empty for a ring
  std::filesystem::path ring;    ///< file with a closed ring of elements; empty for a fibre
  std::size_t count = 0;         ///< entries of `points` or of the complete file
};

struct MuscleRow {
  std::string name;
  std::string meaning;
};

struct LandmarkRow {
  std::string name;
  std::string meaning;
  NumberAt node;
  bool in_paper = false;
};

struct FaceTables {
  std::vector<std::filesystem::path> files;  ///< the tables themselves
  std::vector<SetFile> sets;
  std::vector<MuscleRow> muscles;
  std::vector<FibreRow> fibres;
  std::vector<LandmarkRow> landmarks;
  std::vector<LandmarkPair> pairs;
};

/// The tables of `folder` (data/reference-face). Adds everything wrong with them to `problems`: unreadable files, names
/// that occur twice, fibres of muscles and pairs of landmarks that the other tables do not have.
[[nodiscard]] FaceTables read_face_tables(const std::filesystem::path& folder, Problems& problems);

}  // namespace facies::anatomy
