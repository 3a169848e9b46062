// SPDX-License-Identifier: Apache-2.0
// The jaw of the reference face beside the bones in its files.
#include "anatomy/reference_face.hpp"
#include <gtest/gtest.h>

namespace facies::anatomy {
namespace {

using ReferenceJaw = ReferenceFaceTest;

/// Vertices of a surface's file [mm].
std::vector<Vec3> vertices_of(const BoneSurface& surface) {
  const std::string text = read_file(surface.file);
  std::vector<Vec3> vertices;
  for (const std::string_view line : split(text, '\n')) {
    if (!line.starts_with("v ")) continue;
    const auto fields = split_blanks(line);
    vertices.push_back(surface.scale * Vec3(parse_number(fields.at(1)).value(),
                                            parse_number(fields.at(2)).value(),
                                            parse_number(fields.at(3)).value()));
  }
  return vertices;
}

double nearest(const std::vector<Vec3>& vertices, const Vec3& x) {
  double best = 1e9;
  for (const Vec3& v : vertices)
    best = std::min(best, (v - x).norm());
  return best;
}

TEST_F(ReferenceJaw, IsReadWithTheFace) {
  ASSERT_TRUE(face().jaw.has_value());
  const Jaw& jaw = *face().jaw;
  EXPECT_EQ(jaw.muscles.size(), 28U);
  EXPECT_EQ(jaw.bones.at(at(jaw.mandible)).name, "jaw");
  EXPECT_EQ(face().mesh.nodes(jaw.attached_nodes).size(), 12U);
  EXPECT_NEAR(distance(jaw, jaw.start, "lower_incisor", "upper_incisor"), 10.542, 1e-3);
}

TEST_F(ReferenceJaw, HasASurfaceForEveryBoneOnTheSameScaleAsTheFace) {
  const Jaw& jaw = *face().jaw;
  std::vector<bool> covered(jaw.bones.size(), false);
  for (const BoneSurface& surface : jaw.surfaces) {
    covered[at(surface.bone)] = true;
    for (const Vec3& v : vertices_of(surface))
      EXPECT_TRUE(v.x() > 0 && v.x() < 300 && std::abs(v.y()) < 100 && v.z() > 0 && v.z() < 250)
          << surface.name;
  }
  for (std::size_t b = 0; b < covered.size(); ++b)
    EXPECT_TRUE(covered[b]) << jaw.bones[b].name;
}

TEST_F(ReferenceJaw, HasItsPointsAndMusclesNearTheBoneOfTheFile) {
  const Jaw& jaw = *face().jaw;
  const std::vector<Vec3> bone = vertices_of(*find_named(jaw.surfaces, "jaw"));
  for (const JawPoint& point : jaw.points) {
    if (point.at.bone == jaw.mandible) {
      EXPECT_LE(nearest(bone, point.at.X), 8.0) << point.name;
    }
  }
  for (const JawMuscle& muscle : jaw.muscles) {
    for (const BonePoint& end : {muscle.origin, muscle.insertion}) {
      if (end.bone != jaw.mandible) continue;
      EXPECT_LE(nearest(bone, end.X), 6.0) << muscle.name;
    }
  }
}

}  // namespace
}  // namespace facies::anatomy
