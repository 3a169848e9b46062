// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/math/barrier.hpp"

namespace facies {
namespace {

constexpr double d_hat = 0.4;

TEST(Barrier, IsTheFormulaOfItsSource) {
  for (const double d : {1e-6, 0.01, 0.1, 0.19, 0.21, 0.3, 0.399}) {
    const double expected = -(d - d_hat) * (d - d_hat) * std::log(d / d_hat);
    EXPECT_NEAR(barrier(d, d_hat).b, expected, 1e-12 * expected);
  }
}

TEST(Barrier, HasTheSlopesOfItsValue) {
  for (const double d : {0.02, 0.1, 0.2, 0.3, 0.38}) {
    const BarrierResponse at_d = barrier(d, d_hat);
    EXPECT_GT(support::remainder_slope([&](double h) { return barrier(d + d * h, d_hat).b; },
                                       d * at_d.db_dd),
              1.9);
    EXPECT_GT(support::remainder_slope([&](double h) { return barrier(d + d * h, d_hat).db_dd; },
                                       d * at_d.d2b_dd2),
              1.9);
  }
}

TEST(Barrier, VanishesAtItsDistanceWithBothDerivatives) {
  // b = gap^3 / d_hat + ..., with gap = d_hat - d.
  for (const double gap : {1e-3, 1e-6, 1e-9}) {
    const BarrierResponse near = barrier(d_hat - gap, d_hat);
    EXPECT_NEAR(near.b / (gap * gap * gap / d_hat), 1.0, 10.0 * gap + 1e-6);
    EXPECT_NEAR(near.db_dd / (-3.0 * gap * gap / d_hat), 1.0, 10.0 * gap + 1e-6);
    EXPECT_NEAR(near.d2b_dd2 / (6.0 * gap / d_hat), 1.0, 10.0 * gap + 1e-6);
  }
  for (const double d : {d_hat, 1.0, 1e9}) {
    EXPECT_EQ(barrier(d, d_hat).b, 0.0);
    EXPECT_EQ(barrier(d, d_hat).db_dd, 0.0);
    EXPECT_EQ(barrier(d, d_hat).d2b_dd2, 0.0);
  }
}

TEST(Barrier, FallsAndIsConvexWhereItActs) {
  for (int i = 1; i < 400; ++i) {
    const double d = i / 400.0 * d_hat;
    EXPECT_GT(barrier(d, d_hat).b, 0.0);
    EXPECT_LT(barrier(d, d_hat).db_dd, 0.0);
    EXPECT_GT(barrier(d, d_hat).d2b_dd2, 0.0);
  }
}

TEST(Barrier, IsInfiniteAtContactAndBeyond) {
  EXPECT_GT(barrier(1e-300, d_hat).b, 100.0);
  for (const double d : {0.0, -1.0}) {
    EXPECT_EQ(barrier(d, d_hat).b, std::numeric_limits<double>::infinity());
    EXPECT_EQ(barrier(d, d_hat).db_dd, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(barrier(d, d_hat).d2b_dd2, std::numeric_limits<double>::infinity());
  }
}

TEST(Barrier, IsNotSilentAboutWhatIsNoNumber) {
  EXPECT_TRUE(std::isnan(barrier(std::numeric_limits<double>::quiet_NaN(), d_hat).b));
}

}  // namespace
}  // namespace facies
