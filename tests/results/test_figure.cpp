// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/results/figure.hpp"

namespace facies::results {
namespace {

Image filled(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.rgb.insert(image.rgb.end(), {r, g, b});
  return image;
}

int count(const Image& image, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  int n = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    n += image.rgb[i] == r && image.rgb[i + 1] == g && image.rgb[i + 2] == b ? 1 : 0;
  }
  return n;
}

TEST(Figure, IsAPngThatHoldsItsPanelsUnchanged) {
  const Figure figure{
      "title",
      "small print",
      {{{filled(200, 100, 10, 200, 30), "left", {}}, {filled(150, 100, 90, 20, 210), "right", {}}}},
      0.0,
      {}};
  const std::string png = to_png(figure);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const Image page = read_png(png, "page.png");
  EXPECT_GE(page.width, 350);
  EXPECT_EQ(count(page, 10, 200, 30), 200 * 100);
  EXPECT_EQ(count(page, 90, 20, 210), 150 * 100);
  EXPECT_EQ(page.rgb[0], 255);
}

TEST(Figure, HasTextWhereFontsAre) {
  const Panel panel{filled(300, 50, 255, 255, 255), "", {}};
  const Image without = read_png(to_png({"", "", {{panel}}, 0.0, {}}), "a.png");
  const Image with = read_png(to_png({"title", "", {{panel}}, 0.0, {}}), "b.png");
  EXPECT_EQ(count(without, 255, 255, 255), without.width * without.height);
  EXPECT_LT(count(with, 255, 255, 255), with.width * with.height);
}

TEST(Figure, SaysWhatColoursMeanAndIsWideEnoughForIt) {
  Figure figure{"a title that is much wider than the narrow panel below it",
                "",
                {{{filled(40, 50, 255, 255, 255), "", {}}}},
                0.0,
                {}};
  const Image without = read_png(to_png(figure), "a.png");
  EXPECT_GT(without.width, 600);
  figure.legend = {{Colour{1.0F, 0.0F, 0.0F}, "red"}, {Colour{0.0F, 0.0F, 1.0F}, "blue"}};
  const Image with = read_png(to_png(figure), "b.png");
  EXPECT_GT(with.height, without.height);
  EXPECT_EQ(count(with, 255, 0, 0), 18 * 18);
  EXPECT_EQ(count(with, 0, 0, 255), 18 * 18);
}

TEST(Figure, PutsALegendThatIsTooLongIntoColumns) {
  Figure figure{"", "", {{{filled(200, 50, 255, 255, 255), "", {}}}}, 0.0, {}};
  figure.legend = {{Colour{1.0F, 0.0F, 0.0F}, "a long name of something red"},
                   {Colour{0.0F, 0.0F, 1.0F}, "a long name of something blue"},
                   {{}, "a remark"}};
  const Image page = read_png(to_png(figure), "a.png");
  EXPECT_LT(page.width, 400);
  const auto top_of = [&](std::uint8_t r, std::uint8_t b) {
    for (int row = 0; row < page.height; ++row) {
      for (int column = 0; column < page.width; ++column) {
        const std::uint8_t* p = page.rgb.data() + page.place(column, row);
        if (p[0] == r && p[1] == 0 && p[2] == b) return row;
      }
    }
    return -1;
  };
  EXPECT_EQ(count(page, 255, 0, 0), 18 * 18);
  EXPECT_EQ(top_of(0, 255) - top_of(255, 0), 27);
}

TEST(Figure, DrawsLinesWhereTheyAre) {
  Panel panel{filled(100, 100, 255, 255, 255), "caption", {}};
  panel.strokes = {{{{10.0, 50.5}, {90.0, 50.5}}, {0.0F, 0.0F, 1.0F}, 1.0},
                   {{{10.0, 20.5}, {90.0, 20.5}}, {0.0F, 0.0F, 1.0F}, 1.0}};
  const Image page = read_png(to_png({"title", "", {{panel}}, 0.0, {}}), "a.png");
  // Whole pixels of two lines; their round ends are mixed with the page.
  EXPECT_NEAR(count(page, 0, 0, 255), 160, 4);
}

TEST(Figure, MakesRoomForNamesBesideAnImage) {
  Panel panel{filled(100, 100, 10, 200, 30), "", {}};
  const Image without = read_png(to_png({"", "", {{panel, panel}}, 0.0, {}}), "a.png");
  panel.callouts = {{20.0, 50.0, "LEFT"}, {80.0, 50.0, "A LONGER ONE"}};
  const Image with = read_png(to_png({"", "", {{panel, panel}}, 0.0, {}}), "b.png");
  EXPECT_GT(with.width, without.width + 2 * 100);
  EXPECT_EQ(with.height, without.height);
  // Lines and dots cover little of the images.
  EXPECT_GT(count(with, 10, 200, 30), 2 * 100 * 100 * 9 / 10);
}

TEST(Figure, HasAScaleBarOfARoundLength) {
  // 0.25 mm a pixel: the longest round length of at most 240 pixels is 50 mm, 200 pixels by 4.
  const Image page =
      read_png(to_png({"", "", {{{filled(600, 50, 255, 255, 255), "", {}}}}, 0.25, {}}), "a.png");
  EXPECT_GE(count(page, 38, 38, 38), 200 * 4);
  EXPECT_LT(count(page, 38, 38, 38), 220 * 4);
}

TEST(Figure, HasAColourBarFromTheSmallestBelowToTheLargestAbove) {
  const ColourScale scale{ColourMap::cool_warm, 0.0, 1.0};
  const Image page = read_png(
      to_png(
          {"", "", {{{filled(100, 400, 255, 255, 255), "", {}}}}, 0.0, ColourBar{scale, "[mm]"}}),
      "a.png");
  int first_red = -1;
  int last_blue = -1;
  for (int row = 0; row < page.height; ++row) {
    for (int column = 0; column < page.width; ++column) {
      const std::uint8_t* p =
          page.rgb.data() + static_cast<std::ptrdiff_t>(3) * (row * page.width + column);
      if (p[0] > 170 && p[2] < 60 && first_red < 0) first_red = row;
      if (p[2] > 180 && p[0] < 70) last_blue = row;
    }
  }
  ASSERT_GE(first_red, 0);
  EXPECT_GT(last_blue, first_red + 200);
}

TEST(Figure, MarksPointsWhereTheyAre) {
  const Panel panel{filled(300, 300, 255, 255, 255), "", {{150.0, 200.0, "RMC"}}};
  const Image page = read_png(to_png({"", "", {{panel}}, 0.0, {}}), "a.png");
  double column_sum = 0.0;
  double row_sum = 0.0;
  int n = 0;
  for (int row = 0; row < page.height; ++row) {
    for (int column = 0; column < page.width; ++column) {
      const std::uint8_t* p =
          page.rgb.data() + static_cast<std::ptrdiff_t>(3) * (row * page.width + column);
      if (p[0] < 170 || p[1] > 60) continue;
      column_sum += column;
      row_sum += row;
      ++n;
    }
  }
  ASSERT_GT(n, 20);
  // The panel begins at 28 pixels from the left; below the title's lines.
  EXPECT_NEAR(column_sum / n, 28 + 150, 1.0);
  EXPECT_GT(row_sum / n, 28 + 200);
}

TEST(Figure, OfTheSameThingsHasTheSameBytes) {
  const Figure figure{"title",
                      "small print",
                      {{{filled(200, 100, 10, 200, 30), "left", {{5.0, 6.0, "PG"}}}}},
                      0.25,
                      ColourBar{{}, "x [mm]"}};
  EXPECT_EQ(to_png(figure), to_png(figure));
}

TEST(ReadPng, RefusesOtherFiles) {
  EXPECT_THROW(static_cast<void>(read_png("GIF89a", "a.gif")), DataError);
  const std::string png = to_png({"", "", {{{filled(20, 10, 1, 2, 3), "", {}}}}, 0.0, {}});
  EXPECT_THROW(static_cast<void>(read_png(png.substr(0, png.size() / 2), "half.png")), DataError);
}

}  // namespace
}  // namespace facies::results
