// SPDX-License-Identifier: Apache-2.0
// The patch: a small face with everything a scenario's steps need.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <set>

#include <gtest/gtest.h>

#include "facies/anatomy/patch.hpp"
#include "facies/mesh/quality.hpp"

namespace facies::anatomy {
namespace {

using testing::HasSubstr;

TEST(Patch, HasTheThreeLayersOfAFace) {
  const FaceAnatomy face = make_patch("");
  std::size_t n = 0;
  for (const std::string& layer : layer_names()) {
    EXPECT_FALSE(face.mesh.elements(layer).empty()) << layer;
    n += face.mesh.elements(layer).size();
  }
  EXPECT_EQ(n, face.mesh.n_elements());
  EXPECT_EQ(face.axes.size(), face.mesh.n_elements());
  EXPECT_FALSE(face.is_reference_face);
}

TEST(Patch, HasTheVolumeOfItsOptions) {
  const FaceAnatomy face =
      make_patch("width=30,height=20,skin=2,fat=8,ny=6,nz=5,wedges=checkerboard");
  const mesh::QualityReport report = mesh::quality(face.mesh, face.mesh.X());
  EXPECT_NEAR(report.volume, 30.0 * 20.0 * 10.0, 1e-9);
  EXPECT_NEAR(report.sets.at("skin").volume, 30.0 * 20.0 * 2.0, 1e-9);
  EXPECT_NEAR(report.sets.at("hypodermis_mid").volume, 30.0 * 20.0 * 4.0, 1e-9);
  EXPECT_GT(report.n_wedge, 0U);
  EXPECT_GT(report.n_hex, 0U);
}

TEST(Patch, CanBeHeldReleasedAndPulled) {
  const FaceAnatomy face = make_patch("");
  const auto& mesh = face.mesh;
  EXPECT_TRUE(std::ranges::includes(mesh.nodes("held_in_tension"), mesh.nodes("inner")));
  EXPECT_TRUE(std::ranges::includes(mesh.nodes("held_in_tension"), mesh.nodes("rim")));
  // The release frees inner nodes that the rim does not hold.
  std::vector<Index> released;
  std::ranges::set_difference(mesh.nodes("held_in_tension"), mesh.nodes("rim"),
                              std::back_inserter(released));
  EXPECT_EQ(released.size(), 49U);
  const std::vector<Muscle> muscles = select_muscles(face, {6.0, 0.0}, 1.1);
  ASSERT_EQ(muscles.size(), 2U);
  EXPECT_EQ(muscles[0].name, "STRIP_L");
  EXPECT_EQ(muscles[1].name, "STRIP_R");
  EXPECT_EQ(muscles[0].elements.size(), muscles[1].elements.size());
  for (const Muscle& muscle : muscles) {
    for (const Vec3& direction : muscle.directions)
      EXPECT_NEAR(std::abs(direction.z()), 1.0, 1e-12);
  }
}

TEST(Patch, HasLandmarksOnItsSkinInTheirPlaces) {
  const FaceAnatomy face = make_patch("");
  const auto position = [&](const std::string& name) {
    const auto found = std::ranges::find(face.landmarks, name, &Landmark::name);
    return face.mesh.X()[at(found->node)];
  };
  EXPECT_LT(position("CENTER").norm(), 1e-12);
  EXPECT_LT((position("LEFT") - Vec3(0, -10, 0)).norm(), 1e-12);
  EXPECT_LT((position("RIGHT") - Vec3(0, 10, 0)).norm(), 1e-12);
  for (const LandmarkPair& pair : face.pairs)
    EXPECT_GT((position(pair.a) - position(pair.b)).norm(), 1.0);
}

TEST(Patch, TurnsItsSkinDirectionFromHorizontalTowardsUp) {
  for (const double degrees : {0.0, 30.0, 90.0}) {
    const FaceAnatomy face = make_patch("skin_direction=" + std::to_string(degrees));
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    for (const Index e : face.mesh.elements("skin")) {
      const Mat3& axes = face.axes[at(e)];
      EXPECT_LT((axes.col(0) - Vec3(0, std::cos(angle), std::sin(angle))).norm(), 1e-12);
      EXPECT_LT((axes.col(1) + Vec3::UnitX()).norm(), 1e-12);
    }
  }
}

TEST(Patch, BendsWithItsMuscleInside) {
  for (const char* shape : {"cylinder", "sphere"}) {
    const FaceAnatomy face = make_patch(std::string("shape=") + shape + ",radius=40");
    EXPECT_TRUE(mesh::check_geometry(face.mesh).empty()) << shape;
    EXPECT_EQ(select_muscles(face, {6.0, 0.0}, 1.0).size(), 2U) << shape;
  }
}

TEST(Patch, IsTheOneThatItsUsageShows) {
  const std::string usage = patch_usage();
  ASSERT_TRUE(usage.starts_with("patch:"));
  const FaceAnatomy shown = make_patch(usage.substr(6));
  const FaceAnatomy plain = make_patch("");
  ASSERT_EQ(shown.mesh.n_nodes(), plain.mesh.n_nodes());
  for (std::size_t n = 0; n < plain.mesh.n_nodes(); ++n)
    EXPECT_EQ(shown.mesh.X()[n], plain.mesh.X()[n]);
}

/// What is told about these options.
std::string refusal(const std::string& options) {
  try {
    (void)make_patch(options);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Patch, RefusesAllWrongOptionsAtOnce) {
  const std::string told = refusal("widh=3,ny=2,skin=-1,shape=shpere,fat=nan,nz=8,nz=9,,height");
  EXPECT_THAT(told, HasSubstr("patch:widh: unknown option\n    did you mean 'width'?"));
  EXPECT_THAT(told, HasSubstr("patch:ny: '2'; expected a whole number from 4 to 400"));
  EXPECT_THAT(told, HasSubstr("patch:skin: '-1'; expected a number from"));
  EXPECT_THAT(told, HasSubstr("did you mean 'sphere'?"));
  EXPECT_THAT(told, HasSubstr("patch:fat: 'nan'"));
  EXPECT_THAT(told, HasSubstr("patch:nz: given twice"));
  EXPECT_THAT(told, HasSubstr("patch:height: ''"));
}

TEST(Patch, RefusesShapesThatCannotBe) {
  EXPECT_THAT(refusal("shape=sphere,radius=10"), HasSubstr("radius"));
  EXPECT_THAT(refusal("shape=cylinder,width=500,radius=20"), HasSubstr("radius"));
  EXPECT_THAT(refusal("ny=400,nz=400,fat_layers=20"), HasSubstr("elements"));
}

}  // namespace
}  // namespace facies::anatomy
