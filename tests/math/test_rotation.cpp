// SPDX-License-Identifier: Apache-2.0
// Rotation vectors and matrices.
#include <numbers>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/math/rotation.hpp"

namespace facies {
namespace {

TEST(CrossMatrix, MultipliesAsTheCrossProduct) {
  const Vec3 w(1, -2, 3);
  const Vec3 v(0.5, 4, -1);
  EXPECT_EQ(cross_matrix(w) * v, w.cross(v));
}

TEST(RotationMatrix, TurnsBySoMuchAboutItsAxis) {
  const Mat3 R = rotation_matrix(0.5 * std::numbers::pi * Vec3::UnitZ());
  EXPECT_TRUE((R * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-15));
  EXPECT_EQ(rotation_matrix(Vec3::Zero()), Mat3::Identity());
}

TEST(RotationMatrix, IsTheExponentialOfTheCrossMatrix) {
  support::Random random(2);
  const Vec3 w = random.vector(-2, 2);
  Mat3 power = Mat3::Identity();
  Mat3 series = Mat3::Identity();
  for (int n = 1; n < 40; ++n) {
    power = power * cross_matrix(w) / n;
    series += power;
  }
  EXPECT_TRUE(rotation_matrix(w).isApprox(series, 1e-13));
}

TEST(RotationVector, IsTheInverseOfTheRotationMatrix) {
  support::Random random(6);
  for (int i = 0; i < 20; ++i) {
    const Vec3 w = random.uniform(0.0, 3.1) * random.unit_vector();
    EXPECT_LE((rotation_vector(rotation_matrix(w)) - w).norm(), 1e-12);
  }
  EXPECT_LE(rotation_vector(Mat3::Identity()).norm(), 0.0);
}

}  // namespace
}  // namespace facies
