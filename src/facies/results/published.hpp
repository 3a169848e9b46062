// SPDX-License-Identifier: Apache-2.0
// Published numbers to compare with, read from a table in data/published/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace facies::results {

/// A number that a publication states about an expression.
struct PublishedValue {
  std::string expression;  ///< name of the scenario: "smile-open"
  std::string quantity;    ///< "displacement", "largest_displacement", "distance_change" ...
  std::string subject;     ///< "RMC", "RMC-LMC", landmarks with blanks between
  double value = 0.0;
  std::string unit;        ///< "mm", "%", "deg"
  std::string comparison;  ///< "stated", "about", "almost", "up to"
  std::string place;       ///< where in the publication
  std::string sentence;    ///< word for word

  /// "12", "about 11", "up to 14".
  [[nodiscard]] std::string text() const;
};

/// All rows of a table (comma separated, quotes around fields with commas, "#" starts a comment line). Throws DataError
/// with every wrong line.
[[nodiscard]] std::vector<PublishedValue> read_published(const std::filesystem::path& path);

/// The rows about one expression.
[[nodiscard]] std::vector<PublishedValue> about_expression(
    const std::vector<PublishedValue>& values, const std::string& expression);

}  // namespace facies::results
