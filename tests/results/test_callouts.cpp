// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "facies/results/callouts.hpp"

namespace facies::results {
namespace {

TEST(Callouts, StandBesideTheirPointsWhereThereIsRoom) {
  const std::vector<Dot> dots{{80.0, 30.0, "a"}, {10.0, 70.0, "b"}, {20.0, 20.0, "c"}};
  const std::vector<CalloutPlace> places = place_callouts(dots, 100, 100, 15.0);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0].dot, 2U);
  EXPECT_EQ(places[1].dot, 1U);
  EXPECT_EQ(places[2].dot, 0U);
  EXPECT_TRUE(places[0].is_left);
  EXPECT_TRUE(places[1].is_left);
  EXPECT_FALSE(places[2].is_left);
  for (const CalloutPlace& place : places)
    EXPECT_DOUBLE_EQ(place.row, dots[place.dot].row);
}

// Three at one height share what moving apart costs; the least squares are at -15, 0, 15.
TEST(Callouts, MoveApartAsLittleAsPossible) {
  const std::vector<Dot> dots{{10.0, 50.0, "a"}, {11.0, 50.0, "b"}, {12.0, 50.0, "c"}};
  const std::vector<CalloutPlace> places = place_callouts(dots, 100, 100, 15.0);
  EXPECT_DOUBLE_EQ(places[0].row, 35.0);
  EXPECT_DOUBLE_EQ(places[1].row, 50.0);
  EXPECT_DOUBLE_EQ(places[2].row, 65.0);
}

TEST(Callouts, StayInsideTheImageAndNeverCoverEachOther) {
  std::vector<Dot> dots;
  for (int i = 0; i < 8; ++i)
    dots.push_back({5.0, i < 4 ? 1.0 + i : 99.0 - i, "x"});
  const std::vector<CalloutPlace> places = place_callouts(dots, 100, 100, 12.0);
  EXPECT_GE(places.front().row, 6.0);
  EXPECT_LE(places.back().row, 94.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_GE(places[i].row - places[i - 1].row, 12.0 - 1e-9);
    EXPECT_LE(dots[places[i - 1].dot].row, dots[places[i].dot].row);
  }
}

TEST(Callouts, OfNothingAreNone) {
  EXPECT_TRUE(place_callouts({}, 100, 100, 12.0).empty());
}

}  // namespace
}  // namespace facies::results
