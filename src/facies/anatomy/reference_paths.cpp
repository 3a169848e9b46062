// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/reference_paths.hpp"

#include <fmt/format.h>

#include "facies/anatomy/tissue_surface.hpp"

namespace facies::anatomy {
namespace {

/// Points up to here belong to the left side or the midline [mm].
constexpr double midline = 1e-4;
/// Fibres end at bones near the tissue; a point farther than this from the face's bounding box is a mistake [mm].
constexpr double far_away = 20.0;

using PointMap = std::map<long, const PointRow*>;

PointMap points_by_number(const std::vector<PointRow>& points) {
  PointMap map;
  for (const PointRow& point : points)
    map.emplace(point.number, &point);
  return map;
}

void check_points(const FibreFiles& files, const mesh::Mesh& mesh, Problems& problems) {
  if (mesh.n_nodes() == 0) return;
  Vec3 lower = mesh.X()[0];
  Vec3 upper = lower;
  for (const Vec3& X : mesh.X()) {
    lower = lower.cwiseMin(X);
    upper = upper.cwiseMax(X);
  }
  ProblemsOfOneKind outside(files.points_file, "points far from the face");
  for (const PointRow& point : files.points) {
    const Vec3 excess = (lower - point.X).cwiseMax(point.X - upper);
    if (excess.maxCoeff() <= far_away) continue;
    outside.add({point.where,
                 fmt::format("point {} lies {:.6g} mm outside the box around the face",
                             point.number, excess.maxCoeff()),
                 fmt::format("at most {} mm", far_away),
                 "fibre points are in metres and not scaled, in the axes of the mesh"});
  }
  outside.move_to(problems);
}

void check_fibre(const FibreRow& fibre, const PointMap& points, ProblemsOfOneKind& bad) {
  for (const NumberAt& number : fibre.points) {
    const auto found = points.find(number.value);
    if (found == points.end()) {
      bad.add({number.where, fmt::format("point {} of muscle {}", number.value, fibre.muscle),
               "a point of the fibre file", "the fibre file may be truncated"});
    } else if (found->second->X.y() > midline) {
      bad.add({number.where,
               fmt::format("point {} of muscle {} at y = {:.6g} mm", number.value, fibre.muscle,
                           found->second->X.y()),
               "a point of the left side (y <= 0)", "the right side is mirrored from the left"});
    }
  }
}

void check_ring(const FibreRow& fibre, const std::vector<NumberAt>& ring, const ReferenceMesh& mesh,
                ProblemsOfOneKind& bad) {
  std::size_t n_hexahedra = 0;
  for (const NumberAt& number : ring) {
    const std::optional<Index> e = mesh.elements.index(number.value);
    if (!e) {
      bad.add({number.where, fmt::format("element {} of muscle {}", number.value, fibre.muscle),
               "an element of the mesh", ""});
    } else if (mesh.mesh.n_elements() > 0 && mesh.mesh.element(*e).type == mesh::CellType::hex8) {
      ++n_hexahedra;
    }
  }
  if (mesh.mesh.n_elements() > 0 && bad.empty() && n_hexahedra < 3) {
    bad.add({fibre.where, fmt::format("a ring of {} hexahedra", n_hexahedra), "at least 3", ""});
  }
}

FibrePath make_ring(const std::vector<NumberAt>& ring, const ReferenceMesh& mesh,
                    std::size_t& n_wedges) {
  FibrePath path;
  path.side = Side::middle;
  path.closed = true;
  for (const NumberAt& number : ring) {
    const Index e = mesh.elements.index(number.value).value();
    if (mesh.mesh.element(e).type == mesh::CellType::hex8) {
      path.points.push_back(mesh.mesh.centroid(e));
    } else {
      ++n_wedges;
    }
  }
  return path;
}

}  // namespace

void check_fibres(const FaceTables& tables, const FibreFiles& files, const ReferenceMesh& mesh,
                  Problems& problems) {
  check_points(files, mesh.mesh, problems);
  const PointMap points = points_by_number(files.points);
  ProblemsOfOneKind bad("muscle fibres", "unusable points");
  for (const FibreRow& fibre : tables.fibres) {
    if (fibre.ring.empty()) {
      if (!points.empty()) check_fibre(fibre, points, bad);
      continue;
    }
    const auto ring = files.rings.find(fibre.ring.string());
    if (ring == files.rings.end() || ring->second.empty() || mesh.elements.size() == 0) continue;
    check_ring(fibre, ring->second, mesh, bad);
  }
  bad.move_to(problems);
}

ReferencePaths make_reference_paths(const FaceTables& tables, const FibreFiles& files,
                                    const ReferenceMesh& mesh) {
  const TissueSurface surface(mesh.mesh);
  const PointMap points = points_by_number(files.points);
  ReferencePaths result;
  const auto place = [&](const Vec3& p) {
    Vec3 placed = surface.into_tissue(p);
    ++result.n_points;
    if (placed != p) ++result.n_moved;
    return placed;
  };
  for (const MuscleRow& row : tables.muscles) {
    MusclePaths muscle{row.name, row.meaning, {}};
    for (const FibreRow& fibre : tables.fibres) {
      if (fibre.muscle != row.name) continue;
      if (!fibre.ring.empty()) {
        const std::vector<NumberAt>& ring = files.rings.at(fibre.ring.string());
        muscle.paths.push_back(make_ring(ring, mesh, result.n_wedges_passed));
        continue;
      }
      FibrePath left{Side::left, false, {}};
      FibrePath right{Side::right, false, {}};
      for (const NumberAt& number : fibre.points) {
        const Vec3 p = place(points.at(number.value)->X);
        left.points.push_back(p);
        right.points.push_back(place({p.x(), -p.y(), p.z()}));
      }
      muscle.paths.push_back(std::move(left));
      muscle.paths.push_back(std::move(right));
    }
    result.muscles.push_back(std::move(muscle));
  }
  return result;
}

}  // namespace facies::anatomy
