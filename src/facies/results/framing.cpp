// SPDX-License-Identifier: Apache-2.0
#include "facies/results/framing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facies/mesh/surface.hpp"

namespace facies::results {

namespace {

/// Room around the mesh as read [mm], for what moves; and around everything that is shown.
constexpr double wide_margin = 8.0;
constexpr double narrow_margin = 2.0;
/// Height of what is shown around the mouth [mm].
constexpr double mouth_height = 70.0;

/// The range of points along three axes.
struct Extent {
  Eigen::Array3d lower = Eigen::Array3d::Constant(1e300);
  Eigen::Array3d upper = Eigen::Array3d::Constant(-1e300);

  void add(const Eigen::Array3d& point, double around) {
    lower = lower.min(point - around);
    upper = upper.max(point + around);
  }
};

/// Along the camera's direction, right and up: the mesh with a wide margin, every state with a narrow one.
Extent extent_of(const mesh::Mesh& mesh, const Camera& camera, States states) {
  Extent extent;
  const auto add = [&](const Vec3& x, double around) {
    extent.add({x.dot(camera.direction), x.dot(camera.right()), x.dot(camera.up)}, around);
  };
  for (const Vec3& X : mesh.X())
    add(X, wide_margin);
  for (const std::vector<Vec3>* u : states) {
    for (std::size_t i = 0; i < u->size(); ++i)
      add(mesh.X()[i] + (*u)[i], narrow_margin);
  }
  return extent;
}

/// The middle of what a range covers.
Vec3 middle_of(const Extent& extent, const Camera& camera) {
  const Eigen::Array3d middle = 0.5 * (extent.lower + extent.upper);
  return middle(0) * camera.direction + middle(1) * camera.right() + middle(2) * camera.up;
}

/// The mean of the nodes of the face set "mouth"; nothing without one.
std::optional<Vec3> middle_of_mouth(const mesh::Mesh& mesh) {
  const std::vector<Index> mouth = mesh::face_set_nodes(mesh, mesh.faces("mouth"));
  if (mouth.empty()) return {};
  Vec3 middle = Vec3::Zero();
  for (const Index node : mouth)
    middle += mesh.X()[at(node)] / static_cast<double>(mouth.size());
  return middle;
}

}  // namespace

std::vector<View> standard_views(const mesh::Mesh& mesh, States states, int height) {
  // Faces look towards -x and have their right side at +y.
  std::vector<View> views = {{"front", {}}, {"three-quarter", {}}, {"profile", {}}};
  views[0].camera.direction = Vec3::UnitX();
  views[1].camera.direction = Vec3(1.0, -1.0, 0.0).normalized();
  views[2].camera.direction = -Vec3::UnitY();
  std::vector<Extent> extents;
  double tallest = 0.0;
  for (const View& view : views) {
    extents.push_back(extent_of(mesh, view.camera, states));
    tallest = std::max(tallest, extents.back().upper(2) - extents.back().lower(2));
  }
  for (std::size_t v = 0; v < views.size(); ++v) {
    Camera& camera = views[v].camera;
    camera.target = middle_of(extents[v], camera);
    camera.mm_per_pixel = tallest / height;
    camera.height = height;
    camera.width = static_cast<int>(
        std::ceil((extents[v].upper(1) - extents[v].lower(1)) / camera.mm_per_pixel));
  }
  return views;
}

std::vector<View> section_views(const mesh::Mesh& mesh, States states, int height) {
  Camera camera = standard_views(mesh, states, height).back().camera;
  camera.target.y() = 0.0;
  camera.cut = 0.0;
  std::vector<View> views = {{"midsagittal cut", camera}};
  const std::optional<Vec3> mouth = middle_of_mouth(mesh);
  if (!mouth) return views;
  camera.target = {mouth->x(), 0.0, mouth->z()};
  camera.mm_per_pixel = mouth_height / height;
  camera.width = height;
  views.push_back({"around the mouth", camera});
  return views;
}

View transverse_view(const mesh::Mesh& mesh, States states, int height) {
  Camera camera;
  camera.direction = Vec3::UnitZ();
  camera.up = -Vec3::UnitX();
  const Extent extent = extent_of(mesh, camera, states);
  const Eigen::Array3d size = extent.upper - extent.lower;
  camera.target = middle_of(extent, camera);
  if (const std::optional<Vec3> mouth = middle_of_mouth(mesh)) camera.target.z() = mouth->z();
  camera.mm_per_pixel = size(2) / height;
  camera.width = static_cast<int>(std::ceil(size(1) / camera.mm_per_pixel));
  camera.height = height;
  camera.cut = 0.0;
  return {"transverse cut, from below", camera};
}

}  // namespace facies::results
