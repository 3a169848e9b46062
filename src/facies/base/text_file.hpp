// SPDX-License-Identifier: Apache-2.0
// A text file that somebody else wrote, cut into lines that know where they stand.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "facies/base/error.hpp"

namespace facies {

/// The beginning of `text` in quotes, with everything that is not printable replaced by '?'.
[[nodiscard]] std::string excerpt(std::string_view text);

/// A text file in memory. Lines end with "\n" or "\r\n"; the last one may lack its end.
class TextFile {
 public:
  /// Reads `path`. Adds a problem, and has no lines, where the file is missing, unreadable, empty, not text or larger
  /// than 64 MiB (a hundred times the largest file that belongs here).
  TextFile(const std::filesystem::path& path, Problems& problems);

  [[nodiscard]] bool is_usable() const { return !lines_.empty(); }
  [[nodiscard]] std::size_t n_lines() const { return lines_.size(); }
  /// Line `i`, counted from 0, without its end.
  [[nodiscard]] std::string_view line(std::size_t i) const;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// "path:line" with the line counted from 1.
  [[nodiscard]] std::string where(std::size_t line) const;
  /// "path:line:column" of a piece of that line, both counted from 1.
  [[nodiscard]] std::string where(std::size_t line, std::string_view piece) const;

 private:
  struct Extent {
    std::size_t begin = 0;
    std::size_t size = 0;
  };

  std::string name_;
  std::string content_;
  std::vector<Extent> lines_;
};

}  // namespace facies
