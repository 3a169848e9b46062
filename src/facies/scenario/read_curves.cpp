// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/read_curves.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/base/text_file.hpp"
#include "facies/scenario/value.hpp"

namespace facies::scenario {

namespace {

constexpr const char* time_title = "time_s";

/// Times have to grow, from 0 to the end of the step. `written` is the time as the file has it.
void check_time(double time, const std::string& written, const std::string& where,
                const std::vector<CurvePoint>& before, double duration, Problems& problems) {
  if (time < 0.0 || (duration > 0.0 && time > duration)) {
    problems.add({where, fmt::format("the time {} lies outside the step", written),
                  duration > 0.0 ? fmt::format("0 s to {:g} s", duration) : "0 s or later", ""});
  }
  if (before.empty() || time > before.back().time) return;
  const bool equal = time == before.back().time;
  problems.add({where,
                fmt::format("the time {} {} the one before it", written,
                            equal ? "is the same as" : "is earlier than"),
                "times that grow",
                equal ? "a jump needs two different times, however near each other"
                      : "sort the points by their times"});
}

std::optional<CurvePoint> read_point(const YamlNode& node, Problems& problems) {
  if (node.kind != YamlNode::Kind::sequence || node.items.size() != 2) {
    problems.add({node.where, describe(node), "a point such as [0.2 s, 0.5]", ""});
    return std::nullopt;
  }
  static const Rule time_rule = {.doc = "", .unit = "s"};
  const std::optional<double> time = read_number(node.items[0], time_rule, problems);
  const std::optional<double> value = read_number(node.items[1], activation_rule(), problems);
  if (!time || !value) return std::nullopt;
  return CurvePoint{*time, *value};
}

/// A table while it is read.
struct TableReader {
  const TextFile& file;
  double duration;
  Problems& problems;
  std::vector<NamedCurve> curves = {};
  std::vector<CurvePoint> rows = {};  // the times, whatever the columns say

  void read_titles(std::size_t line) {
    const std::vector<std::string_view> titles = split(file.line(line), ',');
    if (titles.front() != time_title) {
      problems.add({file.where(line, titles.front()),
                    fmt::format("the first column is {}", excerpt(titles.front())), time_title,
                    "times in seconds, then one column for each muscle"});
    }
    if (titles.size() == 1) problems.add({file.where(line), "no column beside the times", "", ""});
    for (std::size_t k = 1; k < titles.size(); ++k) {
      const std::string name(titles[k]);
      const std::string where = file.where(line, titles[k]);
      const auto same = [&](const NamedCurve& other) { return other.name == name; };
      if (name.empty()) problems.add({where, "a column without a name", "a muscle", ""});
      if (std::any_of(curves.begin(), curves.end(), same))
        problems.add({where, fmt::format("a second column '{}'", name), "one", ""});
      curves.push_back({name, where, {}});
    }
  }

  void read_row(std::size_t line) {
    const std::vector<std::string_view> cells = split(file.line(line), ',');
    if (cells.size() != curves.size() + 1) {
      problems.add({file.where(line), fmt::format("{} cells", cells.size()),
                    fmt::format("{}, one below each title", curves.size() + 1), ""});
      return;
    }
    const std::optional<double> time = number(line, cells[0]);
    if (time) {
      check_time(*time, fmt::format("{} s", cells[0]), file.where(line, cells[0]), rows, duration,
                 problems);
      rows.push_back({*time, 0.0});
    }
    for (std::size_t k = 1; k < cells.size(); ++k) {
      const std::optional<double> value = number(line, cells[k]);
      if (value && !(*value >= 0.0 && *value <= 1.0)) {
        problems.add({file.where(line, cells[k]), fmt::format("{} is out of range", cells[k]),
                      range_in_words(activation_rule()), ""});
      }
      if (time && value) curves[k - 1].curve.points.push_back({*time, *value});
    }
  }

  [[nodiscard]] std::optional<double> number(std::size_t line, std::string_view cell) const {
    const std::optional<double> value = parse_number(cell);
    if (!value) {
      problems.add(
          {file.where(line, cell),
           cell.empty() ? "an empty cell" : fmt::format("{} is not a number", excerpt(cell)),
           "a number without a unit", ""});
    }
    return value;
  }
};

bool counts(std::string_view line) {
  const std::string_view text = trim(line);
  return !text.empty() && text.front() != '#';
}

}  // namespace

std::optional<Curve> read_curve(const YamlNode& node, double duration, Problems& problems) {
  Problems here;
  Curve curve;
  if (node.kind == YamlNode::Kind::scalar) {
    if (const auto value = read_number(node, activation_rule(), here))
      curve.points.push_back({0.0, *value});
  } else if (node.kind != YamlNode::Kind::sequence || node.items.empty()) {
    here.add({node.where, node.kind == YamlNode::Kind::sequence ? "no points" : describe(node),
              "a number, or points such as [[0 s, 0], [0.2 s, 0.5]]", ""});
  }
  for (const YamlNode& item : node.items) {
    const std::optional<CurvePoint> point = read_point(item, here);
    if (!point) continue;
    check_time(point->time, item.items[0].text, item.items[0].where, curve.points, duration, here);
    curve.points.push_back(*point);
  }
  for (const Problem& problem : here.list())
    problems.add(problem);
  if (!here.empty()) return std::nullopt;
  return curve;
}

std::vector<NamedCurve> read_curve_table(const std::filesystem::path& path, double duration,
                                         Problems& problems) {
  Problems here;
  const TextFile file(path, here);
  TableReader reader{file, duration, here};
  bool titled = false;
  for (std::size_t line = 0; file.is_usable() && line < file.n_lines(); ++line) {
    if (!counts(file.line(line))) continue;
    if (titled) {
      reader.read_row(line);
    } else {
      reader.read_titles(line);
    }
    titled = true;
  }
  if (file.is_usable() && here.empty() && reader.rows.empty())
    here.add({path.string(), "no rows", "titles, then a row for each time", ""});
  for (const Problem& problem : here.list())
    problems.add(problem);
  if (!here.empty()) return {};
  return std::move(reader.curves);
}

}  // namespace facies::scenario
