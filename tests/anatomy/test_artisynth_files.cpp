// SPDX-License-Identifier: Apache-2.0
// The file formats of the reference face, one by one.
#include <gmock/gmock.h>

#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/artisynth_files.hpp"

namespace facies::anatomy {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Formats : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& content) const {
    std::filesystem::path path = folder_.path() / "file.txt";
    SyntheticFace::write(path, content);
    return path;
  }

  [[nodiscard]] std::vector<long> numbers(const std::string& content, ListForm form) {
    std::vector<long> values;
    for (const NumberAt& number : read_numbers(write(content), form, problems_))
      values.push_back(number.value);
    return values;
  }

  [[nodiscard]] std::string told() const {
    std::string all;
    for (const Problem& problem : problems_.list())
      all += to_string(problem) + "\n";
    return all;
  }

  TemporaryFolder folder_;
  Problems problems_;
};

TEST_F(Formats, ReadTheNumberInFrontOfAFixedColumnThatTouchesIt) {
  EXPECT_THAT(numbers("    1204-0.3651E-05  78.8\n      34 -6.5  7.9\n38 -15.8 4 -1\n  77\n",
                      ListForm::first_column),
              testing::ElementsAre(1204, 34, 38, 77));
  EXPECT_TRUE(problems_.empty());
}

TEST_F(Formats, RefuseAFirstColumnThatIsNoWholeNumber) {
  EXPECT_THAT(numbers("12.5 1 2 3\n12a 1\n-3 1\n", ListForm::first_column), IsEmpty());
  EXPECT_THAT(told(), HasSubstr(":1:1: '12.5'; expected a whole number"));
  EXPECT_THAT(told(), HasSubstr(":2:1: '12a'"));
}

TEST_F(Formats, ReadListsOverBlanksTabsAndLines) {
  EXPECT_THAT(numbers(" 3 1\t4\r\n\r\n15", ListForm::list), testing::ElementsAre(3, 1, 4, 15));
  EXPECT_TRUE(problems_.empty());
}

TEST_F(Formats, RefuseAListThatNamesANumberTwice) {
  EXPECT_THAT(numbers("3 1\n4 3\n", ListForm::list), IsEmpty());
  EXPECT_THAT(told(), HasSubstr("file.txt:2:3: 3 a second time, first on line 1"));
}

TEST_F(Formats, TurnMetresIntoMillimetres) {
  const auto points = read_points(write("7 0.01 -0.02 1e-3\n"), problems_);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].number, 7);
  EXPECT_LT((points[0].X - Vec3(10.0, -20.0, 1.0)).norm(), 1e-12);
}

TEST_F(Formats, TakeTheFirstColumnOfARowMajorMatrixAndMakeItAUnitVector) {
  // The columns of this rotation by 120 degrees about (1, 1, 1) are y, z, x; its rows z, x, y.
  const auto directions = read_directions(write("0 0 1 1.00002 0 0 0 1 0\n"), problems_);
  ASSERT_EQ(directions.size(), 1U);
  EXPECT_LT((directions[0] - Vec3::UnitY()).norm(), 1e-15);
}

TEST_F(Formats, ReadAnsysElements) {
  const auto rows = read_elements(
      write("  2684    61    60  2685  2686   244   243  2687 1 1 1 1 0 17\n"), problems_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].number, 17);
  EXPECT_THAT(rows[0].nodes, testing::ElementsAre(2684, 61, 60, 2685, 2686, 244, 243, 2687));
  EXPECT_THAT(rows[0].where, HasSubstr("file.txt:1"));
}

TEST_F(Formats, ReportEveryBadFieldOfALine) {
  EXPECT_THAT(read_points(write("1 a b 3\n"), problems_), IsEmpty());
  EXPECT_THAT(told(), HasSubstr(":1:3: 'a'"));
  EXPECT_THAT(told(), HasSubstr(":1:5: 'b'"));
}

}  // namespace
}  // namespace facies::anatomy
