// SPDX-License-Identifier: Apache-2.0
// The files of the built-in face for tests: where they are, and a copy to spoil.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"

namespace facies::anatomy {

inline std::filesystem::path builtin_folder() {
  return std::filesystem::path(FACIES_SOURCE_DIR) / "data" / "builtin";
}

/// A copy of data/builtin that disappears with the object.
class BuiltinFiles {
 public:
  BuiltinFiles() { std::filesystem::copy(builtin_folder(), path()); }

  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "builtin"; }

  /// Puts `with` in the place of the first `old`, which must be there.
  void replace(const std::string& file, const std::string& old, const std::string& with) {
    std::string content = read_file(path() / file);
    const std::size_t place = content.find(old);
    ASSERT_NE(place, std::string::npos) << old << " in " << file;
    content.replace(place, old.size(), with);
    write(file, content);
  }
  void append(const std::string& file, const std::string& line) {
    write(file, read_file(path() / file) + line + "\n");
  }
  void write(const std::string& file, const std::string& content) {
    std::ofstream(path() / file, std::ios::binary) << content;
  }

 private:
  support::TemporaryFolder folder_;
};

}  // namespace facies::anatomy
