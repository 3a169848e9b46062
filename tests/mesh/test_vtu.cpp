// SPDX-License-Identifier: Apache-2.0
// What can be seen in the bytes. That an independent reader gets the right numbers out of them: check_vtu.py.
#include <filesystem>
#include <gmock/gmock.h>

#include "mesh/shapes.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/mesh/vtu.hpp"

namespace facies::mesh {
namespace {

using ::testing::HasSubstr;

TEST(Vtu, GivesTheSameBytesForTheSameContent) {
  const Mesh mesh = shaken_checkerboard(0.1);
  const std::vector<Field> fields{vector_field("X_mm", mesh.X())};
  EXPECT_EQ(to_vtu(mesh, mesh.X(), fields, {}), to_vtu(mesh, mesh.X(), fields, {}));
}

TEST(Vtu, NamesComponentsOfTensorsAndTypesOfNumbers) {
  const Mesh mesh = single_element(CellType::hex8);
  const std::vector<Field> cell_fields{
      tensor_field("sigma_kPa", std::vector<Sym3<double>>(1)),
      scalar_field("J", std::vector<double>{1.0}, NumberType::float64),
      integer_field("layer", std::vector<int>{2}, NumberType::uint8),
      integer_field("number", std::vector<int>{-7})};
  const std::string vtu = to_vtu(mesh, mesh.X(), {}, cell_fields);
  EXPECT_THAT(vtu, HasSubstr("type=\"Float32\" Name=\"sigma_kPa\" NumberOfComponents=\"6\" "
                             "ComponentName0=\"XX\" ComponentName1=\"YY\" ComponentName2=\"ZZ\" "
                             "ComponentName3=\"XY\" ComponentName4=\"YZ\" ComponentName5=\"XZ\""));
  EXPECT_THAT(vtu, HasSubstr("type=\"Float64\" Name=\"J\""));
  EXPECT_THAT(vtu, HasSubstr("type=\"UInt8\" Name=\"layer\""));
  EXPECT_THAT(vtu, HasSubstr("type=\"Int32\" Name=\"number\""));
}

TEST(Vtu, EscapesNames) {
  const Mesh mesh = single_element(CellType::hex8);
  const std::vector<Field> fields{scalar_field("a<b & \"c\"", std::vector<double>{1.0})};
  EXPECT_THAT(to_vtu(mesh, mesh.X(), {}, fields), HasSubstr("\"a&lt;b &amp; &quot;c&quot;\""));
}

TEST(Vtu, RefusesFieldsThatDoNotFit) {
  const Mesh mesh = single_element(CellType::hex8);
  const auto write = [&](const Field& field) {
    return to_vtu(mesh, mesh.X(), {}, std::vector<Field>{field});
  };
  EXPECT_NO_THROW((void)write(scalar_field("J", std::vector<double>{1.0})));
  EXPECT_THROW((void)write(scalar_field("J", std::vector<double>{1.0, 2.0})), BugError);
  EXPECT_THROW((void)write(scalar_field("", std::vector<double>{1.0})), BugError);
  EXPECT_THROW((void)write(integer_field("layer", std::vector<int>{256}, NumberType::uint8)),
               BugError);
  EXPECT_THROW((void)write(scalar_field("layer", std::vector<double>{0.5}, NumberType::int32)),
               BugError);
  const std::vector<Field> twice(2, scalar_field("J", std::vector<double>{1.0}));
  EXPECT_THROW((void)to_vtu(mesh, mesh.X(), {}, twice), BugError);
  EXPECT_THROW((void)to_vtu(mesh, mesh.X().first(7), {}, {}), BugError);
}

TEST(Pvd, ListsFilesWithTimesAndRemarks) {
  const std::vector<SeriesEntry> entries{{0.0, "fields/0000.vtu", "rest"},
                                         {1.5, "fields/a&b.vtu", "step 2 smile--open -"}};
  EXPECT_EQ(to_pvd(entries),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <!-- rest -->\n"
            "    <DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"fields/0000.vtu\"/>\n"
            "    <!-- step 2 smile- -open - -->\n"
            "    <DataSet timestep=\"1.5\" group=\"\" part=\"0\" file=\"fields/a&amp;b.vtu\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}

TEST(Vtu, IsWrittenWholeOrNotAtAll) {
  const Mesh mesh = single_element(CellType::hex8);
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "facies_test_vtu";
  std::filesystem::remove_all(folder);
  EXPECT_THROW(write_vtu(folder / "a.vtu", mesh, mesh.X(), {}, {}), UsageError);
  std::filesystem::create_directories(folder);
  write_vtu(folder / "a.vtu", mesh, mesh.X(), {}, {});
  EXPECT_EQ(read_file(folder / "a.vtu"), to_vtu(mesh, mesh.X(), {}, {}));
  write_pvd(folder / "a.pvd", std::vector<SeriesEntry>{{0.0, "a.vtu", ""}});
  EXPECT_THAT(read_file(folder / "a.pvd"), HasSubstr("file=\"a.vtu\""));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace facies::mesh
