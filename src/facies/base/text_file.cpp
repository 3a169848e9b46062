// SPDX-License-Identifier: Apache-2.0
#include "facies/base/text_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/files.hpp"
#include "facies/base/text.hpp"

namespace facies {
namespace {

constexpr std::size_t max_excerpt = 40;
constexpr std::uintmax_t max_bytes = std::uintmax_t{64} << 20U;

bool is_text(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x20 || letter == '\t' || letter == '\n' || letter == '\r';
}

bool is_printable(char letter) {
  return letter >= 0x20 && letter < 0x7f;
}

/// The content, or an empty text after a problem.
std::string read_checked(const std::filesystem::path& path, Problems& problems) {
  const std::string name = path.string();
  std::error_code failure;
  if (std::filesystem::is_regular_file(path, failure)) {
    const std::uintmax_t bytes = std::filesystem::file_size(path, failure);
    if (!failure && bytes > max_bytes) {
      problems.add({name, fmt::format("{} bytes", bytes), fmt::format("at most {}", max_bytes),
                    "this cannot be the file that belongs here"});
      return {};
    }
  } else if (std::filesystem::is_other(path, failure)) {
    // A device or a pipe might never end.
    problems.add({name, "is no ordinary file", "", ""});
    return {};
  }
  try {
    std::string content = read_file(path);
    if (content.empty()) problems.add({name, "is empty", "", ""});
    const auto binary = std::ranges::find_if_not(content, is_text);
    if (binary == content.end()) return content;
    problems.add(
        {name, fmt::format("is not a text file (byte {})", binary - content.begin() + 1), "", ""});
  } catch (const DataError& error) {
    problems.add(error.problems());
  }
  return {};
}

}  // namespace

std::string excerpt(std::string_view text) {
  std::string shown(text.substr(0, max_excerpt));
  std::ranges::replace_if(
      shown, [](char letter) { return !is_printable(letter); }, '?');
  return fmt::format("'{}{}'", shown, text.size() > max_excerpt ? "..." : "");
}

TextFile::TextFile(const std::filesystem::path& path, Problems& problems)
    : name_(path.string()), content_(read_checked(path, problems)) {
  std::size_t begin = 0;
  while (begin < content_.size()) {
    const std::size_t end = std::min(content_.find('\n', begin), content_.size());
    std::size_t size = end - begin;
    if (size > 0 && content_[end - 1] == '\r') --size;
    lines_.push_back({begin, size});
    begin = end + 1;
  }
}

std::string_view TextFile::line(std::size_t i) const {
  return std::string_view(content_).substr(lines_[i].begin, lines_[i].size);
}

std::string TextFile::where(std::size_t line) const {
  return fmt::format("{}:{}", name_, line + 1);
}

std::string TextFile::where(std::size_t line, std::string_view piece) const {
  const auto offset = static_cast<std::size_t>(piece.data() - content_.data());
  return fmt::format("{}:{}:{}", name_, line + 1, offset - lines_[line].begin + 1);
}

}  // namespace facies
