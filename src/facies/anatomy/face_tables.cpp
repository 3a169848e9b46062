// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/face_tables.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

std::size_t count_of(const Table& table, std::size_t row, Problems& problems) {
  const long count = table.integer(row, "count", problems).value_or(1);
  if (count >= 1) return static_cast<std::size_t>(count);
  problems.add({table.where(row, "count"), fmt::format("{}", count), "at least 1", ""});
  return 1;
}

void check_known(const Table& table, std::size_t row, const std::string& column,
                 const std::vector<std::string>& known, Problems& problems) {
  const std::string_view name = table.text(row, column);
  if (known.empty() || std::ranges::find(known, name) != known.end()) return;
  problems.add({table.where(row, column), excerpt(name), "a name of the other table",
                did_you_mean(name, known)});
}

std::vector<SetFile> read_sets(const fs::path& folder, Problems& problems) {
  const Table table(folder / "default-sets.csv",
                    {"set", "file", "form", "first_number", "count", "source"}, problems);
  std::vector<SetFile> sets;
  std::vector<std::string> names;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    SetFile set;
    set.set = table.new_name(row, "set", names, problems);
    set.path = std::string(table.text(row, "file"));
    set.count = count_of(table, row, problems);
    set.first_number = table.integer(row, "first_number", problems).value_or(1);
    const std::string_view form = table.text(row, "form");
    if (form != "list" && form != "first-column") {
      problems.add({table.where(row, "form"), excerpt(form), "'list' or 'first-column'", ""});
    }
    set.form = form == "first-column" ? ListForm::first_column : ListForm::list;
    sets.push_back(std::move(set));
  }
  for (const char* layer : {"outer", "between", "inner"}) {
    if (!names.empty() && std::ranges::find(names, layer) == names.end()) {
      problems.add({(folder / "default-sets.csv").string(), fmt::format("no set '{}'", layer),
                    "the sets outer, between and inner, which together hold all nodes", ""});
    }
  }
  return sets;
}

std::vector<MuscleRow> read_muscles(const fs::path& folder, std::vector<std::string>& names,
                                    Problems& problems) {
  const Table table(folder / "muscles.csv", {"name", "meaning", "source"}, problems);
  std::vector<MuscleRow> muscles;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    muscles.push_back(
        {table.new_name(row, "name", names, problems), std::string(table.text(row, "meaning"))});
  }
  return muscles;
}

FibreRow read_fibre(const Table& table, std::size_t row, Problems& problems) {
  FibreRow fibre;
  fibre.muscle = table.text(row, "muscle");
  fibre.where = table.where(row, "points");
  fibre.count = count_of(table, row, problems);
  const std::string_view kind = table.text(row, "kind");
  if (kind == "ring") {
    fibre.ring = std::string(table.text(row, "points"));
    return fibre;
  }
  if (kind != "left") {
    problems.add({table.where(row, "kind"), excerpt(kind), "'left' or 'ring'", ""});
    return fibre;
  }
  for (const std::string_view field : split_blanks(table.text(row, "points"))) {
    const std::optional<long> number = parse_integer(field);
    if (!number) problems.add({fibre.where, excerpt(field), "numbers between blanks", ""});
    fibre.points.push_back({number.value_or(0), fibre.where});
  }
  if (fibre.points.size() < 2 || fibre.points.size() != fibre.count) {
    problems.add({fibre.where, fmt::format("{} points", fibre.points.size()),
                  fmt::format("{} as in 'count', at least 2", fibre.count), ""});
  }
  return fibre;
}

std::vector<FibreRow> read_fibres(const fs::path& folder, const std::vector<std::string>& muscles,
                                  Problems& problems) {
  const fs::path path = folder / "muscle-fibres.csv";
  const Table table(path, {"muscle", "fibre", "kind", "count", "points", "source"}, problems);
  std::vector<FibreRow> fibres;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    check_known(table, row, "muscle", muscles, problems);
    fibres.push_back(read_fibre(table, row, problems));
  }
  for (const std::string& muscle : muscles) {
    if (table.n_rows() == 0 ||
        std::ranges::find(fibres, muscle, &FibreRow::muscle) != fibres.end()) {
      continue;
    }
    problems.add({path.string(), fmt::format("no fibre of muscle '{}'", muscle),
                  "at least one for each row of muscles.csv", ""});
  }
  return fibres;
}

std::vector<LandmarkRow> read_landmarks(const fs::path& folder, std::vector<std::string>& names,
                                        Problems& problems) {
  const Table table(folder / "landmarks.csv",
                    {"name", "node_number", "meaning", "in_paper", "source"}, problems);
  std::vector<LandmarkRow> landmarks;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    LandmarkRow landmark;
    landmark.name = table.new_name(row, "name", names, problems);
    landmark.meaning = table.text(row, "meaning");
    landmark.node.value = table.integer(row, "node_number", problems).value_or(0);
    landmark.node.where = table.where(row, "node_number");
    landmark.in_paper = table.flag(row, "in_paper", problems);
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

std::vector<LandmarkPair> read_pairs(const fs::path& folder,
                                     const std::vector<std::string>& landmarks,
                                     Problems& problems) {
  const Table table(folder / "pairs.csv", {"a", "b", "meaning", "in_paper", "source"}, problems);
  std::vector<LandmarkPair> pairs;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    check_known(table, row, "a", landmarks, problems);
    check_known(table, row, "b", landmarks, problems);
    pairs.push_back({std::string(table.text(row, "a")), std::string(table.text(row, "b"))});
  }
  return pairs;
}

}  // namespace

FaceTables read_face_tables(const fs::path& folder, Problems& problems) {
  FaceTables tables;
  for (const char* file :
       {"default-sets.csv", "muscles.csv", "muscle-fibres.csv", "landmarks.csv", "pairs.csv"})
    tables.files.push_back(folder / file);
  tables.sets = read_sets(folder, problems);
  std::vector<std::string> muscles;
  tables.muscles = read_muscles(folder, muscles, problems);
  tables.fibres = read_fibres(folder, muscles, problems);
  std::vector<std::string> landmarks;
  tables.landmarks = read_landmarks(folder, landmarks, problems);
  tables.pairs = read_pairs(folder, landmarks, problems);
  return tables;
}

}  // namespace facies::anatomy
