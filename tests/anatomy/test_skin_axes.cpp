// SPDX-License-Identifier: Apache-2.0
// The material axes of the skin.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/anatomy/skin_axes.hpp"
#include "facies/mesh/layered_sheet.hpp"

namespace facies::anatomy {
namespace {

TEST(SkinAxes, ProjectTheDirectionAndPutTheNormalSecond) {
  const Vec3 normal = Vec3(-2, 1, 3).normalized();
  const Vec3 direction = Vec3(1, 5, 0.3).normalized();
  const SkinAxes found = skin_axes(direction, normal);
  EXPECT_FALSE(found.is_fallback);
  EXPECT_LT((found.axes.transpose() * found.axes - Mat3::Identity()).norm(), 1e-14);
  EXPECT_NEAR(found.axes.determinant(), 1.0, 1e-14);
  EXPECT_LT((found.axes.col(1) - normal).norm(), 1e-15);
  // a1 lies in the plane of direction and normal, on the direction's side.
  EXPECT_NEAR(found.axes.col(2).dot(direction), 0.0, 1e-14);
  EXPECT_GT(found.axes.col(0).dot(direction), 0.0);
}

TEST(SkinAxes, AreHorizontalWhereTheDirectionStandsOnTheSkin) {
  const Vec3 normal = Vec3(-3, 1, 2).normalized();
  const double tilt = std::tan(4.9 * 3.14159265358979 / 180.0);
  const Vec3 nearly = (normal + tilt * normal.unitOrthogonal()).normalized();
  const SkinAxes found = skin_axes(nearly, normal);
  EXPECT_TRUE(found.is_fallback);
  EXPECT_NEAR(found.axes(2, 0), 0.0, 1e-15);
  EXPECT_LT((found.axes.transpose() * found.axes - Mat3::Identity()).norm(), 1e-14);
}

TEST(SkinAxes, TrustADirectionFromFiveDegreesOn) {
  const Vec3 normal = -Vec3::UnitX();
  const double tilt = std::tan(5.1 * 3.14159265358979 / 180.0);
  const SkinAxes found = skin_axes((normal + tilt * Vec3::UnitZ()).normalized(), normal);
  EXPECT_FALSE(found.is_fallback);
  EXPECT_LT((found.axes.col(0) - Vec3::UnitZ()).norm(), 1e-14);
}

TEST(SkinAxes, RunAlongYWhereTheSkinItselfIsHorizontal) {
  const SkinAxes found = skin_axes(Vec3::UnitZ(), Vec3::UnitZ());
  EXPECT_TRUE(found.is_fallback);
  EXPECT_LT((found.axes.col(0) - Vec3::UnitY()).norm(), 1e-15);
}

TEST(SkinAxes, FollowTheSkinThroughAllItsElementLayers) {
  mesh::SheetOptions options;
  options.shape = mesh::SheetShape::sphere;
  options.layers = {{"skin", 1.5, 3}, {"hypodermis_mid", 5.0, 1}, {"hypodermis_inner", 5.0, 1}};
  FaceAnatomy face;
  face.mesh = mesh::make_layered_sheet(options);
  const std::vector<Vec3> directions(face.mesh.n_elements(), Vec3::UnitY());
  EXPECT_EQ(set_skin_axes(face, directions), 0U);
  const Vec3 center(options.radius, 0.0, 0.0);
  for (const Index e : face.mesh.elements("skin")) {
    const Vec3 outward = (face.mesh.centroid(e) - center).normalized();
    // A facet of 5 mm on a sphere of 80 mm.
    EXPECT_LT((face.axes[at(e)].col(1) - outward).norm(), 0.01) << e;
  }
}

}  // namespace
}  // namespace facies::anatomy
