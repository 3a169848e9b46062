// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/bone_points.hpp"

#include <Eigen/Geometry>

#include "facies/mesh/nearest.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::scenario {

namespace {

/// Every triangle goes in equal parts to its vertices [mm^2].
std::vector<double> vertex_areas(const mechanics::ContactSurface& surface) {
  std::vector<double> areas(surface.vertices.size(), 0.0);
  for (const std::array<Index, 3>& triangle : surface.triangles) {
    const Vec3& a = surface.vertices[at(triangle[0])].X;
    const Vec3 ab = surface.vertices[at(triangle[1])].X - a;
    const Vec3 ac = surface.vertices[at(triangle[2])].X - a;
    for (const Index vertex : triangle)
      areas[at(vertex)] += ab.cross(ac).norm() / 6.0;
  }
  return areas;
}

}  // namespace

std::vector<mechanics::ContactPoint> bone_points(const mesh::Mesh& mesh,
                                                 const std::vector<Vec3>& start,
                                                 const mechanics::ContactSurface& bone,
                                                 double distance) {
  constexpr double nearest_part = 0.3;
  const mesh::NumberedTriangles inner = mesh::triangulate_alone(mesh, mesh.faces("inner"));
  std::vector<Vec3> x;
  for (const Index node : inner.nodes)
    x.push_back(start.empty() ? mesh.X()[at(node)] : Vec3(mesh.X()[at(node)] + start[at(node)]));
  const mesh::NearestTriangles tissue(x, inner.triangles);
  const std::vector<double> areas = vertex_areas(bone);
  std::vector<mechanics::ContactPoint> points;
  for (std::size_t v = 0; v < bone.vertices.size(); ++v) {
    const mesh::NearestPoint nearest = tissue.nearest(bone.vertices[v].X);
    if (!nearest.is_inside && nearest.distance > nearest_part * distance)
      points.push_back({bone.vertices[v], areas[v]});
  }
  return points;
}

}  // namespace facies::scenario
