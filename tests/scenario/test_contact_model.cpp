// SPDX-License-Identifier: Apache-2.0
// Steps that open the jaw, who is excited by them, and a start in which nothing overlaps.
#include <algorithm>
#include <gmock/gmock.h>
#include <utility>

#include "mesh/surfaces.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/anatomy/sources.hpp"
#include "facies/mesh/nearest.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/scenario/bone_points.hpp"
#include "facies/scenario/contact_model.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"

namespace facies::scenario {
namespace {

anatomy::Jaw three_muscles() {
  anatomy::Jaw jaw;
  for (const char* name : {"lad", "rad", "lip"}) {
    anatomy::JawMuscle muscle;
    muscle.name = name;
    jaw.muscles.push_back(muscle);
  }
  jaw.exciters = {{"bi_ad", "both", {0, 1}}, {"open", "all", {0, 1, 2}}};
  return jaw;
}

TEST(Excite, ReachesTheMusclesOfAnExciter) {
  EXPECT_THAT(excite(three_muscles(), {{"bi_ad", 0.5}}, {}), testing::ElementsAre(0.5, 0.5, 0.0));
}

TEST(Excite, LeavesMusclesThatAreNotNamedAsTheyAre) {
  EXPECT_THAT(excite(three_muscles(), {{"lad", 0.0}}, {0.3, 0.4, 0.5}),
              testing::ElementsAre(0.0, 0.4, 0.5));
}

TEST(Excite, TakesTheMusclesOwnEntryThenTheLargestExciter) {
  EXPECT_THAT(excite(three_muscles(), {{"bi_ad", 0.2}, {"open", 0.6}, {"rad", 0.1}}, {}),
              testing::ElementsAre(0.6, 0.1, 0.6));
}

TEST(OpenJaw, IsReadAsAStepWithExcitations) {
  const Reading reading =
      read_text("jaw: free\nsteps:\n  - open_jaw: {bi_open: 1, lad: 0.5}\n", "x.yaml", "x", {});
  ASSERT_TRUE(reading.problems.empty());
  const auto& step = std::get<OpenJawStep>(reading.scenario.steps.at(0));
  EXPECT_EQ(step.excitations, (std::map<std::string, double>{{"bi_open", 1.0}, {"lad", 0.5}}));
}

TEST(OpenJaw, IsRefusedOnAFaceWithoutThatMuscle) {
  const Reading reading =
      read_text("jaw: free\nsteps:\n  - open_jaw: {bi_opn: 1}\n", "x.yaml", "x", {});
  const std::vector<Problem> problems =
      check_against_face(reading.scenario, {{"ZYG"}, {"bi_open", "lad"}});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].where, "x.yaml:3:16");
  EXPECT_THAT(problems[0].hint, testing::HasSubstr("did you mean 'bi_open'?"));
}

TEST(OpenJaw, IsRefusedWhereTheJawIsHeld) {
  const Reading reading =
      read_text("jaw: held\nsteps:\n  - open_jaw: {bi_open: 1}\n", "x.yaml", "x", {});
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].where, "x.yaml:3:5");
  EXPECT_THAT(reading.problems[0].hint, testing::HasSubstr("jaw: free"));
}

/// A patch of skin whose inner side partly lies in a box of bone.
class PatchOnABox : public ::testing::Test {
 protected:
  PatchOnABox() {
    const std::span<const Index> nodes = face_.mesh.nodes("inner");
    Vec3 centre = Vec3::Zero();
    for (const Index node : nodes)
      centre += face_.mesh.X()[at(node)] / static_cast<double>(nodes.size());
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 way((corner & 1) != 0 ? 4.0 : -0.6, (corner & 2) != 0 ? 5.0 : -5.0,
                     (corner & 4) != 0 ? 5.0 : -5.0);
      box_.surface.vertices.push_back(mechanics::Anchor::in_space(centre + way));
      corners_.push_back(centre + way);
    }
    box_.surface.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                              {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  }

  anatomy::FaceAnatomy face_ = anatomy::load_face("patch", data_folder());
  BoneObstacle box_;
  std::vector<Vec3> corners_;
};

TEST_F(PatchOnABox, HasContactPointsThatShareTheAreaOfTheInnerSurface) {
  double area = 0.0;
  for (const mechanics::ContactPoint& point : inner_points(face_, {}))
    area += point.area;
  double expected = 0.0;
  for (const mesh::Face& inner : face_.mesh.faces("inner"))
    expected += mesh::face_area(face_.mesh, inner, face_.mesh.X());
  EXPECT_NEAR(area, expected, 1e-9 * expected);
}

TEST_F(PatchOnABox, BeginsOutsideOfTheBoneAndNotNearerThanAsked) {
  const mesh::NearestTriangles nearest(corners_, box_.surface.triangles);
  const std::vector<mechanics::ContactPoint> points = inner_points(face_, {});
  const auto n_too_near = [&](const std::vector<Vec3>& u) {
    return std::count_if(points.begin(), points.end(), [&](const mechanics::ContactPoint& point) {
      return nearest.nearest(point.anchor.X + u[at(point.anchor.index)]).signed_distance() < 0.3;
    });
  };
  const std::vector<Vec3> nowhere(face_.mesh.n_nodes(), Vec3::Zero());
  ASSERT_GT(n_too_near(nowhere), 0) << "the case does not test what it should";
  const std::vector<Vec3> u = resolve_overlaps(face_, points, {box_}, 0.3);
  EXPECT_EQ(n_too_near(u), 0);
  for (const mechanics::ContactPoint& point : points) {
    if (nearest.nearest(point.anchor.X).signed_distance() > 0.31) {
      EXPECT_EQ(u[at(point.anchor.index)], Vec3::Zero());
    }
  }
}

TEST_F(PatchOnABox, IsRefusedWhereTheBoneIsInsideOut) {
  for (std::array<Index, 3>& triangle : box_.surface.triangles)
    std::swap(triangle[0], triangle[1]);
  try {
    (void)resolve_overlaps(face_, inner_points(face_, {}), {box_}, 0.3);
    FAIL() << "taken";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("on its inner side"));
  }
}

TEST_F(PatchOnABox, IsRefusedWhereTheBoneIsFarAway) {
  for (mechanics::Anchor& vertex : box_.surface.vertices)
    vertex.X *= 1000.0;
  try {
    (void)resolve_overlaps(face_, inner_points(face_, {}), {box_}, 0.3);
    FAIL() << "taken";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("mm from the tissue nearest to it"));
  }
}

/// What resolve_overlaps finds wrong with a bone; empty for nothing.
std::string told_of(const anatomy::FaceAnatomy& face, const BoneObstacle& bone, double distance) {
  try {
    (void)resolve_overlaps(face, inner_points(face, {}), {bone}, distance);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

/// The bone of a surface whose z axis looks out of the face, at a place behind the middle of the patch's inner side.
BoneObstacle behind(const anatomy::FaceAnatomy& face, const mesh::TriangleSurface& surface,
                    double how_far) {
  const std::span<const Index> nodes = face.mesh.nodes("inner");
  Vec3 centre = Vec3::Zero();
  for (const Index node : nodes)
    centre += face.mesh.X()[at(node)] / static_cast<double>(nodes.size());
  BoneObstacle bone;
  bone.surface.name = "blade";
  for (const Vec3& x : surface.X) {
    const Vec3 turned(-x.z(), -x.x(), x.y());
    bone.surface.vertices.push_back(
        mechanics::Anchor::in_space(centre + how_far * Vec3::UnitX() + turned));
  }
  bone.surface.triangles = surface.triangles;
  return bone;
}

double largest(const std::vector<Vec3>& u) {
  double largest = 0.0;
  for (const Vec3& move : u)
    largest = std::max(largest, move.norm());
  return largest;
}

// Scanned bones have thin parts whose walls run through each other: the nearest triangle is that of the far wall.
TEST(ResolveOverlaps, LeavesTissueBesideAThinBladeWhereItIs) {
  const anatomy::FaceAnatomy face = anatomy::load_face("patch", data_folder());
  // With another part of the bone beside the patch, in front of it: the blade alone would be behind all tissue.
  const mesh::TriangleSurface blade = mesh::together(
      mesh::blade(10.0, 2, 0.01, 0.1), mesh::box(0.1 * Vec3::Ones()), {25.0, 0.0, 4.0});
  const BoneObstacle bone = behind(face, blade, 2.0);
  const std::vector<mechanics::ContactPoint> points = inner_points(face, {});
  std::vector<Vec3> X;
  for (const mechanics::Anchor& vertex : bone.surface.vertices)
    X.push_back(vertex.X);
  const mesh::NearestTriangles nearest(X, blade.triangles);
  ASSERT_TRUE(std::ranges::any_of(points, [&](const mechanics::ContactPoint& point) {
    return nearest.nearest(point.anchor.X).is_inside;
  })) << "the case does not test what it should";
  EXPECT_EQ(largest(resolve_overlaps(face, points, {bone}, 0.3)), 0.0);
}

// A plate in the tissue, 2 mm above its inner side: nodes below it are in no bone and near to none.
TEST(ResolveOverlaps, TakesTissueFromTheFarSideOfAThinPlateWithoutAnElementInsideOut) {
  const anatomy::FaceAnatomy face = anatomy::load_face("patch:fat=3", data_folder());
  const double half = 7.3;
  const double above = 2.0;
  const BoneObstacle bone = behind(face, mesh::box({half, half, 0.1}), -above);
  const std::vector<mechanics::ContactPoint> points = inner_points(face, {});
  const std::vector<Vec3> u = resolve_overlaps(face, points, {bone}, 0.3);
  Vec3 centre = Vec3::Zero();
  for (const mechanics::Anchor& vertex : bone.surface.vertices)
    centre += vertex.X / 8.0;
  int n_below = 0;
  for (const mechanics::ContactPoint& point : points) {
    const Vec3 from = point.anchor.X - centre;
    const Vec3& move = u[at(point.anchor.index)];
    if (from.tail<2>().cwiseAbs().maxCoeff() > half) {
      EXPECT_EQ(move, Vec3::Zero());
    } else {
      ++n_below;
      EXPECT_LE((from + move).x(), -0.4) << "in front of the plate and 0.3 mm away from it";
      EXPECT_NEAR(move.x(), -(above + 0.4), 0.01);
    }
  }
  EXPECT_GT(n_below, 3);
  for (const Index node : face.mesh.nodes("outer"))
    EXPECT_EQ(u[at(node)], Vec3::Zero()) << "the skin's surface stays";
}

TEST(ResolveOverlaps, RefusesABoneThatElementsWouldBeTurnedInsideOutBy) {
  const anatomy::FaceAnatomy face = anatomy::load_face("patch:fat=3", data_folder());
  // The box ends 0.1 mm below the skin's surface; 0.3 mm away from it a node is in front of the skin.
  const BoneObstacle bone = behind(face, mesh::box({9.9, 9.9, 10.0}), 5.6);
  EXPECT_THAT(told_of(face, bone, 0.3), testing::HasSubstr("it is inside out once its nodes"));
}

// A sheet that leans: about half of the patch's inner side is behind its plane, of that a part beside the sheet.
TEST(ResolveOverlaps, TakesTissueFromBehindAnOpenSheetButNotFromBesideIt) {
  const anatomy::FaceAnatomy face = anatomy::load_face("patch", data_folder());
  const double half = 8.3;
  const double lean = 0.05;
  mesh::TriangleSurface sheet{{}, {{0, 1, 2}, {0, 2, 3}}};
  for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}})
    sheet.X.emplace_back(x, y, lean * x);
  BoneObstacle bone = behind(face, sheet, 0.01);
  bone.closed = false;
  Vec3 centre = Vec3::Zero();
  for (const mechanics::Anchor& vertex : bone.surface.vertices)
    centre += vertex.X / 4.0;
  const Vec3 normal = Vec3(-1.0, lean, 0.0).normalized();
  const std::vector<mechanics::ContactPoint> points = inner_points(face, {});
  const std::vector<Vec3> u = resolve_overlaps(face, points, {bone}, 0.3);
  int n_behind = 0;
  int n_beside = 0;
  for (const mechanics::ContactPoint& point : points) {
    const Vec3 from = point.anchor.X - centre;
    const Vec3& move = u[at(point.anchor.index)];
    if (from.cwiseAbs().tail<2>().maxCoeff() > half + 0.5) {
      EXPECT_EQ(move, Vec3::Zero());
      if (normal.dot(from) < 0.0) ++n_beside;
    } else {
      EXPECT_GE(normal.dot(from + move), 0.3);
      if (normal.dot(from) < 0.0) ++n_behind;
    }
  }
  EXPECT_GT(n_behind, 2);
  EXPECT_GT(n_beside, 2);
}

/// A patch of skin, and below the middle of it a bone with four faces whose tip looks up.
class PatchOverATip : public ::testing::Test {
 protected:
  [[nodiscard]] mechanics::ContactSurface tip(double depth) const {
    const std::span<const Index> nodes = face_.mesh.nodes("inner");
    double inwards = -1e9;  // +x is inwards
    for (const Index node : nodes)
      inwards = std::max(inwards, face_.mesh.X()[at(node)].x());
    const Vec3 top(inwards + depth, 0.7, 0.4);
    mechanics::ContactSurface bone{"bone", {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(6, 3, 0), Vec3(6, -2, 2), Vec3(6, -2, -2)})
      bone.vertices.push_back(mechanics::Anchor::in_space(top + way));
    return bone;
  }

  anatomy::FaceAnatomy face_ = anatomy::load_face("patch", data_folder());
};

TEST_F(PatchOverATip, IsPressedByAllVerticesWhichShareTheAreaOfTheBone) {
  const mechanics::ContactSurface bone = tip(2.0);
  const auto points = bone_points(face_.mesh, {}, bone, 1.0);
  ASSERT_EQ(points.size(), 4U);
  double expected = 0.0;
  for (const auto& [a, b, c] : bone.triangles) {
    expected += 0.5 * (bone.vertices[at(b)].X - bone.vertices[at(a)].X)
                          .cross(bone.vertices[at(c)].X - bone.vertices[at(a)].X)
                          .norm();
  }
  double area = 0.0;
  for (const mechanics::ContactPoint& point : points)
    area += point.area;
  EXPECT_NEAR(area, expected, 1e-12 * expected);
}

TEST_F(PatchOverATip, IsNotPressedByAVertexThatBeginsInItOrTooNear) {
  EXPECT_EQ(bone_points(face_.mesh, {}, tip(-0.5), 1.0).size(), 3U);
  EXPECT_EQ(bone_points(face_.mesh, {}, tip(0.2), 1.0).size(), 3U);
  EXPECT_EQ(bone_points(face_.mesh, {}, tip(0.4), 1.0).size(), 4U);
}

TEST_F(PatchOverATip, IsPressedWhereItsNodesGoFirst) {
  const std::vector<Vec3> outwards(face_.mesh.n_nodes(), Vec3(-1.0, 0.0, 0.0));
  EXPECT_EQ(bone_points(face_.mesh, outwards, tip(-0.5), 1.0).size(), 4U);
}

TEST_F(PatchOverATip, HasAnInnerSurfaceThatLooksInwards) {
  const mechanics::ContactSurface inner =
      tissue_surface(face_.mesh, face_.mesh.faces("inner"), "inner");
  EXPECT_EQ(inner.vertices.size(), face_.mesh.nodes("inner").size());
  for (const auto& [a, b, c] : inner.triangles) {
    const Vec3 normal = (inner.vertices[at(b)].X - inner.vertices[at(a)].X)
                            .cross(inner.vertices[at(c)].X - inner.vertices[at(a)].X);
    EXPECT_GT(normal.x(), 0.0);
  }
}

}  // namespace
}  // namespace facies::scenario
