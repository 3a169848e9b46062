// SPDX-License-Identifier: Apache-2.0
// The tables under data/reference-face, and what is told about wrong ones.
#include <gmock/gmock.h>

#include "anatomy/reference_face.hpp"
#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/face_tables.hpp"
#include "facies/anatomy/table.hpp"

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(FaceTables, AreReadWithoutProblems) {
  Problems problems;
  const FaceTables tables = read_face_tables(data_folder() / "reference-face", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(tables.muscles.size(), 10U);
  EXPECT_EQ(tables.fibres.size(), 16U);
  EXPECT_EQ(tables.sets.size(), 14U);
}

TEST(FaceTables, NameTheLandmarksOfFigure4) {
  Problems problems;
  const FaceTables tables = read_face_tables(data_folder() / "reference-face", problems);
  std::vector<std::string> in_paper;
  for (const LandmarkRow& row : tables.landmarks) {
    if (row.in_paper) in_paper.push_back(row.name);
    EXPECT_FALSE(row.meaning.empty()) << row.name;
  }
  EXPECT_THAT(in_paper, testing::ElementsAre("RC", "ROR", "RAN", "SN", "RMU", "PH", "RMC", "LMC",
                                             "RML", "SL", "PG"));
}

TEST(FaceTables, GiveASourceInEveryRow) {
  std::size_t n_tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "reference-face")) {
    if (entry.path().extension() != ".csv") continue;
    Problems problems;
    const Table table(entry.path(), {"source"}, problems);
    EXPECT_TRUE(problems.empty()) << entry.path();
    EXPECT_GT(table.n_rows(), 0U) << entry.path();
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      EXPECT_FALSE(table.text(row, "source").empty()) << table.where(row, "source");
    ++n_tables;
  }
  EXPECT_EQ(n_tables, 14U);
}

TEST(FaceTables, HaveJawMusclesWhoseLengthIsTheDistanceOfTheirEnds) {
  Problems problems;
  const std::filesystem::path path = data_folder() / "reference-face" / "jaw-muscles.csv";
  const Table table(path, {"name", "initial_length_mm"}, problems);
  ASSERT_EQ(table.n_rows(), 28U);
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    const auto point = [&](const std::string& end) {
      Vec3 p = Vec3::Zero();
      for (const auto& [axis, i] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}})
        p(i) = parse_number(table.text(row, fmt::format("{}_{}_mm", end, axis))).value();
      return p;
    };
    const double length = parse_number(table.text(row, "initial_length_mm")).value();
    EXPECT_NEAR((point("origin") - point("insertion")).norm(), length, 2e-3)
        << table.text(row, "name");
  }
}

/// What is told after `old` became `with` in a table of the synthetic face.
std::string told_after(const std::string& table, const std::string& old, const std::string& with) {
  const SyntheticFace files;
  SyntheticFace::replace_all(files.tables() / table, old, with);
  return files.message();
}

TEST(FaceTables, WithAMissingColumnNameIt) {
  EXPECT_THAT(told_after("landmarks.csv", "node_number", "node_numbr"),
              AllOf(HasSubstr("landmarks.csv:1: no column 'node_number'"),
                    HasSubstr("did you mean 'node_numbr'?")));
}

TEST(FaceTables, WithACommaTooMuchNameTheLine) {
  EXPECT_THAT(told_after("muscles.csv", "zygomaticus", "zygomaticus, major"),
              HasSubstr("muscles.csv:2: 4 fields; expected 3"));
}

TEST(FaceTables, WithUnknownNamesSuggestTheNearest) {
  EXPECT_THAT(told_after("muscle-fibres.csv", "ZYG,", "ZYX,"),
              AllOf(HasSubstr("'ZYX'"), HasSubstr("did you mean 'ZYG'?")));
  EXPECT_THAT(told_after("pairs.csv", "A,B,", "A,C,"), HasSubstr("pairs.csv:2:3: 'C'"));
}

TEST(FaceTables, WithImpossibleEntriesSayWhatIsPossible) {
  EXPECT_THAT(told_after("default-sets.csv", ",list,", ",tree,"), HasSubstr("'list' or"));
  EXPECT_THAT(told_after("default-sets.csv", ",64,", ",-4,"), HasSubstr("at least 1"));
  EXPECT_THAT(told_after("default-sets.csv", "between,", "betwixt,"),
              HasSubstr("no set 'between'"));
  EXPECT_THAT(told_after("muscle-fibres.csv", ",ring,", ",loop,"), HasSubstr("'left' or 'ring'"));
  EXPECT_THAT(told_after("muscle-fibres.csv", ",3,11", ",4,11"), HasSubstr("3 points; expected 4"));
  EXPECT_THAT(told_after("landmarks.csv", ",1,s", ",yes,s"), HasSubstr("'yes'; expected 0 or 1"));
  EXPECT_THAT(told_after("landmarks.csv", "B,105", "A,105"), HasSubstr("no other row has"));
}

}  // namespace
}  // namespace facies::anatomy
