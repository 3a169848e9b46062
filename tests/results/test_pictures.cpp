// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/figure.hpp"
#include "facies/results/pictures.hpp"

namespace facies::results {
namespace {

using ::testing::ElementsAre;

class Pictures : public InFolder {
 protected:
  [[nodiscard]] std::string bytes(const std::string& name) const {
    return read_file(folder_ / name);
  }

  SheetSubject sheet_;
  Snapshot rest_ = sheet_.affine("release", 2, Mat3::Identity(), {0.0, 0.0, -1.0});
  Snapshot last_ = sheet_.affine("express", 3, Vec3(1.0, 1.2, 1.0).asDiagonal(), {0.0, 0.0, -1.0});
  PictureOptions options_{"smile", "sheet", 200, 1};
};

TEST_F(Pictures, ShowEveryStateOfARun) {
  EXPECT_THAT(write_pictures(*sheet_, &rest_, last_, folder_, options_),
              ElementsAre("rest.png", "landmarks.png", "tensioned-rest.png", "expression.png",
                          "displacement.png", "overview.png"));
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const Image image = read_png(read_file(entry.path()), entry.path().string());
    EXPECT_GT(image.width, 200) << entry.path();
    EXPECT_GT(image.height, 200) << entry.path();
  }
}

TEST_F(Pictures, OfARunWithoutTensionHaveNoTensionedRest) {
  EXPECT_THAT(write_pictures(*sheet_, nullptr, last_, folder_, options_),
              ElementsAre("rest.png", "landmarks.png", "expression.png", "displacement.png",
                          "overview.png"));
}

TEST_F(Pictures, OfARunThatEndsAtTheTensionedRestHaveNoExpression) {
  EXPECT_THAT(write_pictures(*sheet_, &rest_, rest_, folder_, options_),
              ElementsAre("rest.png", "landmarks.png", "tensioned-rest.png", "overview.png"));
}

TEST_F(Pictures, ShareOneFrame) {
  write_pictures(*sheet_, &rest_, last_, folder_, options_);
  const Image rest = read_png(bytes("rest.png"), "rest.png");
  const Image expression = read_png(bytes("expression.png"), "expression.png");
  EXPECT_EQ(rest.width, expression.width);
  EXPECT_EQ(rest.height, expression.height);
  EXPECT_NE(rest.rgb, expression.rgb);
}

TEST_F(Pictures, HaveTheSameBytesForAnyNumberOfThreads) {
  write_pictures(*sheet_, &rest_, last_, folder_, options_);
  const std::string first = bytes("displacement.png");
  const std::string overview = bytes("overview.png");
  options_.threads = 2;
  write_pictures(*sheet_, &rest_, last_, folder_, options_);
  EXPECT_EQ(bytes("displacement.png"), first);
  EXPECT_EQ(bytes("overview.png"), overview);
}

TEST_F(Pictures, NeedAFolder) {
  EXPECT_THROW(write_pictures(*sheet_, &rest_, last_, folder_ / "missing", options_), UsageError);
}

}  // namespace
}  // namespace facies::results
