// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>

#include "mesh/shapes.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/columns.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

Mesh checkerboard() {
  SheetOptions options;
  options.cells = SheetCells::checkerboard;
  options.n_y = 3;
  options.n_z = 2;
  return make_layered_sheet(options);
}

TEST(Columns, KnowTheOppositeFace) {
  const Mesh hex = single_element(CellType::hex8);
  for (const auto& [a, b] : {std::pair(0, 1), {2, 4}, {3, 5}}) {
    const auto local = static_cast<std::uint8_t>(a);
    EXPECT_EQ(opposite_face(hex, {0, local}).local, b);
    EXPECT_EQ(opposite_face(hex, opposite_face(hex, {0, local})).local, a);
  }
  const Mesh wedge = single_element(CellType::wedge6);
  EXPECT_EQ(opposite_face(wedge, {0, 0}).local, 1);
  EXPECT_EQ(opposite_face(wedge, {0, 2}).element, -1);
}

TEST(Columns, ReachEveryElementOfASheetThroughItsOuterFace) {
  const Mesh mesh = checkerboard();
  const std::vector<Face> outward = outward_faces(mesh, mesh.faces("outer"));
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    EXPECT_EQ(outward[e], (Face{to_index(e), 1}));
  }
}

TEST(Columns, EndWhereThereIsNoOppositeFace) {
  // Entering a wedge by a quadrilateral leads nowhere.
  const Mesh mesh = single_element(CellType::wedge6);
  EXPECT_EQ(outward_faces(mesh, std::vector<Face>{{0, 2}})[0], (Face{0, 2}));
  EXPECT_EQ(outward_faces(mesh, {})[0].element, -1);
}

TEST(Columns, OfNodesRunStraightDown) {
  const Mesh mesh = checkerboard();
  const auto columns = node_columns(mesh, mesh.faces("outer"));
  ASSERT_EQ(columns.size(), 4U * 3U);
  for (const std::vector<Index>& column : columns) {
    ASSERT_EQ(column.size(), 4U);
    for (std::size_t i = 1; i < column.size(); ++i) {
      const Vec3 step = mesh.X()[at(column[i])] - mesh.X()[at(column[i - 1])];
      EXPECT_NEAR(step.x(), i == 1 ? 1.5 : 5.0, 1e-12);
      EXPECT_NEAR(step.norm(), step.x(), 1e-12);
    }
  }
}

TEST(ElementThickness, IsThatOfTheLayer) {
  const Mesh mesh = checkerboard();
  const std::vector<Face> outward = outward_faces(mesh, mesh.faces("outer"));
  for (const double t : element_thickness(mesh, mesh.elements("skin"), outward, mesh.X())) {
    EXPECT_NEAR(t, 1.5, 1e-12);
  }
  for (const double t :
       element_thickness(mesh, mesh.elements("hypodermis_inner"), outward, mesh.X())) {
    EXPECT_NEAR(t, 5.0, 1e-12);
  }
  const std::vector<Face> none(mesh.n_elements());
  EXPECT_TRUE(std::isnan(element_thickness(mesh, mesh.elements("skin"), none, mesh.X())[0]));
}

}  // namespace
}  // namespace facies::mesh
