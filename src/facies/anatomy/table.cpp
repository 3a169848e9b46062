// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

bool is_comment(std::string_view line) {
  return trim(line).starts_with('#');
}

}  // namespace

Table::Table(const std::filesystem::path& path, const std::vector<std::string>& columns,
             Problems& problems)
    : file_(path, problems) {
  if (!file_.is_usable()) return;
  const std::size_t before = problems.size();
  std::size_t header = 0;
  while (header + 1 < file_.n_lines() && is_comment(file_.line(header)))
    ++header;
  for (const std::string_view field : split(file_.line(header), ','))
    header_.emplace_back(field);
  for (const std::string& column : columns) {
    if (std::ranges::find(header_, column) == header_.end()) {
      problems.add({file_.where(header), fmt::format("no column '{}'", column), "",
                    did_you_mean(column, header_)});
    }
  }
  for (std::size_t line = header + 1; line < file_.n_lines(); ++line)
    add_row(line, problems);
  if (problems.size() != before) rows_.clear();
}

void Table::add_row(std::size_t line, Problems& problems) {
  if (trim(file_.line(line)).empty() || is_comment(file_.line(line))) return;
  const std::size_t n = split(file_.line(line), ',').size();
  if (n == header_.size()) {
    rows_.push_back(line);
    return;
  }
  problems.add({file_.where(line), fmt::format("{} fields", n),
                fmt::format("{} as in the header", header_.size()),
                "fields are separated by commas and contain none"});
}

std::string_view Table::text(std::size_t row, const std::string& column) const {
  const auto found = std::ranges::find(header_, column);
  require(found != header_.end(), "a table is asked for a column that it does not have");
  return split(file_.line(rows_.at(row)), ',')[std::size_t(found - header_.begin())];
}

std::optional<long> Table::integer(std::size_t row, const std::string& column,
                                   Problems& problems) const {
  const std::optional<long> value = parse_integer(text(row, column));
  if (!value) {
    problems.add({where(row, column), excerpt(text(row, column)), "a whole number", ""});
  }
  return value;
}

std::optional<double> Table::number(std::size_t row, const std::string& column,
                                    Problems& problems) const {
  const std::optional<double> value = parse_number(text(row, column));
  if (!value) problems.add({where(row, column), excerpt(text(row, column)), "a number", ""});
  return value;
}

bool Table::flag(std::size_t row, const std::string& column, Problems& problems) const {
  const std::string_view field = text(row, column);
  if (field != "0" && field != "1")
    problems.add({where(row, column), excerpt(field), "0 or 1", ""});
  return field == "1";
}

std::string Table::new_name(std::size_t row, const std::string& column,
                            std::vector<std::string>& names, Problems& problems) const {
  std::string name(text(row, column));
  if (name.empty() || std::ranges::find(names, name) != names.end()) {
    problems.add({where(row, column), excerpt(name), "a name that no other row has", ""});
  }
  names.push_back(name);
  return name;
}

std::string Table::known_name(std::size_t row, const std::string& column,
                              const std::vector<std::string>& known, const std::string& expected,
                              Problems& problems) const {
  std::string name(text(row, column));
  if (!known.empty() && std::ranges::find(known, name) == known.end())
    problems.add({where(row, column), excerpt(name), expected, did_you_mean(name, known)});
  return name;
}

std::string Table::where(std::size_t row, const std::string& column) const {
  const std::string_view field = text(row, column);
  // An empty field stands nowhere in particular.
  return field.empty() ? file_.where(rows_.at(row)) : file_.where(rows_.at(row), field);
}

}  // namespace facies::anatomy
