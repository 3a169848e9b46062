// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/results/shell.hpp"

namespace facies::results {
namespace {

/// The volume inside a closed surface, and the sum of its area vectors, by the divergence theorem.
std::pair<double, Vec3> inside(const Surface& surface) {
  double volume = 0.0;
  Vec3 area = Vec3::Zero();
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 p = surface.positions[a].cast<double>();
    const Vec3 q = surface.positions[b].cast<double>();
    const Vec3 r = surface.positions[c].cast<double>();
    volume += p.dot(q.cross(r)) / 6.0;
    area += 0.5 * (q - p).cross(r - p);
  }
  return {volume, area};
}

TEST(Shell, IsTheWholeClosedBoundary) {
  const SheetSubject sheet;
  const std::vector<Vec3> u(sheet->mesh->n_nodes(), Vec3::Zero());
  const auto [volume, area] = inside(Shell(*sheet->mesh).pose(u));
  EXPECT_NEAR(volume, 40.0 * 40.0 * 8.0, 0.01);
  EXPECT_NEAR(area.norm(), 0.0, 1e-3);
}

TEST(Shell, FollowsTheDisplacement) {
  const SheetSubject sheet;
  const Snapshot stretched =
      sheet.affine("stretch", 1, Vec3(1.0, 2.0, 1.5).asDiagonal(), {1.0, 2.0, 3.0});
  EXPECT_NEAR(inside(Shell(*sheet->mesh).pose(stretched.state.u)).first, 3.0 * 40.0 * 40.0 * 8.0,
              0.05);
}

TEST(Shell, HasEdgesAtTheRimAndOutwardNormals) {
  const SheetSubject sheet;
  const std::vector<Vec3> u(sheet->mesh->n_nodes(), Vec3::Zero());
  const Surface surface = Shell(*sheet->mesh).pose(u);
  const Vec3f middle(4.0F, 0.0F, 0.0F);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    EXPECT_GT(surface.normals[i].dot(surface.positions[i] - middle), 0.0F);
    // A box: every normal is along an axis, none is a mixture across an edge.
    EXPECT_NEAR(surface.normals[i].cwiseAbs().maxCoeff(), 1.0F, 1e-5F);
  }
}

TEST(Shell, IsSmoothOverTheOuterSurface) {
  mesh::SheetOptions options = SheetSubject::default_options();
  options.shape = mesh::SheetShape::sphere;
  options.radius = 30.0;
  const SheetSubject sheet(options);
  const std::vector<Vec3> u(sheet->mesh->n_nodes(), Vec3::Zero());
  const Surface surface = Shell(*sheet->mesh).pose(u);
  int n_round = 0;
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Vec3f radius = surface.positions[i] - Vec3f(30.0F, 0.0F, 0.0F);
    if (!surface.round[i] || radius.norm() < 29.9F) continue;
    EXPECT_GT(surface.normals[i].dot(radius.normalized()), 0.98F);
    ++n_round;
  }
  EXPECT_EQ(n_round, 9);  // the nodes of the outer surface off its rim
}

TEST(Shell, CarriesNodeValues) {
  const SheetSubject sheet;
  std::vector<Vec3> u(sheet->mesh->n_nodes(), Vec3::Zero());
  std::vector<double> values;
  for (const Vec3& X : sheet->mesh->X())
    values.push_back(X.y());
  const Surface surface = Shell(*sheet->mesh).pose(u, values);
  ASSERT_EQ(surface.values.size(), surface.positions.size());
  for (std::size_t i = 0; i < surface.values.size(); ++i)
    EXPECT_FLOAT_EQ(surface.values[i], surface.positions[i].y());
  EXPECT_TRUE(Shell(*sheet->mesh).pose(u).values.empty());
  values.pop_back();
  EXPECT_THROW(static_cast<void>(Shell(*sheet->mesh).pose(u, values)), BugError);
}

TEST(Shell, ClosesHolesOfTheInnerSideWithLids) {
  // The same sheet without one inner column: its inner side has a hole, whose border is shorter than the rim.
  const SheetSubject sheet;
  const mesh::Mesh& whole = *sheet->mesh;
  const auto is_in_hole = [&](Index e) {
    return whole.centroid(e).tail<2>().cwiseAbs().maxCoeff() < 10.0 &&
           whole.centroid(e).y() > 0.0 && whole.centroid(e).z() > 0.0;
  };
  std::vector<mesh::Element> elements;
  std::vector<mesh::Face> inner;
  for (std::size_t e = 0; e < whole.n_elements(); ++e) {
    if (is_in_hole(to_index(e))) continue;
    for (const mesh::Face& face : whole.faces("inner")) {
      if (face.element == to_index(e)) inner.push_back({to_index(elements.size()), face.local});
    }
    elements.push_back(whole.elements()[e]);
  }
  mesh::Mesh holed({whole.X().begin(), whole.X().end()}, elements);
  const std::vector<Vec3> u(holed.n_nodes(), Vec3::Zero());
  const std::size_t without = Shell(holed).pose(u).triangles.size();
  holed.set_faces("inner", inner);
  const Surface surface = Shell(holed).pose(u);
  EXPECT_EQ(surface.triangles.size(), without + 4);
  // The lid's middle lies deeper than the inner side, which is at x = 8.
  float deepest = 0.0F;
  for (const Vec3f& p : surface.positions)
    deepest = std::max(deepest, p.x());
  EXPECT_GT(deepest, 10.0F);
}

}  // namespace
}  // namespace facies::results
