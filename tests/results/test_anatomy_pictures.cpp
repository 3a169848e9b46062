// SPDX-License-Identifier: Apache-2.0
// Cuts through known blocks, veils, bones that move: colours at places where they are known.
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/results/anatomy_pictures.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {
namespace {

using ::testing::ElementsAre;

Colour colour_at(const Image& image, int column, int row) {
  const std::uint8_t* p = image.rgb.data() + image.place(column, row);
  return {static_cast<float>(p[0]) / 255.0F, static_cast<float>(p[1]) / 255.0F,
          static_cast<float>(p[2]) / 255.0F};
}

void expect_colour(const Image& image, int column, int row, const Colour& expected) {
  const Colour found = colour_at(image, column, row);
  constexpr float rounding = 0.6F / 255.0F;
  EXPECT_NEAR(found.r, expected.r, rounding) << column << " " << row;
  EXPECT_NEAR(found.g, expected.g, rounding) << column << " " << row;
  EXPECT_NEAR(found.b, expected.b, rounding) << column << " " << row;
}

/// A closed box of bone.
BoneShape box(const std::string& name, const Vec3& lower, const Vec3& upper, Index body) {
  BoneShape bone;
  bone.name = name;
  bone.body = body;
  for (const int k : {0, 1, 2, 3, 4, 5, 6, 7})
    bone.surface.X.emplace_back((k & 1) != 0 ? upper.x() : lower.x(),
                                (k & 2) != 0 ? upper.y() : lower.y(),
                                (k & 4) != 0 ? upper.z() : lower.z());
  bone.surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return bone;
}

/// The sheet (skin x = 0 to 2 mm, fat to 8 mm, y and z from -20 to 20 mm) with a box of bone behind it that moves.
class Anatomy : public InFolder {
 protected:
  Anatomy() : subject_(*sheet_) {
    subject_.bodies = {{"jaw", {12.0, 0.0, 0.0}, 1.0, Mat3::Identity()}};
    subject_.bones = {box("jaw", {10.0, -5.0, -5.0}, {14.0, 5.0, 5.0}, 0)};
  }

  /// One pixel a millimetre: column 20 + x, row 30 - z of the cut at y = 0.
  static View cut() {
    View view{"cut", {}};
    view.camera.direction = Vec3::UnitY();
    view.camera.mm_per_pixel = 1.0;
    view.camera.width = 40;
    view.camera.height = 60;
    view.camera.target = {0.0, 0.1, 0.0};
    view.camera.cut = 0.0;
    return view;
  }

  [[nodiscard]] Image cut_open(const mechanics::State& state) const {
    const std::array<View, 1> views = {cut()};
    return Stage(subject_, 1).cut_open(state, views).front();
  }

  [[nodiscard]] mechanics::State as_read() const {
    return sheet_.affine("rest", 1, Mat3::Identity(), Vec3::Zero()).state;
  }

  SheetSubject sheet_;
  Subject subject_;
};

TEST_F(Anatomy, OfACutBlockShowsEveryLayerInItsColour) {
  const Image image = cut_open(as_read());
  for (const int row : {15, 30, 45}) {
    expect_colour(image, 18, row, {1.0F, 1.0F, 1.0F});
    expect_colour(image, 21, row, layer_colour(0));
    expect_colour(image, 23, row, layer_colour(1));
    expect_colour(image, 27, row, layer_colour(1));
  }
  expect_colour(image, 32, 30, palette::cut_bone);
  expect_colour(image, 32, 15, {1.0F, 1.0F, 1.0F});
  expect_colour(image, 21, 5, {1.0F, 1.0F, 1.0F});
}

TEST_F(Anatomy, FollowsTheDisplacementsOfTheTissue) {
  const Image image =
      cut_open(sheet_.affine("express", 2, Mat3::Identity(), {-10.0, 0.0, 0.0}).state);
  expect_colour(image, 11, 30, layer_colour(0));
  expect_colour(image, 17, 30, layer_colour(1));
  expect_colour(image, 21, 30, {1.0F, 1.0F, 1.0F});
}

TEST_F(Anatomy, CarriesABoneWithItsBody) {
  mechanics::State state = as_read();
  const Mat3 quarter = Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()).toRotationMatrix();
  state.bodies = {{{0.0, 0.0, -10.0}, quarter}};
  // About its centre (12, 0, 0): x -> 12 + z, z -> -10 - (x - 12).
  const Vec3 corner(14.0, 5.0, 5.0);
  EXPECT_LT((place_of(subject_, subject_.bones[0], state, corner) - Vec3(17.0, 5.0, -12.0)).norm(),
            1e-12);
  EXPECT_EQ(place_of(subject_, subject_.bones[0], as_read(), corner), corner);
  const Image image = cut_open(state);
  expect_colour(image, 32, 30, {1.0F, 1.0F, 1.0F});
  expect_colour(image, 35, 40, palette::cut_bone);
  expect_colour(image, 35, 45, {1.0F, 1.0F, 1.0F});
}

TEST_F(Anatomy, OfABoneInsideTissueShowsTheBone) {
  subject_.bones = {box("chip", {4.0, -5.0, -5.0}, {7.0, 5.0, 5.0}, -1)};
  const Image image = cut_open(as_read());
  expect_colour(image, 25, 30, palette::cut_bone);
  expect_colour(image, 23, 30, layer_colour(1));
  expect_colour(image, 25, 20, layer_colour(1));
}

TEST_F(Anatomy, HasNoInsideOfAnOpenSheetOfBone) {
  subject_.bones[0].is_solid = false;
  expect_colour(cut_open(as_read()), 32, 30, {1.0F, 1.0F, 1.0F});
}

TEST_F(Anatomy, DoesNotTakeTheFarSideOfAFoldForACut) {
  // The far box is turned inside out, as tissue is that has passed through itself: from outside it shows its inside.
  BoneShape inverted = box("fold", {10.0, 5.0, -5.0}, {14.0, 9.0, 5.0}, -1);
  for (std::array<Index, 3>& t : inverted.surface.triangles)
    std::swap(t[1], t[2]);
  subject_.bones = {inverted};
  const Colour found = colour_at(cut_open(as_read()), 32, 30);
  EXPECT_NE(found, (Colour{1.0F, 1.0F, 1.0F}));
  EXPECT_GT(std::abs(found.r - palette::cut_bone.r), 0.02F);
}

TEST_F(Anatomy, IsSeenThroughTheSkin) {
  View front{"front", {}};
  front.camera.mm_per_pixel = 1.0;
  front.camera.width = 60;
  front.camera.height = 60;
  const std::array<View, 1> views = {front};
  const Stage stage(subject_, 1);
  const Image image = stage.through_skin(as_read(), views).front();
  subject_.bones.clear();
  const Image skin_alone = Stage(subject_, 1).through_skin(as_read(), views).front();
  const auto difference = [&](int column, int row) {
    return std::abs(colour_at(image, column, row).b - colour_at(skin_alone, column, row).b);
  };
  EXPECT_GT(difference(30, 30), 0.1F);  // the box of 10 x 10 mm is in the middle
  EXPECT_EQ(difference(45, 30), 0.0F);
  EXPECT_NE(colour_at(skin_alone, 45, 30), (Colour{1.0F, 1.0F, 1.0F}));
  EXPECT_EQ(colour_at(skin_alone, 5, 30), (Colour{1.0F, 1.0F, 1.0F}));
}

TEST_F(Anatomy, IsDrawnForEveryStepWithTheSameBytesForAnyNumberOfThreads) {
  std::vector<Snapshot> snapshots = {
      sheet_.affine("release", 2, Mat3::Identity(), Vec3::Zero()),
      sheet_.affine("express", 3, Mat3::Identity(), {0.0, 0.0, 2.0})};
  PictureOptions options{"smile", "sheet", 120, 1};
  const std::vector<std::string> names =
      write_anatomy_pictures(subject_, snapshots, folder_, options);
  EXPECT_THAT(names, ElementsAre("02-release-bones.png", "02-release-section.png",
                                 "03-express-bones.png", "03-express-section.png"));
  std::vector<std::string> first;
  for (const std::string& name : names)
    first.push_back(read_file(folder_ / name));
  EXPECT_NE(first[1], first[3]);
  options.threads = 2;
  write_anatomy_pictures(subject_, snapshots, folder_, options);
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(read_file(folder_ / names[i]), first[i]) << names[i];
}

TEST_F(Anatomy, WithoutBonesHasNoPictureOfThem) {
  subject_.bones.clear();
  const std::vector<Snapshot> snapshots = {
      sheet_.affine("release", 2, Mat3::Identity(), Vec3::Zero())};
  EXPECT_THAT(write_anatomy_pictures(subject_, snapshots, folder_, {"smile", "sheet", 120, 1}),
              ElementsAre("02-release-section.png"));
  EXPECT_EQ(section_legend(subject_).size(), 2U);
}

}  // namespace
}  // namespace facies::results
