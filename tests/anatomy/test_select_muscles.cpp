// SPDX-License-Identifier: Apache-2.0
// Muscles from paths, on meshes and paths where the answer is known.
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include <gtest/gtest.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mesh/layered_sheet.hpp"

namespace facies::anatomy {
namespace {

/// A sheet of 80 x 80 mm in 40 x 40 columns, one layer of 2 mm: centroids at x = 1, y and z odd.
FaceAnatomy sheet() {
  mesh::SheetOptions options;
  options.size_y = options.size_z = 80.0;
  options.n_y = options.n_z = 40;
  options.layers = {{"skin", 2.0, 1}};
  FaceAnatomy face;
  face.mesh = mesh::make_layered_sheet(options);
  return face;
}

FibrePath line(Side side, const Vec3& a, const Vec3& b) {
  return {side, false, {a, b}};
}

TEST(SelectMuscles, TakesCentroidsStrictlyNearerThanTheRadius) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"M", "", {line(Side::middle, {1, 0, -60}, {1, 0, 60})}}};
  // Columns at |y| = 1, 3, 5; those at 5 only if the radius is larger.
  EXPECT_EQ(select_muscles(face, 5.0, 1.0).at(0).elements.size(), 4U * 40U);
  EXPECT_EQ(select_muscles(face, 5.0 + 1e-9, 1.0).at(0).elements.size(), 6U * 40U);
}

TEST(SelectMuscles, MeasuresInTheScaledDownConfiguration) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"M", "", {line(Side::middle, {1, 0.2, -31}, {1, 0.2, 17})}}};
  FaceAnatomy scaled = sheet();
  const double scale = 1.1;
  std::vector<Vec3> X(face.mesh.X().begin(), face.mesh.X().end());
  for (Vec3& x : X)
    x /= scale;
  scaled.mesh =
      mesh::Mesh(std::move(X), {face.mesh.elements().begin(), face.mesh.elements().end()});
  scaled.muscle_paths = face.muscle_paths;
  for (Vec3& p : scaled.muscle_paths[0].paths[0].points)
    p /= scale;
  EXPECT_EQ(select_muscles(face, 6.0, scale).at(0).elements,
            select_muscles(scaled, 6.0, 1.0).at(0).elements);
  EXPECT_NE(select_muscles(face, 6.0, scale).at(0).elements,
            select_muscles(face, 6.0, 1.0).at(0).elements);
}

TEST(SelectMuscles, EndsAtTheEndsOfOpenPaths) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"M", "", {line(Side::middle, {1, 1, -1}, {1, 1, 1})}}};
  // Around two centroids: those within 2.1 mm of either are these two and their six neighbours.
  EXPECT_EQ(select_muscles(face, 2.1, 1.0).at(0).elements.size(), 8U);
}

TEST(SelectMuscles, GivesEachElementToTheSideOfTheNearestPath) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {
      {"M",
       "",
       {line(Side::right, {1, 2, -60}, {1, 2, 60}), line(Side::left, {1, -2, -60}, {1, -2, 60})}}};
  const std::vector<Muscle> muscles = select_muscles(face, 6.0, 1.0);
  ASSERT_EQ(muscles.size(), 2U);
  EXPECT_EQ(muscles[0].name, "M_L");
  EXPECT_EQ(muscles[0].group, "M");
  EXPECT_EQ(muscles[1].name, "M_R");
  for (const Muscle& muscle : muscles) {
    EXPECT_EQ(muscle.elements.size(), 4U * 40U);
    for (const Index e : muscle.elements)
      EXPECT_GT((muscle.side == Side::right ? 1.0 : -1.0) * face.mesh.centroid(e).y(), 0.0);
  }
}

TEST(SelectMuscles, GivesAStraightFibresDirection) {
  FaceAnatomy face = sheet();
  const Vec3 along = Vec3(0, 1, 2).normalized();
  face.muscle_paths = {{"M", "", {line(Side::middle, -20 * along, 20 * along)}}};
  const Muscle muscle = select_muscles(face, 6.0, 1.0).at(0);
  for (const Vec3& direction : muscle.directions)
    EXPECT_LT((direction - along).norm(), 1e-12);
}

TEST(SelectMuscles, RunsAroundAClosedRingOneWay) {
  FaceAnatomy face = sheet();
  FibrePath ring{Side::middle, true, {}};
  for (int i = 0; i < 72; ++i) {
    const double angle = i * std::numbers::pi / 36.0;
    ring.points.emplace_back(1.0, 25.0 * std::cos(angle), 25.0 * std::sin(angle));
  }
  face.muscle_paths = {{"OOP", "", {ring}}};
  const Muscle muscle = select_muscles(face, 6.0, 1.0).at(0);
  EXPECT_EQ(muscle.name, "OOP");
  bool is_where_it_closes = false;
  for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
    const Vec3 c = face.mesh.centroid(muscle.elements[i]);
    const Vec3 tangent = Vec3(0, -c.z(), c.y()).normalized();
    // Three degrees: half a segment of the polygon, and its curvature within the width of the mean.
    EXPECT_GT(muscle.directions[i].dot(tangent), 0.9986) << c.transpose();
    is_where_it_closes = is_where_it_closes || (c.y() > 24 && std::abs(c.z() + 1.0) < 1e-9);
  }
  EXPECT_TRUE(is_where_it_closes);
}

TEST(SelectMuscles, TurnsSmoothlyFromOneFibreToAnother) {
  // Two fibres 8 mm apart, 30 degrees to each other: in between the direction is in between, and near each it is its own.
  FaceAnatomy face = sheet();
  const Vec3 t(0, std::sin(std::numbers::pi / 6), std::cos(std::numbers::pi / 6));
  face.muscle_paths = {{"M",
                        "",
                        {line(Side::middle, {1, -4, -39}, {1, -4, 39}),
                         line(Side::middle, Vec3(1, 4, 0) - 5 * t, Vec3(1, 4, 0) + 5 * t)}}};
  const Muscle muscle = select_muscles(face, 6.0, 1.0).at(0);
  double previous = -1.0;
  for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
    const Vec3 c = face.mesh.centroid(muscle.elements[i]);
    if (std::abs(c.z() - 1.0) > 1e-9 || c.y() < -4.5 || c.y() > 4.5) continue;
    const double angle = std::atan2(muscle.directions[i].y(), muscle.directions[i].z());
    EXPECT_GT(angle, previous) << c.y();
    EXPECT_LT(angle, std::numbers::pi / 6 + 1e-9);
    previous = angle;
  }
  EXPECT_GT(previous, 0.8 * std::numbers::pi / 6);
}

TEST(SelectMuscles, IsVerticalBetweenMirroredFibresThatMeetAtTheMidline) {
  // Fibres slanted to the midplane from both sides: across the plane y = 0 the transverse parts cancel.
  FaceAnatomy face = sheet();
  face.muscle_paths = {
      {"MENT",
       "",
       {line(Side::left, {1, -10, 20}, {1, 0, 0}), line(Side::right, {1, 10, 20}, {1, 0, 0})}}};
  const std::vector<Muscle> muscles = select_muscles(face, 6.0, 1.0);
  const auto across = [&](double z) {
    double sum = 0.0;
    for (const Muscle& muscle : muscles) {
      for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
        const Vec3 c = face.mesh.centroid(muscle.elements[i]);
        if (std::abs(c.z() - z) < 1e-9 && std::abs(c.y()) < 1.5)
          sum += muscle.directions[i].y() * (muscle.directions[i].z() > 0 ? 1.0 : -1.0);
      }
    }
    return sum;
  };
  EXPECT_NEAR(across(1.0), 0.0, 1e-12);
}

TEST(SelectMuscles, RefusesMusclesWithoutElementsAllAtOnce) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"A", "", {line(Side::left, {100, 0, 0}, {100, 0, 5})}},
                       {"B", "", {line(Side::middle, {1, 0, 0}, {1, 0, 5})}},
                       {"C", "", {}},
                       {"D", "", {line(Side::middle, {1, 0, 0}, {1, 0, 0})}}};
  try {
    (void)select_muscles(face, 6.0, 1.0);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_EQ(error.problems().size(), 3U);
    EXPECT_THAT(
        error.what(),
        testing::AllOf(testing::HasSubstr("muscle A_L: no element within 6 mm"),
                       testing::HasSubstr("muscle C: no path"), testing::HasSubstr("muscle D")));
  }
}

}  // namespace
}  // namespace facies::anatomy
