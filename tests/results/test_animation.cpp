// SPDX-License-Identifier: Apache-2.0
// Animated files are taken apart again, and every frame read by libpng; tests/cli reads one in another language.
#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/animation.hpp"
#include "facies/results/apng.hpp"
#include "facies/results/figure.hpp"

namespace facies::results {
namespace {

/// A page with a panel of one colour.
std::string page(std::uint8_t grey, int width = 20) {
  Image image{width, 10, {}};
  image.rgb.assign(image.place(0, image.height), grey);
  return to_png({"", "", {{{std::move(image), "", {}}}}, 0.0, {}});
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1))
    ++n;
  return n;
}

TEST(Apng, ShowsItsFirstFrameToReadersThatKnowNoAnimations) {
  const std::string first = page(10);
  const std::string file = to_apng(std::vector<AnimationFrame>{{first, 100}, {page(200), 100}});
  EXPECT_EQ(read_png(file, "a").rgb, read_png(first, "b").rgb);
  EXPECT_EQ(count(file, "acTL"), 1U);
  EXPECT_EQ(count(file, "fcTL"), 2U);
  EXPECT_EQ(count(file, "fdAT"), 1U);
}

TEST(Apng, RefusesFramesOfDifferentSizesAndFilesThatAreNone) {
  const auto make = [](std::vector<AnimationFrame> frames) { return to_apng(frames); };
  EXPECT_THROW((void)make({}), BugError);
  EXPECT_THROW((void)make({{page(0), 10}, {page(0, 2000), 10}}), BugError);
  EXPECT_THROW((void)make({{"GIF89a", 10}}), BugError);
  EXPECT_THROW((void)make({{page(0).substr(0, 60), 10}}), BugError);
  EXPECT_THROW((void)make({{page(0), 0}}), BugError);
}

using Animation = InFolder;

TEST_F(Animation, HasTheSameBytesForAnyNumberOfThreads) {
  const SheetSubject sheet;
  std::vector<Snapshot> frames;
  for (const double load : {0.0, 0.5, 1.0}) {
    frames.push_back(
        sheet.affine("express", 3, Vec3(1.0, 1.0 + load, 1.0).asDiagonal(), Vec3::Zero()));
    frames.back().load = load;
  }
  PictureOptions options{"smile", "sheet", 120, 1};
  EXPECT_EQ(write_animation(*sheet, frames, folder_, options), "03-express-animation.png");
  const std::string first = read_file(folder_ / "03-express-animation.png");
  EXPECT_EQ(count(first, "fcTL"), 3U);
  options.threads = 2;
  write_animation(*sheet, frames, folder_, options);
  EXPECT_EQ(read_file(folder_ / "03-express-animation.png"), first);
  EXPECT_THROW(write_animation(*sheet, frames, folder_ / "missing", options), UsageError);
}

}  // namespace
}  // namespace facies::results
