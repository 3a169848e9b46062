// SPDX-License-Identifier: Apache-2.0
// Small questions about text: nearest known word, fields of a line, numbers read strictly.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facies {

/// The known word that `word` most likely meant, or nothing where none is near
/// (edit distance with swaps of neighbours, ignoring case, at most a third of the word's length and at least 1).
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      std::span<const std::string> known);

/// "did you mean 'x'?" where nearest_word finds one, else "known: a, b, c".
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// The fields of a line, cut at runs of blanks, tabs and carriage returns.
[[nodiscard]] std::vector<std::string_view> split_blanks(std::string_view line);

/// The fields of a line, cut at every `separator`, each without blanks around it. Empty fields are kept.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, char separator);

/// Without blanks, tabs, carriage returns and newlines at both ends.
[[nodiscard]] std::string_view trim(std::string_view text);

/// The whole text as a finite number, or nothing ("1.5x", "", "nan" and "inf" are nothing).
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The whole text as an integer, or nothing.
[[nodiscard]] std::optional<long> parse_integer(std::string_view text);

}  // namespace facies
