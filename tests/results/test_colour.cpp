// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "facies/results/colour.hpp"

namespace facies::results {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

/// CIE lightness L* of a colour: what the eye takes for brightness.
double lightness(const Colour& colour) {
  const auto light = to_light(colour);
  const double Y =
      0.2126 * double{light[0]} + 0.7152 * double{light[1]} + 0.0722 * double{light[2]};
  return Y > 0.008856 ? 116.0 * std::cbrt(Y) - 16.0 : 903.3 * Y;
}

TEST(ColourMap, MagnitudesChangeLightnessInEqualStepsOneWay) {
  for (const ColourMap map : {ColourMap::lajolla, ColourMap::viridis}) {
    const double whole = lightness(colour_at(map, 1.0)) - lightness(colour_at(map, 0.0));
    for (int i = 0; i < 10; ++i) {
      const double step =
          lightness(colour_at(map, 0.1 * (i + 1))) - lightness(colour_at(map, 0.1 * i));
      EXPECT_NEAR(step / whole, 0.1, 0.045) << "step " << i;
    }
  }
}

TEST(ColourMap, TheSignedOneIsGreyInTheMiddleAndEquallyDarkAtItsEnds) {
  const Colour middle = colour_at(ColourMap::cool_warm, 0.5);
  EXPECT_EQ(middle.r, middle.g);
  EXPECT_EQ(middle.g, middle.b);
  EXPECT_NEAR(lightness(colour_at(ColourMap::cool_warm, 0.0)),
              lightness(colour_at(ColourMap::cool_warm, 1.0)), 3.0);
  EXPECT_GT(colour_at(ColourMap::cool_warm, 0.0).b, colour_at(ColourMap::cool_warm, 0.0).r);
}

TEST(ColourMap, ValuesOutsideAndNoNumberGetTheColourOfAnEnd) {
  for (const ColourMap map : {ColourMap::lajolla, ColourMap::viridis, ColourMap::cool_warm}) {
    EXPECT_EQ(colour_at(map, -3.0), colour_at(map, 0.0));
    EXPECT_EQ(colour_at(map, 7.0), colour_at(map, 1.0));
    EXPECT_EQ(colour_at(map, std::nan("")), colour_at(map, 0.0));
  }
}

TEST(ColourMap, ViridisHasTheColoursOfItsAuthors) {
  // Row 128 of 256 in matplotlib: (0.127568, 0.566949, 0.550556).
  const Colour colour = colour_at(ColourMap::viridis, 128.0 / 255.0);
  EXPECT_NEAR(colour.r, 0.127568, 0.005);
  EXPECT_NEAR(colour.g, 0.566949, 0.005);
  EXPECT_NEAR(colour.b, 0.550556, 0.005);
}

TEST(Colour, GoesToLightAndBack) {
  const Colour colour{0.02F, 0.5F, 0.93F};
  const Colour back = from_light(to_light(colour));
  EXPECT_NEAR(back.r, colour.r, 1e-6);
  EXPECT_NEAR(back.g, colour.g, 1e-6);
  EXPECT_NEAR(back.b, colour.b, 1e-6);
}

TEST(ColourScale, HasRoundTicksWithinItsRange) {
  const ColourScale scale{ColourMap::viridis, 0.0, 12.0};
  EXPECT_THAT(scale.ticks(), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0));
  const ColourScale small{ColourMap::viridis, -0.003, 0.0031};
  EXPECT_THAT(small.ticks(),
              Pointwise(DoubleNear(1e-12), {-0.003, -0.002, -0.001, 0.0, 0.001, 0.002, 0.003}));
}

TEST(ColourScale, HasFourToNineTicksForEveryRange) {
  for (double maximum = 1e-4; maximum < 1e5; maximum *= 1.37) {
    const std::size_t n = ColourScale{ColourMap::viridis, 0.0, maximum}.ticks().size();
    EXPECT_GE(n, 4U) << maximum;
    EXPECT_LE(n, 9U) << maximum;
  }
}

TEST(RoundUp, FindsTheNextRoundNumber) {
  EXPECT_DOUBLE_EQ(round_up(11.3), 12.0);
  EXPECT_DOUBLE_EQ(round_up(12.0), 12.0);
  EXPECT_DOUBLE_EQ(round_up(0.0801), 0.1);
  EXPECT_DOUBLE_EQ(round_up(0.0), 1.0);
}

}  // namespace
}  // namespace facies::results
