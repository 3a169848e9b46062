// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <gmock/gmock.h>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/triangle_surface.hpp"

namespace facies::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Triangle = std::array<Index, 3>;

class ReadObj : public ::testing::Test {
 protected:
  TriangleSurface read(const std::string& content, double scale = 1.0) {
    const std::filesystem::path path = folder_.path() / "bone.obj";
    std::ofstream(path, std::ios::binary) << content;
    return read_obj(path, scale, problems_);
  }

  [[nodiscard]] std::string told() const {
    std::string all;
    for (const Problem& problem : problems_.list())
      all += to_string(problem) + "\n";
    return all;
  }

  /// What is said of a file with this line behind three vertices.
  std::string told_of(const std::string& line) {
    problems_ = {};
    const TriangleSurface surface = read("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + line + "\nf 1 2 3\n");
    EXPECT_THAT(surface.X, IsEmpty());
    EXPECT_THAT(surface.triangles, IsEmpty());
    EXPECT_THAT(problems_.list(), SizeIs(1));
    return told();
  }

  support::TemporaryFolder folder_;
  Problems problems_;
};

TEST_F(ReadObj, TakesVerticesTimesTheScaleAndTriangles) {
  const TriangleSurface surface =
      read("# a bone\r\nv 0.001 -2e-3 3\r\nv\t1 0 0\r\n\r\n  v 0 1 0 # the third\r\nf 3 1 2\r\n",
           1000.0);
  EXPECT_TRUE(problems_.empty()) << told();
  ASSERT_THAT(surface.X, SizeIs(3));
  EXPECT_LT((surface.X[0] - Vec3(1.0, -2.0, 3000.0)).norm(), 1e-12);
  EXPECT_EQ(surface.X[2], Vec3(0.0, 1000.0, 0.0));
  EXPECT_THAT(surface.triangles, ElementsAre(Triangle{2, 0, 1}));
}

TEST_F(ReadObj, TakesEveryFormOfAFace) {
  const TriangleSurface surface = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/2 3/3/3\n"
      "f -3 -2 -1\nv 0 0 1\nf -1//-1 -4 -2/7\n");
  EXPECT_TRUE(problems_.empty()) << told();
  EXPECT_THAT(surface.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2}, Triangle{0, 1, 2},
                          Triangle{0, 1, 2}, Triangle{3, 0, 2}));
}

TEST_F(ReadObj, CutsAPolygonIntoAFan) {
  const TriangleSurface surface =
      read("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 2 3 4 5 1\n");
  EXPECT_THAT(surface.triangles,
              ElementsAre(Triangle{1, 2, 3}, Triangle{1, 3, 4}, Triangle{1, 4, 0}));
}

TEST_F(ReadObj, TakesFacesBeforeTheirVertices) {
  const TriangleSurface surface = read("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_TRUE(problems_.empty()) << told();
  EXPECT_THAT(surface.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST_F(ReadObj, PassesOverWhatIsNoGeometryOfASurface) {
  const TriangleSurface surface = read(
      "mtllib a.mtl\no bone\ng left right\nusemtl ivory\ns off\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\n"
      "v 0 1 0\nvn 0 0 1\nvt 0 0\nl 1 2\np 1\nf 1 2 3\n");
  EXPECT_TRUE(problems_.empty()) << told();
  EXPECT_THAT(surface.X, SizeIs(3));
}

TEST_F(ReadObj, SaysWhereALineIsWrong) {
  EXPECT_THAT(told_of("v 1 2"), HasSubstr("bone.obj:4: a vertex of 2 numbers; expected x y z"));
  EXPECT_THAT(told_of("v 1 2x 3"), HasSubstr("bone.obj:4:5: '2x'; expected a finite number"));
  EXPECT_THAT(told_of("v 1 2 nan"), HasSubstr("bone.obj:4:7: 'nan'; expected a finite number"));
  EXPECT_THAT(told_of("f 1 2"), HasSubstr("bone.obj:4: a face of 2 vertices; expected at least 3"));
  EXPECT_THAT(told_of("f 1 2 a"), HasSubstr("bone.obj:4:7: 'a'; expected a vertex number"));
  EXPECT_THAT(told_of("f 1 2/x 3"), HasSubstr("bone.obj:4:5: '2/x'; expected a vertex number"));
  EXPECT_THAT(told_of("f 1 2/1/1/1 3"), HasSubstr("bone.obj:4:5: '2/1/1/1'"));
  EXPECT_THAT(told_of("f 1 /2 3"), HasSubstr("bone.obj:4:5: '/2'"));
  EXPECT_THAT(told_of("f 1 0 3"), HasSubstr("bone.obj:4:5: vertex 0; expected 1 to 3"));
  EXPECT_THAT(told_of("f 1 2 4"), HasSubstr("bone.obj:4:7: vertex 4; expected 1 to 3"));
  EXPECT_THAT(told_of("f 1 2 99999999999"), HasSubstr("vertex 99999999999; expected 1 to 3"));
  EXPECT_THAT(told_of("f 1 2 -4"),
              HasSubstr("bone.obj:4:7: vertex -4; expected one of the 3 above this line"));
  EXPECT_THAT(told_of("curv2 1 2 3"),
              HasSubstr("bone.obj:4:1: 'curv2'; expected a line of v or f"));
}

TEST_F(ReadObj, RefusesACoordinateThatOverflowsInMillimetres) {
  EXPECT_THAT(read("v 1e306 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1000.0).X, IsEmpty());
  EXPECT_THAT(told(), HasSubstr("bone.obj:1:3: '1e306'; expected a finite number"));
}

TEST_F(ReadObj, ReportsEverythingAtOnceButNotWithoutEnd) {
  std::string bad = "v a b 0\nv 0 0\nf 1 2\n";
  EXPECT_THAT(read(bad).X, IsEmpty());
  EXPECT_THAT(problems_.list(), SizeIs(4));
  problems_ = {};
  bad = "v 0 0 0\n";
  for (int i = 0; i < 500; ++i)
    bad += "f 1 2 3\n";
  EXPECT_THAT(read(bad).X, IsEmpty());
  EXPECT_THAT(problems_.list(), SizeIs(11));
  EXPECT_THAT(told(), HasSubstr("1000 unusable lines or numbers in all"));
}

TEST_F(ReadObj, RefusesAFileWithoutFaces) {
  EXPECT_THAT(read("v 0 0 0\n").X, IsEmpty());
  EXPECT_THAT(told(), HasSubstr("bone.obj: has no face; expected lines like 'f 1 2 3'"));
  problems_ = {};
  EXPECT_THAT(read("").X, IsEmpty());
  EXPECT_THAT(told(), HasSubstr("bone.obj: is empty"));
  EXPECT_THAT(problems_.list(), SizeIs(1));
}

TEST_F(ReadObj, RefusesAFileThatIsNotThere) {
  EXPECT_THAT(read_obj(folder_.path() / "none.obj", 1.0, problems_).X, IsEmpty());
  EXPECT_THAT(told(), HasSubstr("none.obj: no such file"));
}

}  // namespace
}  // namespace facies::mesh
