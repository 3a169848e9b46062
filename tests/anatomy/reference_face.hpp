// SPDX-License-Identifier: Apache-2.0
// Where the tests find the reference face, and what an independent program computed from it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "facies/anatomy/sources.hpp"
#include "facies/base/files.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {

inline std::filesystem::path data_folder() {
  return std::filesystem::path(FACIES_SOURCE_DIR) / "data";
}

/// The folder that holds face/, or nothing where the reference face is not on this machine.
inline std::optional<std::filesystem::path> reference_folder() {
  const char* variable = std::getenv("FACIES_REFERENCE_FACE");  // NOLINT(concurrency-mt-unsafe)
  std::filesystem::path folder = variable != nullptr ? std::filesystem::path(variable)
                                                     : std::filesystem::path(FACIES_SOURCE_DIR) /
                                                           "../shared/reference-face/upstream";
  if (!std::filesystem::exists(folder / "face" / "geometry")) return std::nullopt;
  return folder;
}

/// Skips where there is no reference face; else `face()` is it.
class ReferenceFaceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!reference_folder()) {
      GTEST_SKIP() << "the reference face is not here: set FACIES_REFERENCE_FACE to the folder "
                      "that holds 'face'";
    }
  }

  static const FaceAnatomy& face() {
    static const FaceAnatomy loaded =
        load_face("artisynth:" + reference_folder()->string(), data_folder());
    return loaded;
  }
};

using CsvRow = std::map<std::string, std::string>;

/// Rows of a table computed by an independent program, beside the authors' folder; none where it is not there.
inline std::vector<CsvRow> derived_table(const std::string& name) {
  const std::filesystem::path path = *reference_folder() / ".." / "derived" / name;
  if (!std::filesystem::exists(path)) return {};
  const std::string text = read_file(path);
  std::vector<CsvRow> rows;
  std::vector<std::string_view> header;
  for (const std::string_view line : split(text, '\n')) {
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = split(line, ',');
    if (header.empty()) {
      header = fields;
      continue;
    }
    CsvRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i)
      row.emplace(header[i], fields.at(i));
  }
  return rows;
}

inline double real(const CsvRow& row, const std::string& column) {
  return parse_number(row.at(column)).value();
}

/// The files number nodes and elements without gaps from 1.
inline Index index_of(const CsvRow& row, const std::string& column) {
  return static_cast<Index>(parse_integer(row.at(column)).value() - 1);
}

}  // namespace facies::anatomy
