// SPDX-License-Identifier: Apache-2.0
// The jaw of the reference face beside the bones in its files.
#include <gmock/gmock.h>

#include "anatomy/reference_face.hpp"
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "facies/mesh/winding_number.hpp"

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

/// How often a ray from p passes through the surface.
int crossings(const mesh::TriangleSurface& surface, const Vec3& p, const Vec3& direction) {
  int n = 0;
  for (const auto& [i, j, k] : surface.triangles) {
    Mat3 edges;
    edges << surface.X[at(j)] - surface.X[at(i)], surface.X[at(k)] - surface.X[at(i)], -direction;
    const Vec3 at_hit = edges.inverse() * (p - surface.X[at(i)]);
    if (at_hit.minCoeff() >= 0.0 && at_hit.x() + at_hit.y() <= 1.0) ++n;
  }
  return n;
}

// Another program's list, made with signed distances, has 2306 as well: 4.05 mm deep, which no part of the bone there is
// thick enough for. It lies beside the coronoid process, whose walls run through each other. 589, 2137 and 6527, less
// than 0.05 mm deep, are on its border.
TEST_F(ReferenceJaw, HoldsInnerNodesOfTheFaceAsRaysSay) {
  const mesh::TriangleSurface& bone = find_named(face().jaw->surfaces, "jaw")->surface;
  std::vector<Index> numbers;
  for (const Index node : face().mesh.nodes("inner")) {
    const Vec3& X = face().mesh.X()[at(node)];
    const bool inside = mesh::winding_number(bone.X, bone.triangles, X) > 0.5;
    if (inside) numbers.push_back(node + 1);
    if (inside || node + 1 == 2306) {
      EXPECT_EQ(crossings(bone, X, Vec3(0.1, 0.2, 1.0)) % 2 == 1, inside) << node + 1;
      EXPECT_EQ(crossings(bone, X, Vec3(0.3, 1.0, -0.1)) % 2 == 1, inside) << node + 1;
    }
  }
  EXPECT_THAT(numbers, testing::ElementsAre(527, 589, 2137, 2139, 2140, 2239, 2240, 2241, 2251,
                                            2252, 2253, 2264, 2265, 2266, 2279, 2388, 3146, 3171,
                                            3176, 5002, 6525, 6527));
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
