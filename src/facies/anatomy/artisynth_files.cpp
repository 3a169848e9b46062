// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/artisynth_files.hpp"

#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

constexpr double mm_per_metre = 1000.0;
/// The directions come with five decimals.
constexpr double unit_tolerance = 1e-3;

/// A file that is read line by line; a line with a problem is left out, blank lines are passed over.
class LineReader {
 public:
  LineReader(const std::filesystem::path& path, Problems& problems)
      : problems_(problems),
        before_(problems.size()),
        file_(path, problems),
        bad_(path.string(), "unusable lines or numbers") {}

  /// Calls read(line number, line) for each line that is not blank.
  template <class Read>
  void for_each_line(Read read) {
    for (std::size_t i = 0; i < file_.n_lines(); ++i) {
      if (!trim(file_.line(i)).empty()) read(i, file_.line(i));
    }
  }

  /// The blank-separated fields if there are `n` of them.
  std::optional<std::vector<std::string_view>> fields(std::size_t line, std::size_t n,
                                                      const char* expected) {
    std::vector<std::string_view> found = split_blanks(file_.line(line));
    if (found.size() == n) return found;
    bad_.add({file_.where(line), fmt::format("{} columns", found.size()),
              fmt::format("{} columns: {}", n, expected), ""});
    return std::nullopt;
  }

  std::optional<long> integer(std::size_t line, std::string_view field) {
    const std::optional<long> value = parse_integer(field);
    if (!value) bad_.add({file_.where(line, field), excerpt(field), "a whole number", ""});
    return value;
  }

  std::optional<double> number(std::size_t line, std::string_view field) {
    const std::optional<double> value = parse_number(field);
    if (!value) bad_.add({file_.where(line, field), excerpt(field), "a finite number", ""});
    return value;
  }

  /// True the first time that `number` comes.
  bool is_new(std::size_t line, std::string_view field, long number) {
    const auto [seen, inserted] = line_of_.try_emplace(number, line);
    if (inserted) return true;
    bad_.add({file_.where(line, field),
              fmt::format("{} a second time, first on line {}", number, seen->second + 1),
              "each number once", ""});
    return false;
  }

  void refuse(Problem problem) { bad_.add(std::move(problem)); }

  [[nodiscard]] const TextFile& file() const { return file_; }

  /// `rows`, or nothing if the file had a problem or no row.
  template <class Row>
  std::vector<Row> finish(std::vector<Row> rows) {
    bad_.move_to(problems_);
    if (problems_.size() == before_ && rows.empty())
      problems_.add({file_.name(), "is blank", "", ""});
    if (problems_.size() != before_) rows.clear();
    return rows;
  }

 private:
  Problems& problems_;
  std::size_t before_;
  TextFile file_;
  ProblemsOfOneKind bad_;
  std::map<long, std::size_t> line_of_;
};

/// The digits at the beginning of a line of fixed columns, if a blank, a sign or the end follows them.
std::string_view leading_digits(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  const std::size_t end = line.find_first_not_of("0123456789", begin);
  if (end != std::string_view::npos &&
      std::string_view(" \t-+").find(line[end]) == std::string_view::npos) {
    return {};
  }
  return line.substr(begin, end == std::string_view::npos ? end : end - begin);
}

}  // namespace

std::vector<PointRow> read_points(const std::filesystem::path& path, Problems& problems) {
  LineReader reader(path, problems);
  std::vector<PointRow> rows;
  reader.for_each_line([&](std::size_t line, std::string_view) {
    const auto fields = reader.fields(line, 4, "number x y z");
    if (!fields) return;
    PointRow row;
    row.where = reader.file().where(line);
    const std::optional<long> number = reader.integer(line, (*fields)[0]);
    bool is_complete = number && reader.is_new(line, (*fields)[0], *number);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> x = reader.number(line, (*fields)[i + 1]);
      is_complete = is_complete && x;
      row.X(Eigen::Index(i)) = mm_per_metre * x.value_or(0.0);
    }
    if (!is_complete) return;
    row.number = *number;
    rows.push_back(std::move(row));
  });
  return reader.finish(std::move(rows));
}

std::vector<ElementRow> read_elements(const std::filesystem::path& path, Problems& problems) {
  LineReader reader(path, problems);
  std::vector<ElementRow> rows;
  reader.for_each_line([&](std::size_t line, std::string_view) {
    const auto fields =
        reader.fields(line, 14, "eight nodes, five attributes, the element's number");
    if (!fields) return;
    ElementRow row;
    row.where = reader.file().where(line);
    bool is_complete = true;
    for (std::size_t i = 0; i < 8; ++i) {
      const std::optional<long> node = reader.integer(line, (*fields)[i]);
      is_complete = is_complete && node;
      row.nodes[i] = node.value_or(0);
    }
    const std::optional<long> number = reader.integer(line, (*fields)[13]);
    if (!number || !reader.is_new(line, (*fields)[13], *number) || !is_complete) return;
    row.number = *number;
    rows.push_back(std::move(row));
  });
  return reader.finish(std::move(rows));
}

std::vector<Vec3> read_directions(const std::filesystem::path& path, Problems& problems) {
  LineReader reader(path, problems);
  std::vector<Vec3> directions;
  reader.for_each_line([&](std::size_t line, std::string_view) {
    const auto fields = reader.fields(line, 9, "a 3x3 matrix, row by row");
    if (!fields) return;
    Vec3 a1 = Vec3::Zero();
    bool is_complete = true;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::optional<double> value = reader.number(line, (*fields)[i]);
      is_complete = is_complete && value;
      if (i % 3 == 0) a1(Eigen::Index(i / 3)) = value.value_or(0.0);
    }
    if (!is_complete) return;
    if (std::abs(a1.norm() - 1.0) > unit_tolerance) {
      reader.refuse({reader.file().where(line),
                     fmt::format("a first column of length {:.6g}", a1.norm()),
                     "a unit vector in columns 1, 4 and 7", ""});
      return;
    }
    directions.emplace_back(a1.normalized());
  });
  return reader.finish(std::move(directions));
}

std::vector<NumberAt> read_numbers(const std::filesystem::path& path, ListForm form,
                                   Problems& problems) {
  LineReader reader(path, problems);
  std::vector<NumberAt> numbers;
  const auto add = [&](std::size_t line, std::string_view field) {
    const std::optional<long> value = reader.integer(line, field);
    if (!value || !reader.is_new(line, field, *value)) return;
    numbers.push_back({*value, reader.file().where(line, field)});
  };
  reader.for_each_line([&](std::size_t line, std::string_view text) {
    if (form == ListForm::list) {
      for (const std::string_view field : split_blanks(text))
        add(line, field);
      return;
    }
    const std::string_view digits = leading_digits(text);
    add(line, digits.empty() ? split_blanks(text).front() : digits);
  });
  return reader.finish(std::move(numbers));
}

}  // namespace facies::anatomy
