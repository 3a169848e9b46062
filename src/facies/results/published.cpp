// SPDX-License-Identifier: Apache-2.0
#include "facies/results/published.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/base/text.hpp"

namespace facies::results {

namespace {

constexpr std::string_view header =
    "expression,quantity,subject,value,unit,comparison,place,sentence";
constexpr std::size_t n_columns = 8;

const std::vector<std::string>& known_quantities() {
  static const std::vector<std::string> names{"displacement",          "largest_displacement",
                                              "distance_change",       "incisor_distance",
                                              "mean_tension_rotation", "largest_tension_rotation"};
  return names;
}

const std::vector<std::string>& known_comparisons() {
  static const std::vector<std::string> names{"stated", "about", "almost", "up to"};
  return names;
}

/// Fields of a line; a field in quotes may hold commas, and two quotes for one.
std::vector<std::string> split_csv(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

void check_word(const std::string& word, const std::vector<std::string>& known,
                const std::string& where, const char* what, Problems& problems) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  problems.add({where, fmt::format("unknown {} '{}'", what, word), "", did_you_mean(word, known)});
}

PublishedValue read_row(std::string_view line, const std::string& where, Problems& problems) {
  const std::vector<std::string> fields = split_csv(line);
  if (fields.size() != n_columns) {
    problems.add({where, fmt::format("{} columns", fields.size()), std::string(header), ""});
    return {};
  }
  const std::optional<double> value = parse_number(fields[3]);
  if (!value) problems.add({where, fmt::format("'{}'", fields[3]), "a number as value", ""});
  check_word(fields[1], known_quantities(), where, "quantity", problems);
  check_word(fields[5], known_comparisons(), where, "comparison", problems);
  return {fields[0], fields[1], fields[2], value.value_or(0.0),
          fields[4], fields[5], fields[6], fields[7]};
}

}  // namespace

std::string PublishedValue::text() const {
  const std::string number = fmt::format("{:g}", value);
  return comparison == "stated" ? number : comparison + ' ' + number;
}

std::vector<PublishedValue> read_published(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  std::vector<PublishedValue> values;
  Problems problems;
  bool has_header = false;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    const std::string_view line = trim(std::string_view(content).substr(begin, end - begin));
    begin = end + 1;
    const std::string where = fmt::format("{}:{}", path.string(), ++number);
    if (line.empty() || line.front() == '#') continue;
    if (!has_header) {
      if (line != header) problems.add({where, fmt::format("'{}'", line), std::string(header), ""});
      has_header = true;
    } else {
      values.push_back(read_row(line, where, problems));
    }
  }
  if (!has_header) problems.add({path.string(), "holds no table", std::string(header), ""});
  problems.throw_if_any<DataError>();
  return values;
}

std::vector<PublishedValue> about_expression(const std::vector<PublishedValue>& values,
                                             const std::string& expression) {
  std::vector<PublishedValue> chosen;
  std::copy_if(values.begin(), values.end(), std::back_inserter(chosen),
               [&](const PublishedValue& value) { return value.expression == expression; });
  return chosen;
}

}  // namespace facies::results
