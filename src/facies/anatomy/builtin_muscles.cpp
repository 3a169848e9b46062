// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_muscles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace facies::anatomy {
namespace {

/// Between points of a path [mm]: fine enough for it to keep its depth below curved skin.
constexpr double path_step = 2.0;

Vec3 as_vector(const DrawnPoint& point) {
  return {point.lateral, point.up, point.depth};
}

/// A point of a curve between drawn ones, of which `drawn` is the one before.
DrawnPoint near(const DrawnPoint& drawn, const Vec3& x) {
  return {x.x(), x.y(), x.z(), drawn.where};
}

DrawnPoint across_midline(const DrawnPoint& point) {
  return {-point.lateral, point.up, point.depth, point.where};
}

/// The point as far beyond `end` as `next` lies before it, at the same depth.
DrawnPoint beyond(const DrawnPoint& end, const DrawnPoint& next) {
  return {2.0 * end.lateral - next.lateral, 2.0 * end.up - next.up, end.depth, end.where};
}

/// The points of a fibre with one more at either end (two at a loop's last), which give the curve its directions there.
std::vector<DrawnPoint> with_neighbours(const DrawnFibre& fibre) {
  const std::vector<DrawnPoint>& points = fibre.points;
  const std::size_t n = points.size();
  std::vector<DrawnPoint> all;
  switch (fibre.form) {
    case FibreForm::fibre:
      all.push_back(beyond(points[0], points[1]));
      break;
    case FibreForm::ring:
      all.push_back(across_midline(points[1]));
      break;
    case FibreForm::loop:
      all.push_back(points[n - 1]);
      break;
  }
  all.insert(all.end(), points.begin(), points.end());
  switch (fibre.form) {
    case FibreForm::fibre:
      all.push_back(beyond(points[n - 1], points[n - 2]));
      break;
    case FibreForm::ring:
      all.push_back(across_midline(points[n - 2]));
      break;
    case FibreForm::loop:
      all.push_back(points[0]);
      all.push_back(points[1]);
      break;
  }
  return all;
}

/// The chordal curve between b and c; its knots are apart as the points are in the frontal view.
Vec3 between(const std::array<Vec3, 4>& points, double part) {
  const auto chord = [](const Vec3& from, const Vec3& to) {
    return std::max((to - from).head<2>().norm(), 1e-9);
  };
  const auto& [a, b, c, d] = points;
  const double t0 = -chord(a, b);
  const double t2 = chord(b, c);
  const double t3 = t2 + chord(c, d);
  const double t = part * t2;
  const auto mix = [t](const Vec3& p, const Vec3& q, double from, double to) {
    return Vec3(((to - t) * p + (t - from) * q) / (to - from));
  };
  const Vec3 ab = mix(a, b, t0, 0.0);
  const Vec3 bc = mix(b, c, 0.0, t2);
  const Vec3 cd = mix(c, d, t2, t3);
  const Vec3 found = mix(mix(ab, bc, t0, t2), mix(bc, cd, 0.0, t3), 0.0, t2);
  // An overshoot between two depths would leave the tissue.
  const auto [least, most] = std::minmax(b.z(), c.z());
  return {found.x(), found.y(), std::clamp(found.z(), least, most)};
}

/// Points of a path and the normals of the layers that they lie in.
struct Placed {
  std::vector<Vec3> points, normals;
};

Placed mirror_image(Placed placed) {
  for (std::vector<Vec3>* vectors : {&placed.points, &placed.normals}) {
    for (Vec3& x : *vectors)
      x.y() = -x.y();
  }
  return placed;
}

/// Closes the half of a ring by its mirror image.
Placed closed_ring(Placed right) {
  const Placed left = mirror_image(right);
  right.points.insert(right.points.end(), left.points.rbegin() + 1, left.points.rend() - 1);
  right.normals.insert(right.normals.end(), left.normals.rbegin() + 1, left.normals.rend() - 1);
  return right;
}

FibrePath path_of(Placed placed, Side side, bool closed) {
  return {side, closed, std::move(placed.points), std::move(placed.normals)};
}

class Tissue {
 public:
  Tissue(const SkinSites& sites, const std::vector<Vec3>& outer, const std::vector<Vec3>& inner)
      : sites_(&sites), outer_(&outer), inner_(&inner) {}

  [[nodiscard]] Placed place(const DrawnFibre& fibre, Problems& problems) const {
    Placed placed;
    std::string beside;  // the last drawn point that was told to be
    for (const DrawnPoint& point : smooth_points(fibre, path_step)) {
      const std::optional<SkinSite> site = sites_->find(point.lateral, point.up);
      if (!site) {
        if (beside != point.where) problems.add(beside_the_face(point));
        beside = point.where;
        continue;
      }
      const std::array<Vec3, 3> corners = corners_at(*site, point.depth);
      placed.points.push_back(site->parts.x() * corners[0] + site->parts.y() * corners[1] +
                              site->parts.z() * corners[2]);
      // Triangles of the net are counter-clockwise seen from outside.
      placed.normals.push_back(
          (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized());
    }
    return placed;
  }

 private:
  /// The corners of the site's triangle, down in the tissue.
  [[nodiscard]] std::array<Vec3, 3> corners_at(const SkinSite& site, double depth) const {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& above = (*outer_)[at(site.vertices[k])];
      corners[k] = above + depth * ((*inner_)[at(site.vertices[k])] - above);
    }
    return corners;
  }

  const SkinSites* sites_;
  const std::vector<Vec3>* outer_;
  const std::vector<Vec3>* inner_;
};

}  // namespace

std::vector<DrawnPoint> smooth_points(const DrawnFibre& fibre, double step) {
  const std::vector<DrawnPoint> drawn = with_neighbours(fibre);
  std::vector<DrawnPoint> points;
  for (std::size_t i = 1; i + 2 < drawn.size(); ++i) {
    const std::array<Vec3, 4> around{as_vector(drawn[i - 1]), as_vector(drawn[i]),
                                     as_vector(drawn[i + 1]), as_vector(drawn[i + 2])};
    const double length = (around[2] - around[1]).head<2>().norm();
    const int n = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k < n; ++k)
      points.push_back(near(drawn[i], between(around, static_cast<double>(k) / n)));
  }
  if (fibre.form != FibreForm::loop) points.push_back(fibre.points.back());
  return points;
}

std::vector<MusclePaths> place_muscles(const Drawings& drawings, const SkinSites& sites,
                                       const std::vector<Vec3>& outer,
                                       const std::vector<Vec3>& inner, Problems& problems) {
  const Tissue tissue(sites, outer, inner);
  std::vector<MusclePaths> muscles;
  for (const DrawnMuscle& muscle : drawings.muscles) {
    MusclePaths& paths = muscles.emplace_back(
        MusclePaths{muscle.name, muscle.meaning, {}, muscle.width, muscle.thickness});
    for (const DrawnFibre& fibre : drawings.fibres) {
      if (fibre.muscle != muscle.name) continue;
      Placed right = tissue.place(fibre, problems);
      if (right.points.size() < 2) continue;  // beside the face
      if (fibre.form == FibreForm::ring) {
        paths.paths.push_back(path_of(closed_ring(std::move(right)), Side::middle, true));
        continue;
      }
      const bool closed = fibre.form == FibreForm::loop;
      paths.paths.push_back(path_of(mirror_image(right), Side::left, closed));
      paths.paths.push_back(path_of(std::move(right), Side::right, closed));
    }
  }
  return muscles;
}

}  // namespace facies::anatomy
