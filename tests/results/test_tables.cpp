// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <vector>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/text.hpp"
#include "facies/results/tables.hpp"

namespace facies::results {
namespace {

using ::testing::ElementsAre;

class Tables : public ::testing::Test {
 protected:
  Tables() {
    snapshots_.push_back(sheet_.affine("tension", 1, Mat3::Identity(), {0.5, 0.0, 0.0}));
    snapshots_.push_back(sheet_.affine("release", 2, Mat3::Identity(), {1.0, 0.0, 0.0}));
    snapshots_.push_back(
        sheet_.affine("express", 3, Vec3(1.0, 1.5, 1.0).asDiagonal(), {1.0, 0.0, 0.0}));
  }

  static std::vector<std::string_view> row(const std::string& text, std::size_t n) {
    return split(split(text, '\n')[n], ',');
  }

  SheetSubject sheet_;
  std::vector<Snapshot> snapshots_;
};

TEST_F(Tables, ListEveryLandmarkAtTheEndOfEveryStep) {
  const std::string text = landmarks_csv(*sheet_, {snapshots_, 1});
  EXPECT_THAT(row(text, 0), ElementsAre("step", "landmark", "x_mm", "y_mm", "z_mm", "ux_mm",
                                        "uy_mm", "uz_mm", "displacement_mm"));
  EXPECT_THAT(row(text, 3), ElementsAre("tension", "R", "0.5", "10", "0", "0.5", "0", "0", "0.5"));
  EXPECT_THAT(row(text, 7), ElementsAre("release", "R", "1", "10", "0", "0", "0", "0", "0"));
  EXPECT_THAT(row(text, 11), ElementsAre("express", "R", "1", "15", "0", "0", "5", "0", "5"));
  EXPECT_EQ(split(text, '\n').size(), 1U + 3U * 4U + 1U);
}

TEST_F(Tables, CountFromTheMeshWhereThereIsNoTensionedRest) {
  const std::string text = landmarks_csv(*sheet_, {snapshots_, {}});
  EXPECT_THAT(row(text, 11), ElementsAre("express", "R", "1", "15", "0", "1", "5", "0",
                                         exact_number(std::sqrt(26.0))));
}

TEST_F(Tables, ListEveryPair) {
  const std::string text = distances_csv(*sheet_, {snapshots_, 1});
  EXPECT_THAT(row(text, 0), ElementsAre("step", "pair", "rest_mm", "length_mm", "change_percent"));
  EXPECT_THAT(row(text, 5), ElementsAre("express", "R-L", "20", "30", "50"));
  EXPECT_THAT(row(text, 6), ElementsAre("express", "M-D", "20", "20", "0"));
}

TEST_F(Tables, LeaveOutUnfinishedSteps) {
  snapshots_[2].load = 0.5;
  EXPECT_EQ(landmarks_csv(*sheet_, {snapshots_, 1}).find("express"), std::string::npos);
  EXPECT_EQ(distances_csv(*sheet_, {snapshots_, 1}).find("express"), std::string::npos);
}

TEST(ExactNumber, ReadsBackAsTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3.0, -62.220240000000004, 1e-17, 5.0}) {
    EXPECT_EQ(parse_number(exact_number(value)), value);
  }
  EXPECT_EQ(exact_number(-0.0), "0");
  EXPECT_EQ(exact_number(0.1), "0.1");
}

}  // namespace
}  // namespace facies::results
