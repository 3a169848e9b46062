// SPDX-License-Identifier: Apache-2.0
// The tissue of the built-in face for measures from everywhere in their ranges.
#include <algorithm>
#include <optional>

#include "anatomy/builtin_files.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_jaw.hpp"
#include "facies/anatomy/builtin_shape.hpp"
#include "facies/anatomy/builtin_tissue.hpp"
#include "facies/mesh/quality.hpp"

namespace facies::anatomy {
namespace {

using support::Random;

/// The drawings, and the bones as drawn.
struct Drawn {
  Drawings drawings = read_drawings(builtin_folder());
  std::vector<mesh::TriangleSurface> bones;

  Drawn() {
    Problems problems;
    std::vector<std::filesystem::path> files;
    const Jaw jaw = make_builtin_jaw(
        builtin_folder(), [](const Vec3& x) { return x; }, files, problems);
    problems.throw_if_any<DataError>();
    for (const BoneSurface& bone : jaw.surfaces)
      bones.push_back(bone.surface);
  }
};

/// A value for every measure but one: the height of the chin or that of the face, which follows.
MeasureValues draw(const std::vector<FaceMeasure>& measures, Random& random) {
  MeasureValues values;
  for (const FaceMeasure& measure : measures)
    values[measure.key] = random.uniform(measure.smallest, measure.largest);
  values.erase(random.uniform(0.0, 1.0) < 0.5 ? "chin_height" : "face_height");
  return values;
}

/// Makes the coarse tissue with these measures. Nothing where what follows from them is out of its range.
std::optional<mesh::Mesh> tissue_with(const MeasureValues& given, const Drawn& drawn) {
  const Drawings& drawings = drawn.drawings;
  std::optional<RadialWarp> warp;
  try {
    warp = shape_warp(drawings, complete_values(drawings.measures.measures, false, given));
  } catch (const UsageError& error) {
    // That is the only thing that may be wrong with values that are all in their ranges.
    for (const Problem& problem : error.problems())
      EXPECT_NE(problem.found.find("follow from the others"), std::string::npos) << error.what();
    return std::nullopt;
  }
  const auto warped = [&](std::vector<Vec3> points) {
    for (Vec3& x : points)
      x = (*warp)(x);
    return points;
  };
  std::vector<mesh::TriangleSurface> bones = drawn.bones;
  for (mesh::TriangleSurface& bone : bones)
    bone.X = warped(std::move(bone.X));
  return make_tissue(drawings.skin, warped(drawings.skin.points), warped(drawings.inner),
                     skin_thickness(drawings.skin, drawings.skin_regions, false), bones, 1.0,
                     FaceSize::coarse)
      .mesh;
}

TEST(BuiltinFace, HasAValidMeshForAllMeasuresInTheirRanges) {
  constexpr int n_faces = 200;
  const Drawn drawn;
  Random random(1);
  int n_made = 0;
  int n_drawn = 0;
  double worst = 1.0;
  for (; n_made < n_faces && n_drawn < 3 * n_faces; ++n_drawn) {
    SCOPED_TRACE(n_drawn);
    const auto mesh = tissue_with(draw(drawn.drawings.measures.measures, random), drawn);
    if (!mesh) continue;
    ++n_made;
    EXPECT_TRUE(mesh::check_geometry(*mesh).empty());
    double corner = 1.0;
    for (Index e = 0; e < to_index(mesh->n_elements()); ++e) {
      const mesh::ElementQuality element = mesh::element_quality(*mesh, e, mesh->X());
      EXPECT_GT(element.scaled_jacobian_gauss, 0.2);
      corner = std::min(corner, element.scaled_jacobian_corner);
    }
    EXPECT_GT(corner, 0.05);
    worst = std::min(worst, corner);
  }
  EXPECT_EQ(n_made, n_faces) << "the others contradict themselves";
  RecordProperty("drawn", n_drawn);
  RecordProperty("smallest_corner_per_mille", static_cast<int>(1000.0 * worst));
}

}  // namespace
}  // namespace facies::anatomy
