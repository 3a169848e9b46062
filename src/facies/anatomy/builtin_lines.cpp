// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

namespace facies::anatomy {
namespace {

constexpr double longest_piece = 1.0;  // in the frontal view [mm]
/// Pieces are followed closely, and corners of the drawn curves are rounded over about a millimetre [1/mm].
constexpr double adherence = 1.0;

DrawnPoint between(const DrawnPoint& a, const DrawnPoint& b, double part) {
  return {std::lerp(a.lateral, b.lateral, part), std::lerp(a.up, b.up, part), 0.0,
          part < 0.5 ? a.where : b.where};
}

/// The stretch from a to b cut into short pieces, on one side (1 right, -1 left). Nothing where it leaves the face, and a problem for the
/// right side: the drawing is symmetric.
std::vector<mesh::LinePiece> pieces_between(const DrawnPoint& a, const DrawnPoint& b, int side,
                                            const SkinSites& sites, const std::vector<Vec3>& outer,
                                            Problems& problems) {
  const double length = std::hypot(b.lateral - a.lateral, b.up - a.up);
  const int n = std::max(1, static_cast<int>(std::ceil(length / longest_piece)));
  // Beginning, middle, end of one piece, middle of the next ...
  std::vector<SkinSite> places;
  for (int i = 0; i <= 2 * n; ++i) {
    const DrawnPoint point = between(a, b, 0.5 * i / n);
    const std::optional<SkinSite> site = sites.find(side * point.lateral, point.up);
    if (!site) {
      if (side == 1) problems.add(beside_the_face(point));
      return {};
    }
    places.push_back(*site);
  }
  std::vector<mesh::LinePiece> pieces;
  for (std::size_t i = 1; i < places.size(); i += 2) {
    pieces.push_back(
        {places[i].vertices, places[i].parts, places[i + 1].on(outer) - places[i - 1].on(outer)});
  }
  return pieces;
}

/// The principal axis of a sum of axes v v^T.
Vec3 principal_axis(const Mat3& sum) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(sum).eigenvectors().col(2);
}

}  // namespace

std::vector<mesh::LinePiece> place_lines(const Drawings& drawings, const SkinSites& sites,
                                         const std::vector<Vec3>& outer, Problems& problems) {
  std::vector<mesh::LinePiece> all;
  for (const std::vector<DrawnPoint>& curve : drawings.tension_lines) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      for (const int side : {1, -1}) {
        const auto pieces = pieces_between(curve[i], curve[i + 1], side, sites, outer, problems);
        all.insert(all.end(), pieces.begin(), pieces.end());
      }
    }
  }
  return all;
}

mesh::LineField tension_lines(const SkinSites& sites, const std::vector<Vec3>& outer,
                              const std::vector<mesh::LinePiece>& pieces) {
  return mesh::smooth_line_field(sites.refined().net, outer, pieces, adherence);
}

std::vector<Vec3> line_directions(const mesh::Mesh& mesh, const SkinSites& sites,
                                  const mesh::LineField& lines) {
  // Refinement puts the four parts of quadrilateral q at 4 q to 4 q + 3, and a shell has its elements in the order of the net's
  // quadrilaterals, layer by layer.
  const auto& quads = sites.refined().net.quads;
  const std::size_t n_columns = mesh.faces("outer").size();
  std::vector<Vec3> directions(mesh.n_elements(), Vec3::UnitY());
  for (const Index e : mesh.elements("skin")) {
    const std::size_t column = at(e) % n_columns;
    const std::size_t first = column * quads.size() / n_columns;
    const std::size_t n = std::max<std::size_t>(1, quads.size() / n_columns);
    Mat3 sum = Mat3::Zero();
    for (std::size_t q = first; q < first + n; ++q) {
      for (const Index v : quads[q])
        sum +=
            lines.strength[at(v)] * lines.directions[at(v)] * lines.directions[at(v)].transpose();
    }
    directions[at(e)] = principal_axis(sum);
  }
  return directions;
}

}  // namespace facies::anatomy
