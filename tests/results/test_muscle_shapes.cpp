// SPDX-License-Identifier: Apache-2.0
#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/surface.hpp"
#include "facies/results/muscle_shapes.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {
namespace {

/// The sheet, 4 x 4 columns: a muscle of a row of elements, one of which is also another's.
class Muscles : public ::testing::Test {
 protected:
  Muscles() : subject_(*sheet_) {
    subject_.muscles = {{"A_L", {0, 1, 2}, "A", "first"},
                        {"A_R", {12, 13}, "A", "first"},
                        {"B", {1}, "B", "second"}};
  }

  static Camera front() {
    Camera camera;
    camera.mm_per_pixel = 0.25;
    return camera;
  }

  SheetSubject sheet_;
  Subject subject_;
};

TEST_F(Muscles, OfOneNameAreAGroupWithAColour) {
  const std::vector<MuscleGroup> groups = muscle_groups(subject_);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].name, "A");
  EXPECT_EQ(groups[0].meaning, "first");
  EXPECT_EQ(groups[0].parts.size(), 2U);
  EXPECT_NE(groups[0].colour, groups[1].colour);
}

TEST_F(Muscles, WithoutAGroupStandForThemselves) {
  const std::vector<MuscleGroup> groups = muscle_groups(*sheet_);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[1].name, "B");
}

TEST_F(Muscles, ThatShareAnElementShowItAsTheSmallerOne) {
  const std::vector<MuscleGroup> groups = muscle_groups(subject_);
  const mesh::Mesh& mesh = *subject_.mesh;
  const auto n_triangles = [&](std::span<const Index> elements) {
    return 2 * mesh::boundary_faces(mesh, elements).size();
  };
  const std::vector<MuscleShape> alone = muscle_shapes(groups, mesh, true);
  const std::vector<MuscleShape> together = muscle_shapes(groups, mesh, false);
  EXPECT_EQ(alone[0].surface().triangles.size(),
            n_triangles(std::vector<Index>{0, 1, 2}) + n_triangles(std::vector<Index>{12, 13}));
  EXPECT_EQ(together[0].surface().triangles.size(),
            n_triangles(std::vector<Index>{0, 2}) + n_triangles(std::vector<Index>{12, 13}));
  EXPECT_EQ(together[1].surface().triangles.size(), n_triangles(std::vector<Index>{1}));
  EXPECT_EQ(together[1].surface().colours.front(), groups[1].colour);
}

TEST_F(Muscles, AreNamedOnceWhereTheyAreSeen) {
  const std::vector<MuscleShape> shapes =
      muscle_shapes(muscle_groups(subject_), *subject_.mesh, false);
  const Camera camera = front();
  const auto everything = [](const Vec3&) { return true; };
  const std::vector<Dot> names = muscle_names(shapes, camera, everything);
  ASSERT_EQ(names.size(), 2U);
  EXPECT_NE(names[0].label, names[1].label);
  const auto nothing = [](const Vec3&) { return false; };
  EXPECT_TRUE(muscle_names(shapes, camera, nothing).empty());
}

TEST_F(Muscles, AreNamedOnTheSideThatMoreIsSeenOf) {
  subject_.muscles = {{"A_L", {0}, "A", ""}, {"A_R", {12}, "A", ""}};
  const mesh::Mesh& mesh = *subject_.mesh;
  const std::vector<MuscleShape> shapes = muscle_shapes(muscle_groups(subject_), mesh, false);
  const double left = mesh.centroid(0).y();
  const double right = mesh.centroid(12).y();
  ASSERT_GT(std::abs(left - right), 1.0);
  const Camera camera = front();
  for (const double seen : {left, right}) {
    const std::vector<Dot> names =
        muscle_names(shapes, camera, [&](const Vec3& x) { return std::abs(x.y() - seen) < 5.1; });
    ASSERT_EQ(names.size(), 1U);
    const double expected = camera.project({0.0, seen, 0.0}).x();
    EXPECT_NEAR(names[0].column, expected, 5.1 / camera.mm_per_pixel);
  }
}

TEST_F(Muscles, HaveEdgesWhereTheirFacesMeetAtARightAngle) {
  subject_.muscles = {{"A", {5}, "A", ""}};
  const std::vector<MuscleShape> shapes =
      muscle_shapes(muscle_groups(subject_), *subject_.mesh, false);
  for (const Vec3f& normal : shapes[0].surface().normals)
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0F, 1e-5F);
}

}  // namespace
}  // namespace facies::results
