// SPDX-License-Identifier: Apache-2.0
#include "facies/results/muscle_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "facies/mesh/surface.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {

namespace {

/// A part of a muscle is seen if this part of its faces is (half of them look away), and so many.
constexpr double seen_part = 0.05;
constexpr std::size_t seen_faces = 3;
/// Where faces meet more sharply than this, one sees an edge.
const double crease_cosine = std::cos(50.0 * std::numbers::pi / 180.0);
/// Two sides are seen alike where the one shows at most this many times as many faces.
constexpr double alike = 1.3;

std::size_t size_of(const MuscleGroup& group) {
  std::size_t n = 0;
  for (const NamedMuscle* part : group.parts)
    n += part->elements.size();
  return n;
}

/// The group that each element is drawn as [n_elements]; -1 for none.
std::vector<int> owners(const std::vector<MuscleGroup>& groups, std::size_t n_elements) {
  std::vector<int> owner(n_elements, -1);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const NamedMuscle* part : groups[g].parts) {
      for (const Index e : part->elements) {
        int& now = owner[at(e)];
        if (now < 0 || size_of(groups[g]) < size_of(groups[static_cast<std::size_t>(now)]))
          now = static_cast<int>(g);
      }
    }
  }
  return owner;
}

/// The faces as triangles in one colour: smooth where those around a node are, with an edge where they are not.
Surface surface_of(const mesh::Mesh& mesh, std::span<const mesh::Face> faces,
                   const Colour& colour) {
  const std::vector<Vec3> normals = mesh::face_normals(mesh, faces, mesh.X());
  std::map<Index, std::vector<std::size_t>> faces_at;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const Index node : mesh.face_nodes(faces[f]))
      faces_at[node].push_back(f);
  }
  const auto normal_at = [&](Index node, std::size_t face) {
    Vec3 sum = Vec3::Zero();
    for (const std::size_t other : faces_at.at(node)) {
      if (normals[other].dot(normals[face]) > crease_cosine) sum += normals[other];
    }
    return Vec3(sum.normalized());
  };
  const mesh::FaceTriangles cut = mesh::triangulate(mesh, faces);
  Surface surface;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (const Index node : cut.triangles[t]) {
      surface.positions.push_back(mesh.X()[at(node)].cast<float>());
      surface.normals.push_back(normal_at(node, at(cut.face[t])).cast<float>());
    }
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  surface.round.assign(surface.positions.size(), false);
  surface.colours.assign(surface.positions.size(), colour);
  return surface;
}

Vec3 middle_of(const mesh::Mesh& mesh, const mesh::Face& face) {
  Vec3 middle = Vec3::Zero();
  const std::vector<Index> nodes = mesh.face_nodes(face);
  for (const Index node : nodes)
    middle += mesh.X()[at(node)] / static_cast<double>(nodes.size());
  return middle;
}

}  // namespace

std::vector<MuscleGroup> muscle_groups(const Subject& subject) {
  std::vector<MuscleGroup> groups;
  for (const NamedMuscle& muscle : subject.muscles) {
    const std::string& name = muscle.group.empty() ? muscle.name : muscle.group;
    auto group = std::ranges::find(groups, name, &MuscleGroup::name);
    if (group == groups.end()) {
      const Colour& colour = palette::muscles.at(groups.size() % palette::muscles.size());
      group = groups.insert(groups.end(), {name, muscle.meaning, colour, {}});
    }
    group->parts.push_back(&muscle);
  }
  return groups;
}

MuscleShape::MuscleShape(const MuscleGroup& group, const mesh::Mesh& mesh,
                         const std::vector<std::vector<Index>>& elements)
    : name_(group.name) {
  for (const std::vector<Index>& part : elements) {
    std::vector<Vec3>& middles = middles_.emplace_back();
    if (part.empty()) continue;
    const std::vector<mesh::Face> faces = mesh::boundary_faces(mesh, part);
    append(surface_, surface_of(mesh, faces, group.colour));
    for (const mesh::Face& face : faces)
      middles.push_back(middle_of(mesh, face));
  }
}

std::vector<MuscleShape::Seen> MuscleShape::seen_in(const Camera& camera,
                                                    const SightTest& sees) const {
  std::vector<Seen> parts;
  for (const std::vector<Vec3>& part : middles_) {
    std::vector<Eigen::Vector2d> seen;
    for (const Vec3& x : part) {
      if (sees(x)) seen.push_back(camera.project(x));
    }
    if (seen.size() < seen_faces ||
        static_cast<double>(seen.size()) < seen_part * static_cast<double>(part.size()))
      continue;
    const auto place = std::ranges::min_element(seen, {}, [&](const Eigen::Vector2d& x) {
      double sum = 0.0;
      for (const Eigen::Vector2d& other : seen)
        sum += (other - x).norm();
      return sum;
    });
    parts.push_back({seen.size(), {place->x(), place->y(), name_}});
  }
  return parts;
}

std::vector<MuscleShape> muscle_shapes(const std::vector<MuscleGroup>& groups,
                                       const mesh::Mesh& mesh, bool each_alone) {
  const std::vector<int> owner = owners(groups, mesh.n_elements());
  std::vector<MuscleShape> shapes;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<std::vector<Index>> elements;
    for (const NamedMuscle* part : groups[g].parts) {
      std::vector<Index>& own = elements.emplace_back();
      std::ranges::copy_if(part->elements, std::back_inserter(own), [&](Index e) {
        return each_alone || owner[at(e)] == static_cast<int>(g);
      });
    }
    shapes.emplace_back(groups[g], mesh, elements);
  }
  return shapes;
}

std::vector<Dot> muscle_names(const std::vector<MuscleShape>& shapes, const Camera& camera,
                              const SightTest& sees) {
  using Seen = MuscleShape::Seen;
  std::vector<std::vector<Seen>> muscles;
  for (const MuscleShape& shape : shapes) {
    std::vector<Seen> parts = shape.seen_in(camera, sees);
    if (!parts.empty()) muscles.push_back(std::move(parts));
  }
  std::ranges::stable_sort(muscles, {}, [](const auto& parts) { return parts[0].place.row; });
  std::vector<Dot> names;
  bool is_left = true;
  for (const std::vector<Seen>& parts : muscles) {
    const auto [fewest, most] = std::ranges::minmax_element(parts, {}, &Seen::n_faces);
    if (static_cast<double>(most->n_faces) > alike * static_cast<double>(fewest->n_faces)) {
      names.push_back(most->place);
      continue;
    }
    const auto [first, last] =
        std::ranges::minmax_element(parts, {}, [](const Seen& part) { return part.place.column; });
    names.push_back(is_left ? first->place : last->place);
    if (parts.size() > 1) is_left = !is_left;
  }
  return names;
}

}  // namespace facies::results
