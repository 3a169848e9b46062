// SPDX-License-Identifier: Apache-2.0
// Muscles from paths, on meshes and paths where the answer is known.
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include <gtest/gtest.h>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/anatomy/muscle_band.hpp"
#include "facies/mesh/layered_sheet.hpp"
#include "facies/mesh/quality.hpp"

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
  EXPECT_EQ(select_muscles(face, {5.0, 0.0}, 1.0).at(0).elements.size(), 4U * 40U);
  EXPECT_EQ(select_muscles(face, {5.0 + 1e-9, 0.0}, 1.0).at(0).elements.size(), 6U * 40U);
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
  EXPECT_EQ(select_muscles(face, {6.0, 0.0}, scale).at(0).elements,
            select_muscles(scaled, {6.0, 0.0}, 1.0).at(0).elements);
  EXPECT_NE(select_muscles(face, {6.0, 0.0}, scale).at(0).elements,
            select_muscles(face, {6.0, 0.0}, 1.0).at(0).elements);
}

TEST(SelectMuscles, EndsAtTheEndsOfOpenPaths) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"M", "", {line(Side::middle, {1, 1, -1}, {1, 1, 1})}}};
  // Around two centroids: those within 2.1 mm of either are these two and their six neighbours.
  EXPECT_EQ(select_muscles(face, {2.1, 0.0}, 1.0).at(0).elements.size(), 8U);
}

TEST(SelectMuscles, GivesEachElementToTheSideOfTheNearestPath) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {
      {"M",
       "",
       {line(Side::right, {1, 2, -60}, {1, 2, 60}), line(Side::left, {1, -2, -60}, {1, -2, 60})}}};
  const std::vector<Muscle> muscles = select_muscles(face, {6.0, 0.0}, 1.0);
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
  const Muscle muscle = select_muscles(face, {6.0, 0.0}, 1.0).at(0);
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
  const Muscle muscle = select_muscles(face, {6.0, 0.0}, 1.0).at(0);
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
  const Muscle muscle = select_muscles(face, {6.0, 0.0}, 1.0).at(0);
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
  const std::vector<Muscle> muscles = select_muscles(face, {6.0, 0.0}, 1.0);
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

/// Three layers of 2 mm over the sheet's columns; centroids at x = 1, 3, 5. Outwards is -x.
FaceAnatomy thick_sheet(int columns = 40) {
  mesh::SheetOptions options;
  options.size_y = options.size_z = 80.0;
  options.n_y = options.n_z = columns;
  options.layers = {{"fat", 6.0, 3}};
  FaceAnatomy face;
  face.mesh = mesh::make_layered_sheet(options);
  return face;
}

MusclePaths band(double width, double thickness, const Vec3& a, const Vec3& b) {
  const Vec3 outward = -Vec3::UnitX();
  return {"M", "", {{Side::middle, false, {a, b}, {outward, outward}}}, width, thickness};
}

double volume(const FaceAnatomy& face, const Muscle& muscle) {
  double sum = 0.0;
  for (std::size_t i = 0; i < muscle.elements.size(); ++i)
    sum += muscle.shares[i] * mesh::element_volume(face.mesh, muscle.elements[i], face.mesh.X());
  return sum;
}

TEST(SelectMuscles, GivesABandTheElementsItFillsAndSharesOfTheOthers) {
  FaceAnatomy face = thick_sheet();
  // Columns at |y| < 4 are filled, half of those at 4 to 6; in depth the layer from 2 to 4.
  face.muscle_paths = {band(10.0, 2.0, {3, 0, -30}, {3, 0, 30})};
  const Muscle muscle = select_muscles(face, {6.0, 0.0}, 1.0).at(0);
  EXPECT_EQ(muscle.elements.size(), 6U * 30U);
  for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
    const Vec3 c = face.mesh.centroid(muscle.elements[i]);
    EXPECT_DOUBLE_EQ(c.x(), 3.0);
    EXPECT_NEAR(muscle.shares[i], std::abs(c.y()) < 4.0 ? 1.0 : 0.5, 1e-12) << c.transpose();
  }
}

TEST(SelectMuscles, EnlargesABandByTheMarginAllAround) {
  FaceAnatomy face = thick_sheet();
  face.muscle_paths = {band(6.0, 0.5, {3, 0, -30}, {3, 0, 30})};
  const Muscle with = select_muscles(face, {6.0, 1.5}, 1.0).at(0);
  face.muscle_paths = {band(9.0, 3.5, {3, 0, -30}, {3, 0, 30})};
  const Muscle wide = select_muscles(face, {6.0, 0.0}, 1.0).at(0);
  EXPECT_EQ(with.elements, wide.elements);
  EXPECT_EQ(with.shares, wide.shares);
}

TEST(SelectMuscles, GivesWholeElementsToAMuscleWithoutAWidth) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"M", "", {line(Side::middle, {1, 0, -60}, {1, 0, 60})}}};
  const Muscle muscle = select_muscles(face, {6.0, 3.0}, 1.0).at(0);
  EXPECT_EQ(muscle.shares, std::vector<double>(muscle.elements.size(), 1.0));
}

TEST(SelectMuscles, KeepsABandsSizeWhateverRadiusAndScale) {
  FaceAnatomy face = thick_sheet();
  face.muscle_paths = {band(10.2, 2.2, {2, 0, -30}, {2, 0, 30})};
  EXPECT_EQ(select_muscles(face, {6.0, 0.0}, 1.0).at(0).elements,
            select_muscles(face, {1.0, 0.0}, 1.2).at(0).elements);
}

TEST(SelectMuscles, GivesABandItsOwnVolumeOnEveryMeshAndAtEveryDepth) {
  const double expected = 16.0 * 2.0 * 48.0;
  for (const int columns : {20, 40, 80}) {
    FaceAnatomy face = thick_sheet(columns);
    for (double depth = 1.1; depth < 5.0; depth += 0.7) {
      face.muscle_paths = {band(16.0, 2.0, {depth, 0.9, -24}, {depth, 0.9, 24})};
      EXPECT_NEAR(volume(face, select_muscles(face, {6.0, 0.0}, 1.0).at(0)), expected,
                  0.1 * expected)
          << columns << " columns, depth " << depth;
    }
  }
}

TEST(SelectMuscles, GivesAnAskewBandItsOwnVolume) {
  FaceAnatomy face = thick_sheet();
  const Vec3 along = Vec3(0, 0.3, 1).normalized();
  face.muscle_paths = {band(8.0, 2.0, Vec3(3, 0.5, 0) - 30 * along, Vec3(3, 0.5, 0) + 30 * along)};
  const double expected = 8.0 * 2.0 * 60.0;
  EXPECT_NEAR(volume(face, select_muscles(face, {6.0, 0.0}, 1.0).at(0)), expected, 0.08 * expected);
}

TEST(SelectMuscles, SharesAnElementBetweenTheSidesThatMeetInIt) {
  FaceAnatomy face = thick_sheet(39);  // a column across the midline, 80 / 39 mm wide
  const Vec3 outward = -Vec3::UnitX();
  face.muscle_paths = {{"M",
                        "",
                        {{Side::left, false, {{3, -2, -30}, {3, -2, 30}}, {outward, outward}},
                         {Side::right, false, {{3, 2, -30}, {3, 2, 30}}, {outward, outward}}},
                        4.0,
                        2.0}};
  const std::vector<Muscle> muscles = select_muscles(face, {6.0, 0.0}, 1.0);
  ASSERT_EQ(muscles.size(), 2U);
  std::size_t n_shared = 0;
  for (const Muscle& muscle : muscles) {
    for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
      if (std::abs(face.mesh.centroid(muscle.elements[i]).y()) > 0.1) continue;
      EXPECT_LT(muscle.shares[i], 0.5 + 1e-12);
      ++n_shared;
    }
  }
  EXPECT_GT(n_shared, 50U);
}

TEST(ElementParts, FillAnElement) {
  mesh::SheetOptions options;
  options.layers = {{"fat", 6.0, 3}};
  options.cells = mesh::SheetCells::right_half_wedges;
  const mesh::Mesh sheet = mesh::make_layered_sheet(options);
  for (const Index e : {Index{0}, to_index(sheet.n_elements() - 1)}) {
    double sum = 0.0;
    Vec3 moment = Vec3::Zero();
    for (const ElementPart& part : parts_of(sheet, e)) {
      sum += part.volume;
      moment += part.volume * part.middle;
    }
    EXPECT_NEAR(sum, mesh::element_volume(sheet, e, sheet.X()), 1e-12 * sum);
    EXPECT_LT((moment / sum - sheet.centroid(e)).norm(), 1e-9);
  }
}

TEST(SelectMuscles, LeavesOutElementsOfABandWithoutCompany) {
  FaceAnatomy face = thick_sheet();
  face.muscle_paths = {band(3.9, 0.5, {3, 0, -30}, {3, 0, 30})};
  const double diagonal = std::sqrt(2.0);
  const Vec3 outward = -Vec3::UnitX();
  // Another fibre about the middle of one element.
  face.muscle_paths[0].paths.push_back(
      {Side::middle,
       false,
       {{3, 21 - 0.1 * diagonal, 21}, {3, 21 + 0.1 * diagonal, 21}},
       {outward, outward}});
  EXPECT_EQ(select_muscles(face, {6.0, 0.0}, 1.0).at(0).elements.size(), 2U * 30U);
}

TEST(SelectMuscles, LeavesTheSkinOutOfABand) {
  FaceAnatomy face = thick_sheet();
  face.muscle_paths = {band(4.0, 4.0, {3, 0, -30}, {3, 0, 30})};
  std::vector<Index> outermost;
  for (Index e = 0; at(e) < face.mesh.n_elements(); ++e) {
    if (face.mesh.centroid(e).x() < 2.0) outermost.push_back(e);
  }
  face.mesh.set_elements("skin", outermost);
  EXPECT_EQ(select_muscles(face, {6.0, 0.0}, 1.0).at(0).elements.size(), 2U * 30U * 2U);
}

TEST(SelectMuscles, SaysWhichBandHasNoElements) {
  FaceAnatomy face = thick_sheet();
  face.muscle_paths = {band(4.0, 1.5, {3, 100, 0}, {3, 100, 20})};
  try {
    (void)select_muscles(face, {6.0, 0.0}, 1.0);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(
        error.what(),
        testing::HasSubstr("muscle M: no two neighbouring elements in its band of 4 x 1.5 mm"));
  }
}

TEST(SelectMuscles, RefusesMusclesWithoutElementsAllAtOnce) {
  FaceAnatomy face = sheet();
  face.muscle_paths = {{"A", "", {line(Side::left, {100, 0, 0}, {100, 0, 5})}},
                       {"B", "", {line(Side::middle, {1, 0, 0}, {1, 0, 5})}},
                       {"C", "", {}},
                       {"D", "", {line(Side::middle, {1, 0, 0}, {1, 0, 0})}}};
  try {
    (void)select_muscles(face, {6.0, 0.0}, 1.0);
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
