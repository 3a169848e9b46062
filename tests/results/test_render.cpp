// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/results/render.hpp"

namespace facies::results {
namespace {

constexpr Colour skin{0.9F, 0.8F, 0.7F};

/// A sphere about the origin from octahedron faces cut into n^2 triangles. Its triangles are symmetric in y and z.
Surface sphere(float radius, int n) {
  Surface surface;
  const auto add_face = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto corner = [&](int i, int j) {
      const Vec3f direction = (static_cast<float>(n - i - j) * a + static_cast<float>(i) * b +
                               static_cast<float>(j) * c)
                                  .normalized();
      surface.positions.push_back(radius * direction);
      surface.normals.push_back(direction);
      surface.round.push_back(true);
      surface.colours.push_back(skin);
      return static_cast<std::uint32_t>(surface.positions.size() - 1);
    };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i + j < n; ++i) {
        surface.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
        if (i + j + 1 < n)
          surface.triangles.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
    }
  };
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float z : {-1.0F, 1.0F})
        add_face(x * Vec3f::UnitX(), y * Vec3f::UnitY(), z * Vec3f::UnitZ());
    }
  }
  return surface;
}

/// A square of side 2a at x = `depth`, facing -x.
Surface square(float a, float depth) {
  Surface surface;
  for (const auto& [y, z] : {std::pair{-a, -a}, {-a, a}, {a, a}, {a, -a}}) {
    surface.positions.emplace_back(depth, y, z);
    surface.normals.emplace_back(-Vec3f::UnitX());
    surface.round.push_back(false);
    surface.colours.push_back(skin);
  }
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

Camera front(int size, double mm_per_pixel) {
  Camera camera;
  camera.width = size;
  camera.height = size;
  camera.mm_per_pixel = mm_per_pixel;
  return camera;
}

const std::uint8_t* pixel(const Image& image, int column, int row) {
  return image.rgb.data() + static_cast<std::ptrdiff_t>(3) * (row * image.width + column);
}

bool is_white(const std::uint8_t* p) {
  return p[0] == 255 && p[1] == 255 && p[2] == 255;
}

int covered(const Image& image) {
  int n = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column)
      n += is_white(pixel(image, column, row)) ? 0 : 1;
  }
  return n;
}

TEST(Camera, SeesTheSubjectsRightOnTheLeftAndUpOnTop) {
  const Camera camera = front(200, 0.5);
  const Eigen::Vector2d place = camera.project({0.0, 20.0, 10.0});
  EXPECT_DOUBLE_EQ(place.x(), 60.0);
  EXPECT_DOUBLE_EQ(place.y(), 80.0);
}

TEST(Render, CoversTheAreaOfTheSilhouette) {
  const Image image = Scene(square(10.0F, 5.0F), 1).render(front(100, 0.5), {}, 1);
  EXPECT_EQ(covered(image), 40 * 40);
  EXPECT_FALSE(is_white(pixel(image, 30, 30)));
  EXPECT_TRUE(is_white(pixel(image, 29, 30)));
  EXPECT_FALSE(is_white(pixel(image, 69, 69)));
  EXPECT_TRUE(is_white(pixel(image, 70, 69)));
}

TEST(Render, ShowsASphereAsADiscOfItsRadius) {
  const Image image = Scene(sphere(20.0F, 12), 1).render(front(120, 0.5), {}, 1);
  // Pixels at the edge are partly covered: up to one pixel around the circle of radius 40.
  EXPECT_NEAR(covered(image), std::numbers::pi * 40.0 * 40.0, 2.0 * std::numbers::pi * 40.0);
}

TEST(Render, TheSilhouetteOfASymmetricBodyIsSymmetric) {
  const Image image = Scene(sphere(20.0F, 6), 1).render(front(120, 0.5), {}, 1);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width / 2; ++column) {
      EXPECT_EQ(is_white(pixel(image, column, row)),
                is_white(pixel(image, image.width - 1 - column, row)));
      EXPECT_EQ(is_white(pixel(image, column, row)),
                is_white(pixel(image, column, image.height - 1 - row)));
    }
  }
}

TEST(Render, DrawsRoundWhatIsRound) {
  // An octahedron's silhouette is a square of area 2 r^2; rounded towards the sphere it comes nearer to pi r^2.
  Surface flat = sphere(40.0F, 1);
  flat.round.assign(flat.round.size(), false);
  const int flat_area = covered(Scene(flat, 1).render(front(100, 1.0), {}, 1));
  const int round_area = covered(Scene(sphere(40.0F, 1), 1).render(front(100, 1.0), {}, 1));
  EXPECT_NEAR(flat_area, 2.0 * 40.0 * 40.0, 200.0);
  EXPECT_GT(round_area, 1.1 * flat_area);
  EXPECT_LT(round_area, std::numbers::pi * 40.0 * 40.0);
}

TEST(Render, ColoursValuesByTheScaleAndLeavesTheRestNatural) {
  Surface surface = square(10.0F, 0.0F);
  const ColourScale scale{ColourMap::cool_warm, -1.0, 1.0};
  surface.values = {1.0F, 1.0F, 1.0F, 1.0F};
  const Image warm = Scene(surface, 1).render(front(40, 1.0), scale, 1);
  EXPECT_GT(pixel(warm, 20, 20)[0], 2 * pixel(warm, 20, 20)[2]);
  surface.values = {-1.0F, -1.0F, -1.0F, -1.0F};
  const Image cool = Scene(surface, 1).render(front(40, 1.0), scale, 1);
  EXPECT_GT(pixel(cool, 20, 20)[2], 2 * pixel(cool, 20, 20)[0]);
  surface.values.assign(4, std::numeric_limits<float>::quiet_NaN());
  const Image none = Scene(surface, 1).render(front(40, 1.0), scale, 1);
  surface.values.clear();
  EXPECT_EQ(none.rgb, Scene(surface, 1).render(front(40, 1.0), scale, 1).rgb);
}

TEST(Render, DarkensWhatIsSheltered) {
  // A floor far behind a small roof: its middle sees less of the sky than the same floor without the roof.
  Surface open = square(10.0F, 10.0F);
  Surface roofed = open;
  const Surface roof = square(30.0F, 8.0F);
  for (std::size_t i = 0; i < 4; ++i) {
    roofed.positions.push_back(roof.positions[i]);
    roofed.normals.push_back(roof.normals[i]);
    roofed.round.push_back(false);
    roofed.colours.push_back(skin);
  }
  roofed.triangles.push_back({4, 5, 6});
  roofed.triangles.push_back({4, 6, 7});
  // Seen from behind, the floor hides the roof.
  Camera behind = front(40, 1.0);
  behind.direction = -Vec3::UnitX();
  const Image bright = Scene(open, 1).render(behind, {}, 1);
  const Image dark = Scene(roofed, 1).render(behind, {}, 1);
  EXPECT_LT(pixel(dark, 20, 20)[0] + 20, pixel(bright, 20, 20)[0]);
}

TEST(Render, GivesTheSameBytesEveryTimeAndForAnyNumberOfThreads) {
  const Surface surface = sphere(20.0F, 9);
  const Image one = Scene(surface, 1).render(front(150, 0.4), {}, 1);
  EXPECT_EQ(one.rgb, Scene(surface, 1).render(front(150, 0.4), {}, 1).rgb);
  EXPECT_EQ(one.rgb, Scene(surface, 2).render(front(150, 0.4), {}, 2).rgb);
  EXPECT_EQ(one.rgb, Scene(surface, 3).render(front(150, 0.4), {}, 3).rgb);
}

TEST(Render, MakesSmoothEdges) {
  const Image image = Scene(square(10.1F, 0.0F), 1).render(front(60, 0.9), {}, 1);
  int partly = 0;
  const int inside = pixel(image, 30, 30)[2];
  for (int column = 0; column < image.width; ++column) {
    const int value = pixel(image, column, 30)[2];
    partly += value > inside + 5 && value < 250 ? 1 : 0;
  }
  EXPECT_EQ(partly, 2);
}

TEST(Scene, KnowsWhatTheCameraSees) {
  const Scene scene(sphere(20.0F, 12), 1);
  EXPECT_TRUE(scene.sees(front(10, 1.0), {-20.0, 0.0, 0.0}, 0.5));
  EXPECT_FALSE(scene.sees(front(10, 1.0), {20.0, 0.0, 0.0}, 0.5));
}

TEST(Scene, RefusesListsThatDoNotFit) {
  Surface surface = square(1.0F, 0.0F);
  surface.triangles.push_back({0, 1, 4});
  EXPECT_THROW(Scene(surface, 1), BugError);
  surface = square(1.0F, 0.0F);
  surface.normals.pop_back();
  EXPECT_THROW(Scene(surface, 1), BugError);
  surface = square(1.0F, 0.0F);
  surface.values = {1.0F};
  EXPECT_THROW(Scene(surface, 1), BugError);
}

TEST(Image, HalvedIsTheMeanOfFourPixels) {
  const Image image{
      4, 2, {0, 0, 0, 4, 8, 12, 255, 0, 0, 255, 0, 0, 0, 0, 0, 4, 8, 12, 255, 0, 0, 255, 0, 0}};
  const Image half = halved(image);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.rgb, (std::vector<std::uint8_t>{2, 4, 6, 255, 0, 0}));
}

}  // namespace
}  // namespace facies::results
