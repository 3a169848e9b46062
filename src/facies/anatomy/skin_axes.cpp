// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/skin_axes.hpp"

#include <numbers>

#include <Eigen/Geometry>

#include "facies/mesh/columns.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::anatomy {

SkinAxes skin_axes(const Vec3& direction, const Vec3& normal) {
  const double smallest = std::sin(5.0 * std::numbers::pi / 180.0);
  const auto projected = [&](const Vec3& v) { return Vec3(v - v.dot(normal) * normal); };
  SkinAxes result;
  Vec3 a1 = projected(direction);
  if (a1.norm() < smallest * direction.norm() || direction.isZero()) {
    result.is_fallback = true;
    a1 = Vec3::UnitZ().cross(normal);
    if (a1.norm() < smallest) a1 = projected(Vec3::UnitY());
  }
  a1.normalize();
  result.axes << a1, normal, a1.cross(normal);
  return result;
}

std::size_t set_skin_axes(FaceAnatomy& face, std::span<const Vec3> directions) {
  const mesh::Mesh& mesh = face.mesh;
  const std::vector<mesh::Face> outward = mesh::outward_faces(mesh, mesh.faces("outer"));
  face.axes.assign(mesh.n_elements(), Mat3::Identity());
  std::size_t n_fallbacks = 0;
  for (const Index e : mesh.elements("skin")) {
    require(outward[at(e)].element == e, "an element of the skin lies below no outer face");
    const Vec3 normal = mesh::area_vector(mesh, outward[at(e)], mesh.X()).normalized();
    const SkinAxes axes = skin_axes(directions[at(e)], normal);
    face.axes[at(e)] = axes.axes;
    if (axes.is_fallback) ++n_fallbacks;
  }
  return n_fallbacks;
}

}  // namespace facies::anatomy
