// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/atlas.hpp"
#include "facies/results/figure.hpp"
#include "facies/results/framing.hpp"

namespace facies::results {
namespace {

using ::testing::ElementsAre;

/// The sheet with a bone behind it and lines across its skin.
class AtlasOfASheet : public InFolder {
 protected:
  AtlasOfASheet() : subject_(*sheet_) {
    subject_.skin_lines.assign(subject_.mesh->n_elements(), Vec3::Zero());
    for (const Index e : subject_.mesh->elements("skin"))
      subject_.skin_lines[at(e)] = Vec3::UnitY();
    BoneShape bone;
    bone.name = "plate";
    bone.surface.X = {{12.0, -10.0, -10.0}, {12.0, 10.0, -10.0}, {12.0, 0.0, 10.0}};
    bone.surface.triangles = {{0, 1, 2}};
    bone.is_solid = false;
    subject_.bones = {bone};
  }

  SheetSubject sheet_;
  Subject subject_;
  PictureOptions options_{"", "sheet", 120, 1};
};

TEST_F(AtlasOfASheet, HasAPictureOfEveryKind) {
  const std::vector<std::string> names = write_atlas(subject_, folder_, options_);
  EXPECT_EQ(names, atlas_files());
  for (const std::string& name : names) {
    const Image image = read_png(read_file(folder_ / name), name);
    EXPECT_GT(image.width, 100) << name;
    EXPECT_GT(image.height, 100) << name;
  }
}

TEST_F(AtlasOfASheet, LeavesOutWhatTheFaceDoesNotHave) {
  subject_.bones.clear();
  subject_.muscles.clear();
  subject_.landmarks.clear();
  subject_.skin_lines.clear();
  EXPECT_THAT(write_atlas(subject_, folder_, options_),
              ElementsAre("overview.png", "skin.png", "layers.png"));
}

TEST_F(AtlasOfASheet, HasTheSameBytesForAnyNumberOfThreads) {
  const std::vector<std::string> names = write_atlas(subject_, folder_, options_);
  std::vector<std::string> first;
  for (const std::string& name : names)
    first.push_back(read_file(folder_ / name));
  options_.threads = 2;
  write_atlas(subject_, folder_, options_);
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(read_file(folder_ / names[i]), first[i]) << names[i];
}

TEST_F(AtlasOfASheet, DrawsSkinLinesInTheirColour) {
  write_atlas(subject_, folder_, options_);
  const auto n_dark_red = [&](const char* name) {
    const Image image = read_png(read_file(folder_ / name), name);
    int n = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
      n += image.rgb[i] > 90 && image.rgb[i + 1] < 60 && image.rgb[i + 2] < 60 ? 1 : 0;
    return n;
  };
  EXPECT_EQ(n_dark_red("skin.png"), 0);
  EXPECT_GT(n_dark_red("tension-lines.png"), 100);
}

TEST_F(AtlasOfASheet, NeedsAFolder) {
  EXPECT_THROW(write_atlas(subject_, folder_ / "missing", options_), UsageError);
}

TEST_F(AtlasOfASheet, LooksAtATransverseCutFromBelow) {
  const Camera camera = transverse_view(*subject_.mesh, {}, 100).camera;
  EXPECT_EQ(camera.cut, 0.0);
  EXPECT_EQ(camera.height, 100);
  EXPECT_NEAR(camera.target.z(), 0.0, 1e-9);
  // The front (-x) is on top, the right side (+y) on the left.
  EXPECT_LT(camera.project({-1.0, 0.0, 0.0}).y(), camera.project({1.0, 0.0, 0.0}).y());
  EXPECT_LT(camera.project({0.0, 1.0, 0.0}).x(), camera.project({0.0, -1.0, 0.0}).x());
  for (const Vec3& X : subject_.mesh->X()) {
    const Eigen::Vector2d place = camera.project(X);
    EXPECT_GT(place.minCoeff(), 0.0);
    EXPECT_LT(place.x(), camera.width);
    EXPECT_LT(place.y(), camera.height);
  }
}

}  // namespace
}  // namespace facies::results
