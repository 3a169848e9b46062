// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>

#include "mesh/shapes.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/quality.hpp"

namespace facies::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

ElementQuality of(const Mesh& mesh) {
  return element_quality(mesh, 0, mesh.X());
}

TEST(ElementQuality, OfABoxIsOneHoweverLongItIs) {
  const Mat3 stretch = Vec3(0.5, 3.0, 40.0).asDiagonal();
  const ElementQuality box =
      of(single_element(CellType::hex8, support::Random(1).rotation() * stretch));
  EXPECT_NEAR(box.scaled_jacobian_gauss, 1.0, 1e-12);
  EXPECT_NEAR(box.scaled_jacobian_corner, 1.0, 1e-12);
  EXPECT_NEAR(box.volume, 8.0 * 60.0, 1e-9);
}

TEST(ElementQuality, OfAShearedBoxIsTheCosineOfTheShear) {
  Mat3 shear = Mat3::Identity();
  shear(0, 2) = std::tan(0.7);
  const ElementQuality sheared = of(single_element(CellType::hex8, shear));
  EXPECT_NEAR(sheared.scaled_jacobian_gauss, std::cos(0.7), 1e-14);
  EXPECT_NEAR(sheared.scaled_jacobian_corner, std::cos(0.7), 1e-14);
  EXPECT_NEAR(sheared.volume, 8.0, 1e-13);
}

TEST(ElementQuality, OfAnEquilateralWedgeIsTheSineOfSixtyDegrees) {
  Mat3 equilateral = Mat3::Identity();
  equilateral(0, 1) = 0.5;
  equilateral(1, 1) = std::sqrt(0.75);
  const ElementQuality wedge = of(single_element(CellType::wedge6, equilateral));
  EXPECT_NEAR(wedge.scaled_jacobian_gauss, std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(wedge.volume, std::sqrt(0.75) / 2.0 * 2.0, 1e-14);
}

TEST(ElementQuality, IsNegativeInsideOutAndZeroWhenFlat) {
  const Mat3 mirror = Vec3(1.0, 1.0, -1.0).asDiagonal();
  const Mat3 flat = Vec3(1.0, 1.0, 0.0).asDiagonal();
  for (const CellType type : {CellType::hex8, CellType::wedge6}) {
    EXPECT_NEAR(of(single_element(type, mirror)).scaled_jacobian_gauss, -1.0, 1e-14);
    EXPECT_LT(of(single_element(type, mirror)).volume, 0.0);
    EXPECT_EQ(of(single_element(type, flat)).scaled_jacobian_gauss, 0.0);
  }
}

TEST(ElementQuality, SeesADentedCornerThatGaussPointsMiss) {
  // Corner 6 of the cube [-1,1]^3 moved by d along its diagonal: dX/dxi = 1 - d a 1 1^T with a = 1/2 at the corner and
  // (1 + 1/sqrt(3))^2 / 8 at the nearest Gauss point, so that its determinant is 1 - 3 d a.
  const Mesh cube = single_element(CellType::hex8);
  std::vector<Vec3> X(cube.X().begin(), cube.X().end());
  X[6] -= Vec3::Constant(0.9);
  const ElementQuality dented = of(with_positions(cube, X));
  const auto scaled = [](double b) {
    return (1.0 - 3.0 * b) / std::pow(1.0 - 2.0 * b + 3.0 * b * b, 1.5);
  };
  const double g = 1.0 / std::sqrt(3.0);
  EXPECT_NEAR(dented.scaled_jacobian_gauss, scaled(0.9 * (1.0 + g) * (1.0 + g) / 8.0), 1e-14);
  EXPECT_NEAR(dented.scaled_jacobian_corner, scaled(0.45), 1e-14);
  EXPECT_GT(dented.scaled_jacobian_gauss, 0.0);
  EXPECT_LT(dented.scaled_jacobian_corner, 0.0);
}

TEST(Quantile, IsLinearBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile({0.0, 10.0}, 0.05), 0.5);
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.95), 7.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(QualityReport, SumsUpALayeredSheet) {
  SheetOptions options;
  options.cells = SheetCells::right_half_wedges;
  const Mesh mesh = make_layered_sheet(options);
  const QualityReport report = quality(mesh, mesh.X());
  EXPECT_EQ(report.n_nodes, 4U * 81U);
  EXPECT_EQ(report.n_hex, 3U * 32U);
  EXPECT_EQ(report.n_wedge, 3U * 64U);
  EXPECT_NEAR(report.volume, 1600.0 * 11.5, 1e-8);
  EXPECT_EQ(report.lower, Vec3(0.0, -20.0, -20.0));
  EXPECT_EQ(report.upper, Vec3(11.5, 20.0, 20.0));
  EXPECT_THAT(report.inverted, IsEmpty());
  EXPECT_THAT(report.inverted_corners, IsEmpty());
  const ElementSetQuality& skin = report.sets.at("skin");
  EXPECT_EQ(skin.n_elements, 96U);
  EXPECT_NEAR(skin.volume, 2400.0, 1e-9);
  EXPECT_NEAR(skin.area.value(), 1600.0, 1e-9);
  EXPECT_NEAR(skin.mean_thickness.value(), 1.5, 1e-12);
  EXPECT_NEAR(skin.thickness.value().p05, 1.5, 1e-12);
  EXPECT_NEAR(report.sets.at("hypodermis_inner").thickness.value().p95, 5.0, 1e-12);
  EXPECT_THAT(report.worst, ::testing::SizeIs(10));
  EXPECT_NEAR(report.elements[at(report.worst[0])].scaled_jacobian_gauss, std::sqrt(0.5), 1e-12);
}

TEST(QualityReport, HasNoThicknessWithoutAnOuterSurface) {
  const Mesh mesh = make_layered_sheet({});
  const QualityReport report = quality(mesh, mesh.X(), {.outer = "nothing", .n_worst = 0});
  EXPECT_FALSE(report.sets.at("skin").area.has_value());
  EXPECT_FALSE(report.sets.at("skin").thickness.has_value());
  EXPECT_THAT(report.worst, IsEmpty());
}

TEST(QualityReport, ListsInvertedElementsOfDeformedPositions) {
  const Mesh mesh = make_layered_sheet({});
  std::vector<Vec3> x(mesh.X().begin(), mesh.X().end());
  const Index outer_node = mesh.element(0).nodes[4];
  for (const Index node : mesh.element(0).connectivity()) {
    if (node <= mesh.nodes("outer").back()) x[at(node)].x() += 4.0;  // skin is 1.5 mm thick
  }
  ASSERT_LE(outer_node, mesh.nodes("outer").back());
  const QualityReport report = quality(mesh, x);
  EXPECT_THAT(report.inverted, ::testing::Contains(0));
  EXPECT_EQ(report.worst[0], 0);
  EXPECT_LT(report.elements[0].volume, 0.0);
}

TEST(QualityReport, OfNothingIsEmpty) {
  const QualityReport report = quality(Mesh(), {});
  EXPECT_EQ(report.n_nodes, 0U);
  EXPECT_EQ(report.volume, 0.0);
}

}  // namespace
}  // namespace facies::mesh
