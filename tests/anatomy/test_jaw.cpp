// SPDX-License-Identifier: Apache-2.0
// The jaw that tables describe: on a small one, and on that of the tables that ship.
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "anatomy/reference_face.hpp"
#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/jaw_tables.hpp"

namespace facies::anatomy {
namespace {

using testing::ElementsAre;

TEST(Jaw, IsWhatItsTablesSay) {
  const SyntheticFace files;
  const Jaw jaw = files.read().jaw.value();
  ASSERT_EQ(jaw.mandible, 1);
  const Bone& mandible = jaw.bones.at(1);
  EXPECT_EQ(mandible.name, "jaw");
  EXPECT_FALSE(jaw.bones.at(0).moves);
  EXPECT_DOUBLE_EQ(mandible.mass, 0.2);
  EXPECT_EQ(mandible.centre, Vec3(30, 0, 10));
  EXPECT_EQ(mandible.inertia(0, 1), 1.0);
  EXPECT_EQ(mandible.inertia(2, 1), 2.0);
  EXPECT_EQ(mandible.inertia(2, 0), 3.0);
  const JawMuscle& muscle = jaw.muscles.at(1);
  EXPECT_EQ(muscle.side, Side::right);
  EXPECT_EQ(muscle.insertion.bone, 1);
  EXPECT_DOUBLE_EQ(muscle.max_force, 190400.0);
  EXPECT_EQ(jaw.attached_nodes, "mandibular");
}

TEST(Jaw, MovesItsOwnPointsAndNoOthers) {
  const SyntheticFace files;
  const Jaw jaw = files.read().jaw.value();
  // 90 degrees about y through the centre, then 2 mm up: from 10 mm in front of the centre to 10 mm above it.
  const JawPoint& lower = *find_named(jaw.points, "lower");
  EXPECT_TRUE(place_of(jaw, jaw.intercuspal, lower.at).isApprox(Vec3(30, 0, 22), 1e-12));
  EXPECT_EQ(place_of(jaw, jaw.start, lower.at), Vec3(20, 0, 10));
  EXPECT_EQ(place_of(jaw, jaw.intercuspal, find_named(jaw.points, "upper")->at), Vec3(20, 0, 14));
  EXPECT_DOUBLE_EQ(distance(jaw, jaw.start, "lower", "upper"), 4.0);
  EXPECT_EQ(find_named(jaw.points, "chin"), nullptr);
  EXPECT_THROW((void)distance(jaw, jaw.start, "lower", "chin"), BugError);
}

TEST(Jaw, HasPathsAndPlanesWhereItsPointsAreInTheIntercuspalPose) {
  const SyntheticFace files;
  const Jaw jaw = files.read().jaw.value();
  // The condyle, 10 mm behind the centre, goes to 10 mm below it.
  const JawGuide& guide = jaw.guides.at(0);
  EXPECT_NEAR(guide.curve.x0, 30.0, 1e-12);
  EXPECT_NEAR(guide.curve.z0, 2.0, 1e-12);
  EXPECT_NEAR(view(guide.curve, {18, 4, -3}).distance, 0.0, 1e-12);
  const JawStop& bite = jaw.stops.at(0);
  EXPECT_TRUE(bite.plane.isApprox(Vec3(30, 0, 22.5), 1e-12));  // half a millimetre behind
  EXPECT_TRUE(bite.enabled);
  EXPECT_FALSE(jaw.stops.at(1).enabled);
}

TEST(Jaw, NamesTheFilesOfItsSurfacesBelowTheFace) {
  const SyntheticFace files;
  const Jaw jaw = files.read().jaw.value();
  EXPECT_EQ(jaw.surfaces.at(0).file, files.geometry("jaw.obj"));
  EXPECT_EQ(jaw.surfaces.at(0).scale, 1000.0);
  EXPECT_EQ(jaw.surfaces.at(0).bone, jaw.mandible);
}

TEST(Jaw, ListsTheMusclesOfAnExciterInTheOrderOfTheMuscles) {
  const SyntheticFace files;
  EXPECT_THAT(files.read().jaw->exciters.at(0).muscles, ElementsAre(0, 1));
}

/// The jaw of data/reference-face.
Jaw shipped_jaw() {
  Problems problems;
  Jaw jaw = read_jaw_tables(data_folder() / "reference-face", problems);
  problems.throw_if_any<DataError>();
  return jaw;
}

/// Names of the muscles of an exciter.
std::vector<std::string> muscles_of(const Jaw& jaw, const std::string& exciter) {
  std::vector<std::string> names;
  for (const Index muscle : find_named(jaw.exciters, exciter)->muscles)
    names.push_back(jaw.muscles.at(at(muscle)).name);
  return names;
}

TEST(JawTables, HaveFourteenMusclesOnEachSide) {
  const Jaw jaw = shipped_jaw();
  EXPECT_EQ(jaw.muscles.size(), 28U);
  EXPECT_EQ(std::ranges::count(jaw.muscles, Side::left, &JawMuscle::side), 14);
  EXPECT_EQ(std::ranges::count(jaw.muscles, Side::right, &JawMuscle::side), 14);
  for (const JawMuscle& muscle : jaw.muscles)
    EXPECT_EQ(muscle.name.front(), muscle.side == Side::left ? 'l' : 'r');
}

TEST(JawTables, HaveMusclesAtTheirBestInTheIntercuspalPose) {
  const Jaw jaw = shipped_jaw();
  for (const JawMuscle& muscle : jaw.muscles) {
    const double length = (place_of(jaw, jaw.intercuspal, muscle.origin) -
                           place_of(jaw, jaw.intercuspal, muscle.insertion))
                              .norm();
    EXPECT_NEAR(length, muscle.optimal_length, 2e-3) << muscle.name;
  }
}

TEST(JawTables, HaveNearlySymmetricMuscles) {
  const Jaw jaw = shipped_jaw();
  for (std::size_t m = 0; m < jaw.muscles.size(); m += 2) {
    const JawMuscle& left = jaw.muscles[m];
    const JawMuscle& right = jaw.muscles[m + 1];
    ASSERT_EQ(left.name.substr(1), right.name.substr(1));
    const Vec3 mirror(1, -1, 1);
    EXPECT_LE((left.origin.X - mirror.cwiseProduct(right.origin.X)).norm(), 0.4) << left.name;
    EXPECT_LE((left.insertion.X - mirror.cwiseProduct(right.insertion.X)).norm(), 0.4) << left.name;
    EXPECT_EQ(left.max_force, right.max_force);
  }
}

TEST(JawTables, HaveThePapersOpenersAndThoseOfTheCode) {
  const Jaw jaw = shipped_jaw();
  EXPECT_THAT(muscles_of(jaw, "paper_open"),
              ElementsAre("lsp", "rsp", "lip", "rip", "lad", "rad", "lpd", "rpd"));
  EXPECT_THAT(muscles_of(jaw, "bi_open_2014"),
              ElementsAre("lsp", "rsp", "lip", "rip", "lad", "rad"));
  EXPECT_THAT(muscles_of(jaw, "bi_open"), ElementsAre("lsp", "rsp", "lip", "rip", "lad", "rad",
                                                      "lam", "ram", "lpm", "rpm", "lgh", "rgh"));
}

TEST(JawTables, LetThePosteriorDigastricPullNothingThatMoves) {
  const Jaw jaw = shipped_jaw();
  for (const char* name : {"lpd", "rpd"}) {
    const JawMuscle& muscle = *find_named(jaw.muscles, name);
    EXPECT_FALSE(jaw.bones[at(muscle.origin.bone)].moves);
    EXPECT_FALSE(jaw.bones[at(muscle.insertion.bone)].moves);
  }
}

TEST(JawTables, HaveTheIncisorsAsFarApartAsMeasured) {
  const Jaw jaw = shipped_jaw();
  EXPECT_NEAR(distance(jaw, jaw.start, "lower_incisor", "upper_incisor"), 10.542, 1e-3);
  EXPECT_NEAR(distance(jaw, jaw.intercuspal, "lower_incisor", "upper_incisor"), 2.584, 1e-3);
}

TEST(JawTables, HaveAStartOffTheJointAndAnIntercuspalPoseOnIt) {
  const Jaw jaw = shipped_jaw();
  ASSERT_EQ(jaw.guides.size(), 2U);
  for (const JawGuide& guide : jaw.guides) {
    const BonePoint& condyle = jaw.points[at(guide.point)].at;
    // Measured from a polyline of twenty pieces, which lies up to 2 micrometres above the cubic.
    EXPECT_NEAR(view(guide.curve, place_of(jaw, jaw.start, condyle)).distance, 2.304, 3e-3);
    EXPECT_NEAR(view(guide.curve, place_of(jaw, jaw.intercuspal, condyle)).distance, 0.0, 1e-12);
  }
}

TEST(JawTables, HaveStopsAsFarAwayAsMeasured) {
  const Jaw jaw = shipped_jaw();
  // Those of the authors' program; it gives one bite for both sides, the right one is by hand from its points.
  const std::map<std::string, double> at_start{
      {"posterior_wall_left", 1.536}, {"posterior_wall_right", 1.536},
      {"lateral_wall_left", -0.022},  {"lateral_wall_right", 0.076},
      {"bite_left", 6.556},           {"bite_right", 6.498}};
  std::size_t n_enabled = 0;
  for (const JawStop& stop : jaw.stops) {
    const BonePoint& point = jaw.points[at(stop.point)].at;
    const auto distance_in = [&](const JawPose& pose) {
      return (place_of(jaw, pose, point) - stop.plane).dot(stop.normal);
    };
    EXPECT_NEAR(distance_in(jaw.intercuspal), 0.0, 1e-12) << stop.name;
    if (!stop.enabled) continue;
    ++n_enabled;
    EXPECT_NEAR(distance_in(jaw.start), at_start.at(stop.name), 2e-3) << stop.name;
  }
  EXPECT_EQ(n_enabled, at_start.size());
}

}  // namespace
}  // namespace facies::anatomy
