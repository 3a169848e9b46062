// SPDX-License-Identifier: Apache-2.0
#include "facies/results/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/results/tables.hpp"

namespace facies::results {

namespace {

/// In quotes where it has to be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::string csv_number(const std::optional<double>& value) {
  return value ? exact_number(*value) : std::string();
}

bool is_same(const StudyColumn& a, const StudyColumn& b) {
  return a.expression == b.expression && a.quantity == b.quantity && a.subject == b.subject;
}

/// What a run has to say: published quantities that any run can measure, then everything else that it measured.
std::vector<StudyColumn> quantities_of(const StudyEntry& entry) {
  std::vector<StudyColumn> all;
  for (const PublishedValue& paper : entry.published) {
    const bool is_unknown = entry.converged && !measured_of(paper, entry.measured);
    const bool is_angle = paper.unit == "deg";  // rotations of tension are not measured
    if (is_unknown || is_angle) continue;
    all.push_back({entry.expression, paper.quantity, paper.subject, paper.unit, paper});
  }
  for (const MeasuredValue& m : entry.measured) {
    const StudyColumn column{entry.expression, m.quantity, m.subject, m.unit, {}};
    if (std::ranges::none_of(all, [&](const auto& known) { return is_same(known, column); }))
      all.push_back(column);
  }
  return all;
}

std::optional<double> value_of(const StudyColumn& column, const StudyEntry& entry) {
  PublishedValue wanted;
  wanted.quantity = column.quantity;
  wanted.subject = column.subject;
  return measured_of(wanted, entry.measured);
}

std::vector<StudyColumn> columns_of(std::span<const StudyEntry> entries) {
  std::vector<StudyColumn> all;
  for (const StudyEntry& entry : entries) {
    for (const StudyColumn& column : quantities_of(entry)) {
      if (std::ranges::none_of(all, [&](const auto& known) { return is_same(known, column); }))
        all.push_back(column);
    }
  }
  const auto is_published = [](const StudyColumn& column) { return column.paper.has_value(); };
  if (std::ranges::any_of(all, is_published))
    std::erase_if(all, [&](const StudyColumn& column) { return !is_published(column); });
  // Expressions stay together, in the order in which they come first.
  std::vector<StudyColumn> grouped;
  for (const StudyColumn& first : all) {
    if (std::ranges::any_of(grouped,
                            [&](const auto& g) { return g.expression == first.expression; }))
      continue;
    std::ranges::copy_if(all, std::back_inserter(grouped),
                         [&](const auto& c) { return c.expression == first.expression; });
  }
  return grouped;
}

/// The cells that a run fills.
void fill(StudyRow& row, const std::vector<StudyColumn>& columns, const StudyEntry& entry) {
  row.failed = row.failed || !entry.converged;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].expression == entry.expression)
      row.cells[c] = {value_of(columns[c], entry), !entry.converged};
  }
}

/// Beside the paper's values: how many there are, how many are met, how near they are in the mean.
void compare(StudyRow& row, const std::vector<StudyColumn>& columns) {
  double sum = 0.0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!columns[c].paper || !row.cells[c].value) continue;
    const double bands =
        std::abs(*row.cells[c].value - columns[c].paper->value) / band_of(*columns[c].paper);
    sum += bands;
    ++row.n_compared;
    if (bands <= 1.0) ++row.n_met;
  }
  if (row.n_compared > 0) row.score = sum / row.n_compared;
}

std::string subject_of(const StudyColumn& column) {
  return column.quantity == "largest_displacement" ? "largest" : column.subject;
}

std::string cell_text(const StudyCell& cell, const StudyColumn& column) {
  if (cell.failed) return "failed";
  if (!cell.value) return "-";
  return column.unit == "%" ? fmt::format("{:+.1f}", *cell.value)
                            : fmt::format("{:.2f}", *cell.value);
}

/// Rows as words: the paper's, where it says anything, then one for each variant; name, cells, how many are met, score.
std::vector<std::vector<std::string>> words_of(const StudyTable& table) {
  std::vector<std::vector<std::string>> rows;
  if (std::ranges::any_of(table.columns, [](const auto& column) { return !!column.paper; })) {
    rows.emplace_back(1, "paper");
    for (const StudyColumn& column : table.columns)
      rows[0].push_back(column.paper ? column.paper->text() : "-");
    rows[0].insert(rows[0].end(), {"", ""});
  }
  for (const StudyRow& row : table.rows) {
    std::vector<std::string>& words = rows.emplace_back(1, row.variant);
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      words.push_back(cell_text(row.cells[c], table.columns[c]));
    words.push_back(row.score ? fmt::format("{}/{}", row.n_met, row.n_compared) : "-");
    words.push_back(row.score ? fmt::format("{:.2f}", *row.score) : "-");
  }
  return rows;
}

/// The line above the titles: each expression where its columns begin, over which it may reach. Widens those that are
/// alone.
std::string expressions_line(const std::vector<StudyColumn>& columns,
                             std::vector<std::size_t>& width) {
  std::string line;
  std::size_t begin = width[0] + 2;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::string& name = columns[c].expression;
    if (c == 0 || columns[c - 1].expression != name) {
      const bool is_alone = c + 1 == columns.size() || columns[c + 1].expression != name;
      if (is_alone) width[c + 1] = std::max(width[c + 1], name.size());
      line.resize(std::max(line.size(), begin), ' ');
      line += name;
    }
    begin += width[c + 1] + 2;
  }
  return line + '\n';
}

constexpr const char* met_title = "met";
constexpr const char* score_title = "score";

constexpr const char* how_to_read =
    "Displacements and distances are measured from the tensioned rest. A number is met that is at "
    "most a band from the\n"
    "paper's: 15 % of a length, 4 percentage points of a change. The score is the mean of "
    "|difference| / band. Variants\n"
    "that meet most stand first, then those that are compared with fewer numbers than others, last "
    "those with a run that\n"
    "failed; that run does not count.\n";

std::string markdown_table(const StudyTable& table) {
  std::string text = "| variant |";
  std::string rule = "|---|";
  for (const StudyColumn& column : table.columns) {
    text += fmt::format(" {}<br>{} [{}] |", column.expression, subject_of(column), column.unit);
    rule += "---:|";
  }
  text += fmt::format(" {} | {} |\n{}---:|---:|\n", met_title, score_title, rule);
  for (const auto& row : words_of(table)) {
    text += '|';
    for (const std::string& word : row)
      text += ' ' + word + " |";
    text += '\n';
  }
  return text;
}

}  // namespace

double band_of(const PublishedValue& published) {
  require(published.unit == "mm" || published.unit == "%", "bands are known for mm and %");
  return published.unit == "%" ? 4.0 : 0.15 * std::abs(published.value);
}

std::string study_csv(std::span<const StudyEntry> entries) {
  std::string text = "variant,scenario,quantity,unit,value,paper,difference\n";
  for (const StudyEntry& entry : entries) {
    const std::vector<StudyColumn> quantities = quantities_of(entry);
    if (quantities.empty())
      text += fmt::format("{},{},,,,,\n", csv_field(entry.variant), csv_field(entry.scenario));
    for (const StudyColumn& column : quantities) {
      const std::optional<double> value = value_of(column, entry);
      std::optional<double> paper;
      std::optional<double> difference;
      if (column.paper) paper = column.paper->value;
      if (value && paper) difference = *value - *paper;
      text +=
          fmt::format("{},{},{},{},{},{},{}\n", csv_field(entry.variant), csv_field(entry.scenario),
                      csv_field(column.quantity + ' ' + column.subject), column.unit,
                      csv_number(value), csv_number(paper), csv_number(difference));
    }
  }
  return text;
}

StudyTable make_study_table(std::span<const StudyEntry> entries) {
  StudyTable table{columns_of(entries), {}};
  for (const StudyEntry& entry : entries) {
    auto row = std::ranges::find(table.rows, entry.variant, &StudyRow::variant);
    if (row == table.rows.end()) {
      table.rows.push_back(
          {.variant = entry.variant, .cells = std::vector<StudyCell>(table.columns.size())});
      row = std::prev(table.rows.end());
    }
    fill(*row, table.columns, entry);
  }
  int most = 0;
  for (StudyRow& row : table.rows) {
    compare(row, table.columns);
    most = std::max(most, row.n_compared);
  }
  std::ranges::stable_sort(table.rows, {}, [most](const StudyRow& row) {
    return std::tuple(row.failed, !row.score, row.n_compared < most, -row.n_met,
                      row.score.value_or(0.0));
  });
  return table;
}

std::string study_text(const StudyTable& table) {
  std::vector<std::vector<std::string>> rows = words_of(table);
  std::vector<std::string> subjects(1, "");
  std::vector<std::string> units(1, "variant");
  for (const StudyColumn& column : table.columns) {
    subjects.push_back(subject_of(column));
    units.push_back(fmt::format("[{}]", column.unit));
  }
  units.insert(units.end(), {met_title, score_title});
  rows.insert(rows.begin(), {std::move(subjects), std::move(units)});
  std::vector<std::size_t> width(table.columns.size() + 3, 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      width[c] = std::max(width[c], row[c].size());
  }
  std::string text = expressions_line(table.columns, width);
  for (const auto& row : rows) {
    std::string line = fmt::format("{:<{}}", row[0], width[0]);
    for (std::size_t c = 1; c < row.size(); ++c)
      line += fmt::format("  {:>{}}", row[c], width[c]);
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string study_page(const std::string& title, std::span<const StudyVariant> variants,
                       std::span<const StudyEntry> entries) {
  std::string text =
      fmt::format("# {}\n\n{}\n{}", title, markdown_table(make_study_table(entries)), how_to_read);
  std::string failures;
  for (const StudyEntry& entry : entries) {
    if (entry.converged) continue;
    failures += fmt::format("- `{}/{}`: {}\n", entry.variant, entry.scenario, entry.reason);
  }
  if (!failures.empty()) text += "\n## Not converged\n\n" + failures;
  text += "\n## Variants\n\n";
  for (const StudyVariant& variant : variants)
    text +=
        fmt::format("- `{}`{}{}\n", variant.name, variant.about.empty() ? "" : ": ", variant.about);
  return text;
}

}  // namespace facies::results
