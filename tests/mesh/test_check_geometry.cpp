// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <limits>

#include "mesh/shapes.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "facies/mesh/quality.hpp"

namespace facies::mesh {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(CheckGeometry, IsContentWithASoundMesh) {
  EXPECT_THAT(check_geometry(shaken_checkerboard(0.15)), IsEmpty());
}

TEST(CheckGeometry, FindsInvertedAndFlatElements) {
  const Mat3 mirror = Vec3(1.0, 1.0, -1.0).asDiagonal();
  const auto inverted = check_geometry(single_element(CellType::wedge6, mirror));
  ASSERT_EQ(inverted.size(), 1U);
  EXPECT_THAT(
      to_string(inverted[0]),
      HasSubstr("mesh element 0: wedge6 is inverted (scaled Jacobian -1 at a Gauss point)"));
  // Flat up to rounding: the determinant is tiny, not zero.
  const Mat3 R = support::Random(4).rotation();
  const Mat3 flat = R * Vec3(1.0, 1.0, 0.0).asDiagonal() * R.transpose();
  const auto problems = check_geometry(single_element(CellType::hex8, flat));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].found, HasSubstr("hex8 is flat"));
}

TEST(CheckGeometry, FindsCoordinatesThatAreNotFiniteAndNodesWithoutElement) {
  const Mesh cube = single_element(CellType::hex8);
  std::vector<Vec3> X(cube.X().begin(), cube.X().end());
  X[3].y() = std::numeric_limits<double>::quiet_NaN();
  X[5].z() = std::numeric_limits<double>::infinity();
  X.emplace_back(9.0, 9.0, 9.0);
  const auto problems = check_geometry(with_positions(cube, X));
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_THAT(to_string(problems[0]), HasSubstr("mesh node 3: coordinates -1, nan, -1"));
  EXPECT_THAT(to_string(problems[1]), HasSubstr("mesh node 5: coordinates 1, -1, inf"));
  EXPECT_THAT(to_string(problems[2]), HasSubstr("mesh node 8: belongs to no element"));
}

TEST(CheckGeometry, SpeaksOfNodesAndElementsAsTheirSourceDoes) {
  const Mesh cube = single_element(CellType::hex8, -Mat3::Identity());
  std::vector<Vec3> X(cube.X().begin(), cube.X().end());
  X.emplace_back(0.0, 0.0, 0.0);
  const auto problems =
      check_geometry(with_positions(cube, X),
                     {.node = [](Index n) { return fmt::format("face.node:{}", n + 1); },
                      .element = [](Index e) { return fmt::format("face.elem:{}", e + 1); }});
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].where, "face.node:9");
  EXPECT_EQ(problems[1].where, "face.elem:1");
}

TEST(CheckGeometry, CountsWhatIsTooMuchToList) {
  const Mesh sheet = make_layered_sheet({});
  std::vector<Vec3> mirrored(sheet.X().begin(), sheet.X().end());
  for (Vec3& X : mirrored)
    X.y() = -X.y();
  const auto problems = check_geometry(with_positions(sheet, mirrored));
  ASSERT_EQ(problems.size(), 22U);
  EXPECT_EQ(problems[20].found, "192 inverted or flat elements in all");
  EXPECT_THAT(problems[21].hint, HasSubstr("left-handed"));
}

TEST(CheckGeometry, RefusesAMeshWithoutElements) {
  ASSERT_EQ(check_geometry(Mesh()).size(), 1U);
  EXPECT_EQ(check_geometry(Mesh())[0].found, "no element");
}

TEST(CheckSize, RecognisesMetres) {
  const Mat3 face = Vec3(0.078, 0.084, 0.086).asDiagonal();
  const auto problems = check_size(single_element(CellType::hex8, face), 50.0, 500.0);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(to_string(problems[0]),
            "mesh: 0.172 mm from end to end; expected 50 to 500 mm\n"
            "    the coordinates look like metres: multiply them by 1000");
}

TEST(CheckSize, AcceptsWhatFitsAndGivesNoHintForWhatNoUnitExplains) {
  EXPECT_THAT(check_size(single_element(CellType::hex8, 80.0 * Mat3::Identity()), 50.0, 500.0),
              IsEmpty());
  const auto problems =
      check_size(single_element(CellType::hex8, 1e9 * Mat3::Identity()), 50.0, 500.0);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].hint, "");
}

}  // namespace
}  // namespace facies::mesh
