// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/document.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include <fmt/format.h>

#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

constexpr std::size_t max_bytes = 1 << 20;  // such files are a page long

bool looks_like_text(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char letter) {
    return letter < 0x20 && letter != '\n' && letter != '\r' && letter != '\t';
  });
}

/// File, line and column of "x.yaml:12:7" or "c.csv:12", after whether there are none: those places come last.
using Position = std::tuple<bool, std::string_view, long, long>;

Position position_of(const Problem& problem) {
  std::string_view rest = problem.where;
  std::array<std::optional<long>, 2> numbers;  // from the end
  for (std::optional<long>& number : numbers) {
    const std::size_t colon = rest.rfind(':');
    if (colon == std::string_view::npos) break;
    number = parse_integer(rest.substr(colon + 1));
    if (!number) break;
    rest = rest.substr(0, colon);
  }
  if (!numbers[0]) return {true, {}, 0, 0};
  if (!numbers[1]) return {false, rest, *numbers[0], 0};
  return {false, rest, *numbers[1], *numbers[0]};
}

}  // namespace

std::optional<std::string> read_document(const std::filesystem::path& path,
                                         const DocumentKind& kind, Problems& problems) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (std::filesystem::is_other(status)) {  // a device or pipe may never end
    problems.add({path.string(), "is neither a file nor a folder", kind.name + " file", ""});
    return std::nullopt;
  }
  const auto size = std::filesystem::file_size(path, failure);
  if (!failure && size > max_bytes) {
    problems.add(
        {path.string(), fmt::format("has {} bytes", size), kind.name + " of at most 1 MB", ""});
    return std::nullopt;
  }
  try {
    return read_file(path);
  } catch (
      const DataError& error) {  // a scenario that cannot be opened is a bad scenario, not bad data
    problems.add(error.problems());
    return std::nullopt;
  }
}

std::optional<YamlNode> parse_document(const std::string& text, const std::string& source,
                                       const DocumentKind& kind, Problems& problems) {
  if (!looks_like_text(text)) {
    problems.add({source, "is not a text file", kind.name + " in YAML", ""});
    return std::nullopt;
  }
  Problems wrong;
  YamlNode root = parse_yaml(text, {source}, wrong);
  if (root.kind == YamlNode::Kind::nothing) {
    if (wrong.empty())
      wrong.add(
          {source, "is empty", fmt::format("{} with {}", kind.name, kind.main_key), kind.hint});
  } else if (expect_mapping(
                 root, fmt::format("{}: a mapping of keys such as '{}'", kind.name, kind.main_key),
                 wrong)) {
    problems.add(wrong.list());
    return root;
  }
  problems.add(wrong.list());
  return std::nullopt;
}

std::vector<Problem> in_order(std::vector<Problem> problems) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return position_of(a) < position_of(b);
  });
  return problems;
}

}  // namespace facies::scenario
