// SPDX-License-Identifier: Apache-2.0
// Our own tables under data/: CSV with a header line. Fields hold neither commas nor quotes; lines that begin with # are
// comments.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/base/text_file.hpp"

namespace facies::anatomy {

class Table {
 public:
  /// Reads `path`. Adds a problem for a file that cannot be read, for each of `columns` that its header lacks and for
  /// each row with more or fewer fields than the header; such a table has no rows.
  Table(const std::filesystem::path& path, const std::vector<std::string>& columns,
        Problems& problems);

  [[nodiscard]] std::size_t n_rows() const { return rows_.size(); }
  /// The field, which may be empty. Throws BugError where the table has no such column.
  [[nodiscard]] std::string_view text(std::size_t row, const std::string& column) const;
  /// The field as a whole number; adds a problem and returns nothing where it is none.
  [[nodiscard]] std::optional<long> integer(std::size_t row, const std::string& column,
                                            Problems& problems) const;
  /// The field as a finite number; adds a problem and returns nothing where it is none.
  [[nodiscard]] std::optional<double> number(std::size_t row, const std::string& column,
                                             Problems& problems) const;
  /// The field as 0 or 1; adds a problem where it is neither.
  [[nodiscard]] bool flag(std::size_t row, const std::string& column, Problems& problems) const;
  /// The name in `column`; a problem where it is empty or was in `names` before, to which it is added.
  [[nodiscard]] std::string new_name(std::size_t row, const std::string& column,
                                     std::vector<std::string>& names, Problems& problems) const;
  /// The name in `column`; a problem where it is none of `known`, of which `expected` says what they are. An empty list, whose
  /// own table could not be read, is passed over.
  [[nodiscard]] std::string known_name(std::size_t row, const std::string& column,
                                       const std::vector<std::string>& known,
                                       const std::string& expected, Problems& problems) const;
  /// "file:line:column" of the field.
  [[nodiscard]] std::string where(std::size_t row, const std::string& column) const;

 private:
  void add_row(std::size_t line, Problems& problems);

  TextFile file_;
  std::vector<std::string> header_;
  std::vector<std::size_t> rows_;  ///< lines of the file
};

}  // namespace facies::anatomy
