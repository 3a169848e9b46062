// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "facies/mesh/layered_sheet.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

using ::testing::HasSubstr;

std::string message_of(const SheetOptions& options) {
  try {
    (void)make_layered_sheet(options);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

class EverySheet : public ::testing::TestWithParam<std::tuple<SheetShape, SheetCells>> {
 protected:
  SheetOptions options() const {
    SheetOptions made;
    made.shape = std::get<0>(GetParam());
    made.cells = std::get<1>(GetParam());
    made.size_y = 60.0;
    made.n_y = 7;
    made.layers[1].n_elements = 2;
    return made;
  }
};

INSTANTIATE_TEST_SUITE_P(
    Sheets, EverySheet,
    ::testing::Combine(::testing::Values(SheetShape::flat, SheetShape::cylinder,
                                         SheetShape::sphere),
                       ::testing::Values(SheetCells::hexahedra, SheetCells::wedges,
                                         SheetCells::checkerboard, SheetCells::right_half_wedges)));

TEST_P(EverySheet, IsSound) {
  const Mesh mesh = make_layered_sheet(options());
  EXPECT_TRUE(check_geometry(mesh).empty());
  EXPECT_EQ(mesh.n_nodes(), 8U * 9U * 5U);
  std::size_t in_layers = 0;
  for (const SheetLayer& layer : options().layers)
    in_layers += mesh.elements(layer.name).size();
  EXPECT_EQ(in_layers, mesh.n_elements());
}

TEST_P(EverySheet, HasNoFaceInsideThatIsUsedOnce) {
  // Outer, inner and four sides; a mismatch of a hexahedron and a wedge would add faces.
  const Mesh mesh = make_layered_sheet(options());
  const std::size_t sides = 2U * (7U + 8U) * 4U;
  EXPECT_EQ(boundary_faces(mesh).size(),
            mesh.faces("outer").size() + mesh.faces("inner").size() + sides);
}

TEST_P(EverySheet, LooksForwardWithItsOuterSurface) {
  const Mesh mesh = make_layered_sheet(options());
  for (const Vec3& normal : face_normals(mesh, mesh.faces("outer"), mesh.X())) {
    EXPECT_LT(normal.x(), 0.0);
  }
  for (const Vec3& normal : face_normals(mesh, mesh.faces("inner"), mesh.X())) {
    EXPECT_GT(normal.x(), 0.0);
  }
  const auto outer = face_set_nodes(mesh, mesh.faces("outer"));
  EXPECT_TRUE(std::ranges::equal(outer, mesh.nodes("outer")));
  const auto inner = face_set_nodes(mesh, mesh.faces("inner"));
  EXPECT_TRUE(std::ranges::equal(inner, mesh.nodes("inner")));
}

TEST_P(EverySheet, HasTheNodesOfItsFourSidesAsRim) {
  const Mesh mesh = make_layered_sheet(options());
  EXPECT_EQ(mesh.nodes("y_min").size(), 9U * 5U);
  EXPECT_EQ(mesh.nodes("y_max").size(), 9U * 5U);
  EXPECT_EQ(mesh.nodes("z_min").size(), 8U * 5U);
  EXPECT_EQ(mesh.nodes("z_max").size(), 8U * 5U);
  EXPECT_EQ(mesh.nodes("rim").size(), 2U * (7U + 8U) * 5U);
  for (const Index n : mesh.nodes("y_max"))
    EXPECT_GT(mesh.X()[at(n)].y(), 15.0);
  for (const Index n : mesh.nodes("z_min"))
    EXPECT_LT(mesh.X()[at(n)].z(), -10.0);
}

TEST(LayeredSheet, HasTheVolumeOfItsShape) {
  SheetOptions options;
  options.n_y = options.n_z = 40;
  options.size_y = options.size_z = 80.0 * std::numbers::pi / 2.0;
  const auto volume = [&](SheetShape shape) {
    options.shape = shape;
    const Mesh mesh = make_layered_sheet(options);
    return quality(mesh, mesh.X()).volume;
  };
  const double R = 80.0;
  const double r = R - 11.5;
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(volume(SheetShape::flat), options.size_y * options.size_z * 11.5, 1e-6);
  const double cylinder = pi * (R * R - r * r) / 4.0 * options.size_z;
  EXPECT_NEAR(volume(SheetShape::cylinder), cylinder, 1e-3 * cylinder);
  const double sphere = 4.0 / 3.0 * pi * (R * R * R - r * r * r) / 6.0;
  EXPECT_NEAR(volume(SheetShape::sphere), sphere, 1e-3 * sphere);
}

TEST(LayeredSheet, PutsTheMiddleOfItsOuterSurfaceAtTheOrigin) {
  for (const SheetShape shape : {SheetShape::flat, SheetShape::cylinder, SheetShape::sphere}) {
    SheetOptions options;
    options.shape = shape;
    const Mesh mesh = make_layered_sheet(options);
    EXPECT_LT(mesh.X()[4 * 9 + 4].norm(), 1e-13);
  }
}

TEST(LayeredSheet, MixesCellsAsAsked) {
  SheetOptions options;
  options.cells = SheetCells::right_half_wedges;
  const Mesh mesh = make_layered_sheet(options);
  for (Index e = 0; at(e) < mesh.n_elements(); ++e) {
    EXPECT_EQ(mesh.element(e).type == CellType::wedge6, mesh.centroid(e).y() > 0.0);
  }
}

TEST(LayeredSheet, NamesEveryOptionThatMakesNoSense) {
  SheetOptions options;
  options.size_y = -1.0;
  options.size_z = std::numeric_limits<double>::quiet_NaN();
  options.n_y = 0;
  options.n_z = 2'000'000;
  options.layers = {{"skin", 0.0, 1}, {"skin", 1.0, -2}, {"", 1.0, 1}};
  const std::string message = message_of(options);
  EXPECT_THAT(message, HasSubstr("layered sheet: size_y: -1 mm"));
  EXPECT_THAT(message, HasSubstr("layered sheet: size_z: nan mm"));
  EXPECT_THAT(message, HasSubstr("layered sheet: n_y: 0"));
  EXPECT_THAT(message, HasSubstr("layered sheet: n_z: 2000000"));
  EXPECT_THAT(message, HasSubstr("layered sheet: layer 1 'skin' thickness: 0 mm"));
  EXPECT_THAT(message, HasSubstr("layered sheet: layer 2 'skin': a name used before"));
  EXPECT_THAT(message, HasSubstr("layered sheet: layer 2 'skin' n_elements: -2"));
  EXPECT_THAT(message, HasSubstr("layered sheet: layer 3 '': no name"));
}

TEST(LayeredSheet, RefusesTooMuchCurvatureTooManyElementsAndNoLayer) {
  SheetOptions options;
  options.shape = SheetShape::cylinder;
  options.radius = 11.5;
  EXPECT_THAT(message_of(options), HasSubstr("radius: 11.5 mm; expected more than the thickness"));
  options.radius = 12.0;
  EXPECT_THAT(message_of(options),
              HasSubstr("size: 40 mm on a radius of 12 mm; expected at most 37.6991"));
  options.radius = -5.0;
  EXPECT_THAT(message_of(options), HasSubstr("radius: -5 mm"));
  options = {};
  options.n_y = options.n_z = 5000;
  EXPECT_THAT(message_of(options), HasSubstr("elements; expected at most"));
  options = {};
  options.layers.clear();
  EXPECT_THAT(message_of(options), HasSubstr("layers: none"));
}

}  // namespace
}  // namespace facies::mesh
