// SPDX-License-Identifier: Apache-2.0
// Where a run begins on the reference face: the jaw on its joint, and no tissue in bone. Skipped where it is not at hand.
#include <algorithm>
#include <set>

#include "anatomy/reference_face.hpp"
#include "support/session.hpp"

#include "facies/mesh/columns.hpp"
#include "facies/mesh/nearest.hpp"
#include "facies/mesh/winding_number.hpp"
#include "facies/scenario/build_model.hpp"

namespace facies::scenario {
namespace {

using ReferenceStart = anatomy::ReferenceFaceTest;

const Vec3 gravity(0.0, 0.0, -9800.0);

TEST_F(ReferenceStart, HasNothingWrong) {
  const Reading reading = read_text("steps:\n  - tension: {tsf: 1.1}\n", "x.yaml", "x", {});
  EXPECT_TRUE(check_model(face(), reading.scenario).empty());
}

std::vector<Vec3> places_of(const BoneObstacle& bone) {
  std::vector<Vec3> x;
  for (const mechanics::Anchor& vertex : bone.surface.vertices)
    x.push_back(vertex.X);
  return x;
}

// The nodes beside the coronoid processes, thin and with walls that run through each other there, begin 3 and 6 mm away
// from bone, on whose inner side a distance with a sign sees them. The nodes in the bone lie 1.6 mm deep at most,
// and four are on the far side of the thin rear of the left ramus.
TEST_F(ReferenceStart, TakesNodesOutOfTheJawAndLeavesThoseBesideItsThinParts) {
  const double distance = 1.0;
  const SettledJaw settled = settle_jaw(*face().jaw, gravity);
  const std::vector<BoneObstacle> obstacles = bone_obstacles(face(), &settled, {});
  const std::vector<mechanics::ContactPoint> points = inner_points(face(), {});
  const std::vector<Vec3> u = resolve_overlaps(face(), points, obstacles, distance);
  for (const Index beside : {2305, 4993})
    EXPECT_EQ(u[at(beside)], Vec3::Zero());
  const std::vector<Vec3> x = places_of(obstacles.front());
  const std::set<Index> far{527, 2394, 2396, 3175};
  for (const mechanics::ContactPoint& point : points) {
    const Vec3& move = u[at(point.anchor.index)];
    if (far.contains(point.anchor.index)) {
      EXPECT_GT(move.norm(), 3.0);
      EXPECT_LE(move.norm(), 6.5) << "through the ramus to its outer side";
    } else {
      EXPECT_LE(move.norm(), 3.0);
    }
    if (move == Vec3::Zero()) continue;
    EXPECT_NEAR(mesh::winding_number(x, obstacles.front().surface.triangles, point.anchor.X + move),
                0.0, 1e-9);
  }
}

// As the mesh is read four columns at the thin rear of the left ramus begin on its inner side.
TEST_F(ReferenceStart, HasTheJawInTheWayOfNoColumnFromItsNodeOnBoneToTheSkin) {
  const double distance = 1.0;
  const SettledJaw settled = settle_jaw(*face().jaw, gravity);
  const std::vector<BoneObstacle> obstacles = bone_obstacles(face(), &settled, {});
  const std::vector<mechanics::ContactPoint> points = inner_points(face(), {});
  const std::vector<Vec3> u = resolve_overlaps(face(), points, obstacles, distance);
  const std::vector<Vec3> x = places_of(obstacles.front());
  const mesh::NearestTriangles jaw(x, obstacles.front().surface.triangles);
  const auto n_passes = [&](bool moved) {
    int n = 0;
    for (const std::vector<Index>& column :
         mesh::node_columns(face().mesh, face().mesh.faces("outer"))) {
      for (std::size_t i = 1; i < column.size(); ++i) {
        const auto place = [&](Index node) -> Vec3 {
          return face().mesh.X()[at(node)] + (moved ? u[at(node)] : Vec3::Zero());
        };
        if (!jaw.passes(place(column[i - 1]), place(column[i])).empty()) ++n;
      }
    }
    return n;
  };
  EXPECT_GT(n_passes(false), 10);
  EXPECT_EQ(n_passes(true), 0);
}

}  // namespace
}  // namespace facies::scenario
