// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>

namespace facies::mesh {
namespace {

Vec3 unit_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0.0 ? Vec3(v / length) : Vec3::Zero();
}

}  // namespace

FaceKey face_key(const Mesh& mesh, Face face) {
  FaceKey key{-1, -1, -1, -1};
  std::ranges::copy(mesh.face_nodes(face), key.begin());
  std::ranges::sort(key);
  return key;
}

std::vector<Face> boundary_faces(const Mesh& mesh) {
  std::vector<Index> all(mesh.n_elements());
  std::iota(all.begin(), all.end(), 0);
  return boundary_faces(mesh, all);
}

std::vector<Face> boundary_faces(const Mesh& mesh, std::span<const Index> elements) {
  std::vector<std::pair<FaceKey, Face>> keyed;
  for (const Index e : elements) {
    for (std::size_t local = 0; local < faces(mesh.element(e).type).size(); ++local) {
      const Face face{e, static_cast<std::uint8_t>(local)};
      keyed.emplace_back(face_key(mesh, face), face);
    }
  }
  std::ranges::sort(keyed);
  std::vector<Face> boundary;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const bool as_before = i > 0 && keyed[i - 1].first == keyed[i].first;
    const bool as_after = i + 1 < keyed.size() && keyed[i + 1].first == keyed[i].first;
    if (!as_before && !as_after) boundary.push_back(keyed[i].second);
  }
  std::ranges::sort(boundary);
  return boundary;
}

std::vector<Index> face_set_nodes(const Mesh& mesh, std::span<const Face> faces) {
  std::set<Index> nodes;
  for (const Face& face : faces) {
    for (const Index node : mesh.face_nodes(face))
      nodes.insert(node);
  }
  return {nodes.begin(), nodes.end()};
}

FaceTriangles triangulate(const Mesh& mesh, std::span<const Face> faces) {
  FaceTriangles surface;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<Index> n = mesh.face_nodes(faces[i]);
    std::rotate(n.begin(), std::ranges::min_element(n), n.end());
    surface.triangles.push_back({n[0], n[1], n[2]});
    surface.face.push_back(to_index(i));
    if (n.size() == 4) {
      surface.triangles.push_back({n[0], n[2], n[3]});
      surface.face.push_back(to_index(i));
    }
  }
  return surface;
}

NumberedTriangles triangulate_alone(const Mesh& mesh, std::span<const Face> faces) {
  NumberedTriangles alone{face_set_nodes(mesh, faces), triangulate(mesh, faces).triangles};
  for (std::array<Index, 3>& triangle : alone.triangles) {
    for (Index& corner : triangle) {
      const auto found = std::lower_bound(alone.nodes.begin(), alone.nodes.end(), corner);
      corner = static_cast<Index>(found - alone.nodes.begin());
    }
  }
  return alone;
}

Vec3 area_vector(const Mesh& mesh, Face face, std::span<const Vec3> x) {
  const std::vector<Index> n = mesh.face_nodes(face);
  const Vec3 a = x[at(n[2])] - x[at(n[0])];
  const Vec3 b = x[at(n.back())] - x[at(n[1])];
  // The diagonals of a quadrilateral; in a triangle, n.back() is n[2] and these are two of its sides.
  return 0.5 * a.cross(b);
}

double face_area(const Mesh& mesh, Face face, std::span<const Vec3> x) {
  const std::vector<Index> n = mesh.face_nodes(face);
  if (n.size() == 3) return area_vector(mesh, face, x).norm();
  const Vec3& x0 = x[at(n[0])];
  const Vec3& x1 = x[at(n[1])];
  const Vec3& x2 = x[at(n[2])];
  const Vec3& x3 = x[at(n[3])];
  const double g = 1.0 / std::sqrt(3.0);
  double area = 0.0;
  for (const double eta : {-g, g}) {
    for (const double xi : {-g, g}) {
      const Vec3 dx_dxi = 0.25 * ((1.0 - eta) * (x1 - x0) + (1.0 + eta) * (x2 - x3));
      const Vec3 dx_deta = 0.25 * ((1.0 - xi) * (x3 - x0) + (1.0 + xi) * (x2 - x1));
      area += dx_dxi.cross(dx_deta).norm();
    }
  }
  return area;
}

double surface_area(const Mesh& mesh, std::span<const Face> faces, std::span<const Vec3> x) {
  double area = 0.0;
  for (const Face& face : faces)
    area += face_area(mesh, face, x);
  return area;
}

std::vector<double> node_areas(const Mesh& mesh, std::span<const Face> faces,
                               std::span<const Vec3> x) {
  std::vector<double> areas(mesh.n_nodes(), 0.0);
  for (const Face& face : faces) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    const double share = face_area(mesh, face, x) / static_cast<double>(nodes.size());
    for (const Index node : nodes)
      areas[at(node)] += share;
  }
  return areas;
}

std::vector<Vec3> face_normals(const Mesh& mesh, std::span<const Face> faces,
                               std::span<const Vec3> x) {
  std::vector<Vec3> normals;
  normals.reserve(faces.size());
  for (const Face& face : faces)
    normals.push_back(unit_or_zero(area_vector(mesh, face, x)));
  return normals;
}

std::vector<Vec3> vertex_normals(const Mesh& mesh, std::span<const Face> faces,
                                 std::span<const Vec3> x) {
  std::vector<Vec3> normals(mesh.n_nodes(), Vec3::Zero());
  for (const Face& face : faces) {
    const Vec3 area = area_vector(mesh, face, x);
    for (const Index node : mesh.face_nodes(face))
      normals[at(node)] += area;
  }
  for (Vec3& normal : normals)
    normal = unit_or_zero(normal);
  return normals;
}

}  // namespace facies::mesh
