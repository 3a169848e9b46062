// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "mesh/shapes.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/mesh.hpp"

namespace facies::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<Problem> problems_of(std::vector<Vec3> X, std::vector<Element> elements) {
  try {
    const Mesh mesh(std::move(X), std::move(elements));
  } catch (const DataError& error) {
    return error.problems();
  }
  return {};
}

TEST(Mesh, NamesEveryElementThatUsesAMissingNode) {
  const std::vector<Vec3> X(8, Vec3::Zero());
  const std::vector<Problem> problems =
      problems_of(X, {{CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7}},
                      {CellType::wedge6, {0, 1, 2, 3, 4, 8, -1, -1}},
                      {CellType::hex8, {0, 1, 2, -5, 4, 5, 6, 7}}});
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(
      to_string(problems[0]),
      "mesh element 1 (wedge6): node 8, which does not exist; expected 8 nodes counted from 0");
  EXPECT_THAT(to_string(problems[1]), HasSubstr("mesh element 2 (hex8): node -5"));
}

TEST(Mesh, RefusesAnElementWithARepeatedNode) {
  const std::vector<Problem> problems =
      problems_of(std::vector<Vec3>(8, Vec3::Zero()), {{CellType::hex8, {0, 1, 2, 2, 4, 5, 6, 6}}});
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(to_string(problems[0]), HasSubstr("mesh element 0 (hex8): node 2 more than once"));
  EXPECT_THAT(problems[0].hint, HasSubstr("may be a wedge"));
}

TEST(Mesh, AcceptsWhatNamesItsNodesOnce) {
  EXPECT_THAT(problems_of(std::vector<Vec3>(8, Vec3::Zero()),
                          {{CellType::wedge6, {7, 6, 5, 4, 3, 2, -1, -1}}}),
              IsEmpty());
}

TEST(Mesh, ListsFaceNodesFromTheElementsOwnNumbers) {
  const Mesh mesh(std::vector<Vec3>(10, Vec3::Zero()),
                  {{CellType::wedge6, {9, 8, 7, 6, 5, 4, -1, -1}}});
  EXPECT_THAT(mesh.face_nodes({0, 0}), ElementsAre(9, 7, 8));
  EXPECT_THAT(mesh.face_nodes({0, 1}), ElementsAre(6, 5, 4));
  EXPECT_THAT(mesh.face_nodes({0, 2}), ElementsAre(9, 8, 5, 6));
}

TEST(Mesh, TakesTheMeanOfTheNodesAsCentroid) {
  const Vec3 shift(1.0, 2.0, 3.0);
  EXPECT_TRUE(single_element(CellType::hex8, Mat3::Identity(), shift).centroid(0).isApprox(shift));
  EXPECT_TRUE(single_element(CellType::wedge6).centroid(0).isApprox(Vec3(1.0, 1.0, 0.0) / 3.0));
}

TEST(Mesh, KeepsSetsSortedAndWithoutRepetitions) {
  Mesh mesh = single_element(CellType::hex8);
  mesh.set_nodes("rim", {5, 1, 5, 0});
  mesh.set_faces("outer", {{0, 3}, {0, 1}, {0, 3}});
  mesh.set_elements("skin", {0, 0});
  EXPECT_THAT(mesh.nodes("rim"), ElementsAre(0, 1, 5));
  EXPECT_THAT(mesh.faces("outer"), ElementsAre(Face{0, 1}, Face{0, 3}));
  EXPECT_THAT(mesh.elements("skin"), ElementsAre(0));
  mesh.set_nodes("rim", {2});
  EXPECT_THAT(mesh.nodes("rim"), ElementsAre(2));
}

TEST(Mesh, GivesAnEmptySetForAnUnknownName) {
  const Mesh mesh = single_element(CellType::hex8);
  EXPECT_THAT(mesh.nodes("nose"), IsEmpty());
  EXPECT_THAT(mesh.elements("nose"), IsEmpty());
  EXPECT_THAT(mesh.faces("nose"), IsEmpty());
}

TEST(Mesh, RefusesSetMembersThatDoNotExist) {
  Mesh mesh = single_element(CellType::wedge6);
  EXPECT_THROW(mesh.set_nodes("rim", {0, 6}), BugError);
  EXPECT_THROW(mesh.set_nodes("rim", {-1}), BugError);
  EXPECT_THROW(mesh.set_elements("skin", {1}), BugError);
  EXPECT_THROW(mesh.set_faces("outer", {{0, 5}}), BugError);
  EXPECT_THROW(mesh.set_faces("outer", {{1, 0}}), BugError);
  EXPECT_THAT(mesh.node_sets(), IsEmpty());
}

}  // namespace
}  // namespace facies::mesh
