// SPDX-License-Identifier: Apache-2.0
// The file formats of the reference face (artisynth_models, folder face): one function per format, nothing about their
// meaning. Each adds everything wrong with its file to `problems`, with file, line and column, and then returns nothing.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "facies/base/text_file.hpp"
#include "facies/math/tensor.hpp"

namespace facies::anatomy {

/// A number that names a node or an element, and the place where it stands.
struct NumberAt {
  long value = 0;
  std::string where;  ///< "file:line:column"
};

struct PointRow {
  long number = 0;
  Vec3 X = Vec3::Zero();  ///< [mm]
  std::string where;      ///< "file:line"
};

struct ElementRow {
  long number = 0;
  std::array<long, 8> nodes{};
  std::string where;  ///< "file:line"
};

/// Lines "number x y z" in metres, numbers in any order but each only once. Returned in mm.
[[nodiscard]] std::vector<PointRow> read_points(const std::filesystem::path& path,
                                                Problems& problems);

/// ANSYS element list: 14 integers a line, eight nodes, five attributes, the element's number (each only once).
[[nodiscard]] std::vector<ElementRow> read_elements(const std::filesystem::path& path,
                                                    Problems& problems);

/// Nine numbers a line, a row-major 3x3 matrix whose first column is a direction; line i belongs to element i. Returned:
/// that column, of length 1. The other two columns mean nothing (docs/theory/anatomy.md).
[[nodiscard]] std::vector<Vec3> read_directions(const std::filesystem::path& path,
                                                Problems& problems);

enum class ListForm {
  list,          ///< numbers between blanks or line ends
  first_column,  ///< a number at the beginning of each line; what follows may touch it ("1204-0.365") and is passed over
};

/// Whole numbers, none twice.
[[nodiscard]] std::vector<NumberAt> read_numbers(const std::filesystem::path& path, ListForm form,
                                                 Problems& problems);

}  // namespace facies::anatomy
