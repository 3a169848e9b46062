// SPDX-License-Identifier: Apache-2.0
// Drawings of surfaces, and what is told about wrong ones.
#include <fstream>
#include <gmock/gmock.h>

#include "support/temporary_folder.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/anatomy/cage.hpp"

namespace facies::anatomy {
namespace {

using support::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The cage of a drawing with this text, and what is told about it.
struct Reading {
  explicit Reading(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "drawing.json") << text;
    cage = read_cage(folder.path() / "drawing.json", problems);
    for (const Problem& problem : problems.list())
      told += to_string(problem) + "\n";
  }

  Problems problems;
  std::string told;
  Cage cage;
};

/// A right half of 2 x 1 squares of 10 mm beside the midline.
const char* const half = R"({
 "unit": "mm",
 "rows": {"a": [[0, 20, 5], [10, 20, 5]], "b": [[0, 10, 5], [10, 10, 5]], "c": [[0, 0, 5], [10, 0, 5]]},
 "sheets": [["a", "b", "c"]],
 "mirrored": true
})";

/// `half` with one piece of text in the place of another.
std::string with(const std::string& old, const std::string& other) {
  std::string text = half;
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return text.replace(place, old.size(), other);
}

Vec3 area_of(const Cage& cage) {
  Vec3 area = Vec3::Zero();
  for (const auto& quad : cage.net.quads) {
    const auto x = [&](std::size_t k) { return cage.points[at(quad.at(k))]; };
    area += 0.5 * (x(2) - x(0)).cross(x(3) - x(1));
  }
  return area;
}

TEST(Cage, PutsTheAxesOfADrawingIntoThoseOfAFace) {
  const Reading drawn(half);
  ASSERT_EQ(drawn.told, "");
  // Lateral is the subject's right (+y), up is +z, forward is -x.
  EXPECT_EQ(drawn.cage.points[at(drawn.cage.index.at("a.1"))], Vec3(-5.0, 10.0, 20.0));
}

TEST(Cage, HasATwinForEveryPointBesideTheMidline) {
  const Cage cage = Reading(half).cage;
  EXPECT_EQ(cage.net.n_vertices, 9);
  EXPECT_EQ(cage.net.quads.size(), 4U);
  for (std::size_t i = 0; i < cage.points.size(); ++i) {
    const Index twin = cage.mirrored[i];
    EXPECT_EQ(cage.mirrored[at(twin)], to_index(i));
    const Vec3& x = cage.points[i];
    EXPECT_EQ(cage.points[at(twin)], Vec3(x.x(), -x.y(), x.z()));
    EXPECT_EQ(at(twin) == i, x.y() == 0.0) << cage.names[i];
  }
  EXPECT_EQ(cage.mirrored[at(cage.index.at("b.1"))], cage.index.at("b.1-left"));
}

TEST(Cage, LooksAwayFromTheMeanOfItsPointsHoweverItIsDrawn) {
  const std::string ridge = with("[[0, 10, 5], [10, 10, 5]]", "[[0, 10, 15], [10, 10, 15]]");
  std::string upwards = ridge;
  upwards.replace(upwards.find(R"(["a", "b", "c"])"), 15, R"(["c", "b", "a"])");
  for (const std::string& text : {ridge, upwards}) {
    const Reading drawn(text);
    ASSERT_EQ(drawn.told, "");
    EXPECT_LT((area_of(drawn.cage) - Vec3(-400.0, 0.0, 0.0)).norm(), 1e-12);
  }
}

TEST(Cage, JoinsListsOfPointsByBandsAndSingleQuadrilaterals) {
  const Reading drawn(R"({
    "unit": "mm", "about": "a square ring around a square hole, with one corner filled in from outside",
    "rows": {"in": [[1, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0]],
             "out": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]],
             "far": [[4, -1, 0], [3, -1, 0], [4, 0, 0]]},
    "rings": [["in.0:3", ["out.0", "out.1:3"]]],
    "strips": [["out.0:1", ["far.1", "far.0"]]],
    "quads": [["out.1", "far.0", "far.2", "out.2"]]})");
  ASSERT_EQ(drawn.told, "");
  EXPECT_EQ(drawn.cage.net.quads.size(), 6U);
  // By the shoelace formula: 9 - 1 for the ring, 2 for the strip, 2 for the last one.
  EXPECT_NEAR(area_of(drawn.cage).norm(), 8.0 + 2.0 + 2.0, 1e-12);
}

TEST(Cage, LeavesOutWhatASheetIsWithout) {
  const Reading drawn(
      with(R"("mirrored")", R"("without": ["b.0"], "strips": [["b.0:1", "c.0:1"]], "mirrored")"));
  EXPECT_EQ(drawn.told, "");
  EXPECT_EQ(drawn.cage.net.quads.size(), 4U);
}

TEST(PointsOfRange, CountForwardsAndBackwards) {
  const Cage cage = Reading(half).cage;
  Problems problems;
  const auto names = [&](const std::string& range) {
    std::vector<std::string> found;
    for (const Index point : points_of_range(cage, range, "here", problems))
      found.push_back(cage.names[at(point)]);
    return found;
  };
  EXPECT_THAT(names("a.0:1"), ElementsAre("a.0", "a.1"));
  EXPECT_THAT(names("a.1:0"), ElementsAre("a.1", "a.0"));
  EXPECT_THAT(names("c.1"), ElementsAre("c.1"));
  EXPECT_TRUE(problems.empty());
  for (const char* wrong : {"a", "a.", "a.x", "a.0:1:2", "a.-1:0", "a.b.0", "", "a.0:4000000000"})
    EXPECT_TRUE(names(wrong).empty()) << wrong;
  EXPECT_EQ(problems.size(), 8U);
}

TEST(Cage, NamesThePointThatAFaceDoesNotFind) {
  EXPECT_THAT(
      Reading(with(R"("mirrored")", R"("quads": [["a.0", "a.1", "b.1", "b.2"]], "mirrored")")).told,
      AllOf(HasSubstr("drawing.json/quads/0: b.2; expected a point"),
            HasSubstr("did you mean 'b.0'?")));
  EXPECT_THAT(Reading(with(R"("b", "c"]])", R"("b", "d"]])")).told,
              AllOf(HasSubstr("/sheets/0: d; expected a row"), HasSubstr("known: a, b, c")));
  EXPECT_THAT(Reading(with(R"("mirrored")", R"("without": ["z.9"], "mirrored")")).told,
              HasSubstr("/without: z.9; expected a point"));
}

TEST(Cage, SaysWhereItIsNoSurface) {
  const auto told = [](const std::string& more) {
    return Reading(with(R"("mirrored")", more + R"(, "mirrored")")).told;
  };
  EXPECT_THAT(told(R"("quads": [["a.0", "a.1", "b.1", "b.0"], ["a.0", "a.1", "b.1", "b.0"]])"),
              AllOf(HasSubstr("more than two quadrilaterals (a."), HasSubstr("look through")));
  EXPECT_THAT(told(R"("quads": [["a.0", "a.1", "a.0", "b.0"]])"), HasSubstr("vertex twice (a.0)"));
  EXPECT_THAT(Reading(with("[10, 0, 5]]}", "[10, 0, 5]], \"d\": [[1, 2, 3]]}")).told,
              HasSubstr("a vertex has no quadrilateral (d.0)"));
  EXPECT_THAT(Reading(with(R"("sheets": [["a", "b", "c"]],)", "")).told,
              HasSubstr("no quadrilateral; expected a surface"));
}

// The surface of a cube: a smooth surface cannot pass through just any points at its corners.
TEST(Cage, RefusesANetThatNoSmoothSurfaceCanFollow) {
  EXPECT_THAT(Reading(R"({"unit": "mm", "rows": {"a": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
    "b": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}, "rings": [["a.0:3", "b.0:3"]],
    "quads": [["a.0:3"], ["b.0:3"]]})")
                  .told,
              HasSubstr("no smooth surface through its points can follow"));
}

TEST(Cage, ExplainsEveryWrongEntry) {
  EXPECT_THAT(Reading(with("[10, 20, 5]", "[10, \"20\", 5]")).told,
              AllOf(HasSubstr("/rows/a/1: '[10,\"20\",5]'"), HasSubstr("three numbers")));
  EXPECT_THAT(Reading(with("[10, 20, 5]", "[10, 20]")).told, HasSubstr("/rows/a/1"));
  EXPECT_THAT(Reading(with(R"({"a":)", R"({"z": 7, "a":)")).told,
              HasSubstr("/rows/z: '7'; expected a list"));
  EXPECT_THAT(Reading(with(R"("mm")", R"("cm")")).told,
              HasSubstr("/unit: \"cm\"; expected \"mm\""));
  EXPECT_THAT(Reading(with(R"("unit": "mm",)", "")).told, HasSubstr("/unit: null"));
  EXPECT_THAT(Reading(with("true", "1")).told, HasSubstr("/mirrored: '1'; expected true or false"));
  EXPECT_THAT(Reading(with(R"("sheets")", R"("sheet")")).told,
              AllOf(HasSubstr("/sheet: unknown key"), HasSubstr("did you mean 'sheets'?")));
  EXPECT_THAT(Reading(with(R"(["a", "b", "c"])", "3")).told, HasSubstr("/sheets/0: '3'"));
  EXPECT_THAT(Reading(with(R"(["a", "b", "c"])", "[1, 2]")).told, HasSubstr("a name in quotes"));
  EXPECT_THAT(Reading(with(R"("mirrored")", R"("strips": [["a.0:1", "b.0"]], "mirrored")")).told,
              HasSubstr("/strips/0/1: 1 points; expected 2, as many as in the list before"));
  EXPECT_THAT(Reading(with(R"("mirrored")", R"("quads": [["a.0:1"]], "mirrored")")).told,
              HasSubstr("/quads/0: 2 points; expected four"));
  EXPECT_THAT(Reading("[1, 2]").told, HasSubstr("one object in { }"));
}

TEST(Cage, TellsLineAndColumnOfWhatIsNoJson) {
  EXPECT_THAT(Reading("{\n \"unit\" \"mm\"\n}").told, HasSubstr("drawing.json:2:"));
  EXPECT_THAT(Reading("").told, HasSubstr("drawing.json:1:1: no JSON from here on"));
  EXPECT_THAT(Reading(std::string("{\"unit\": \"\xff\"}")).told, HasSubstr("drawing.json:1:"));
  EXPECT_THAT(Reading(with("[10, 20, 5]", "[10, 1e999, 5]")).told, HasSubstr("drawing.json"));
  Problems problems;
  EXPECT_TRUE(read_cage("/nowhere/drawing.json", problems).names.empty());
  EXPECT_THAT(to_string(problems.list().at(0)), HasSubstr("/nowhere/drawing.json"));
}

TEST(Cage, IsEmptyWhereAnythingIsWrong) {
  const Reading wrong(with("[10, 20, 5]", "[10, 20]"));
  EXPECT_TRUE(wrong.cage.names.empty());
  EXPECT_TRUE(wrong.cage.net.quads.empty());
}

}  // namespace
}  // namespace facies::anatomy
