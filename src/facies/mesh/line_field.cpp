// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/line_field.hpp"

#include <cmath>
#include <complex>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "facies/base/error.hpp"

namespace facies::mesh {
namespace {

using Complex = std::complex<double>;
using Triplets = std::vector<Eigen::Triplet<Complex>>;

/// Axes in which the directions at a vertex are complex numbers: `real` + i (normal x real).
struct Frame {
  Vec3 normal, real;

  [[nodiscard]] Complex number(const Vec3& v) const {
    return {v.dot(real), v.dot(normal.cross(real))};
  }
  [[nodiscard]] Vec3 direction(Complex z) const {
    return z.real() * real + z.imag() * normal.cross(real);
  }
};

std::vector<Frame> frames_of(const QuadNet& net, std::span<const Vec3> X) {
  std::vector<Vec3> normals(X.size(), Vec3::Zero());
  for (const auto& [a, b, c, d] : net.quads) {
    const Vec3 area = (X[at(c)] - X[at(a)]).cross(X[at(d)] - X[at(b)]);
    for (const Index v : {a, b, c, d})
      normals[at(v)] += area;
  }
  std::vector<Frame> frames;
  for (const Vec3& n : normals) {
    const Vec3 normal = n.normalized();
    frames.push_back({normal, normal.unitOrthogonal()});
  }
  return frames;
}

/// Twice the angle, and the length of the line as it is.
Complex doubled(Complex z) {
  return std::abs(z) > 0.0 ? z * z / std::abs(z) : 0.0;
}

/// What a doubled number at `from` is at `to`: rolled there without turning about the normal.
Complex transport(const Frame& from, const Frame& to) {
  const auto roll = Eigen::Quaterniond::FromTwoVectors(from.normal, to.normal);
  return doubled(to.number(roll * from.real));
}

double cotangent(const Vec3& a, const Vec3& b) {
  return a.dot(b) / a.cross(b).norm();
}

/// Adds |grad z|^2 of the linear function on a triangle, `share` of it (cotangents; pinkall1993).
void add_triangle(const std::array<Index, 3>& triangle, std::span<const Vec3> X,
                  const std::vector<Frame>& frames, double share, Triplets& terms) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index o = triangle.at(k);
    const Index i = triangle.at((k + 1) % 3);
    const Index j = triangle.at((k + 2) % 3);
    const double w = 0.5 * share * cotangent(X[at(i)] - X[at(o)], X[at(j)] - X[at(o)]);
    const Complex i_to_j = transport(frames[at(i)], frames[at(j)]);
    terms.emplace_back(i, i, w);
    terms.emplace_back(j, j, w);
    terms.emplace_back(j, i, -w * i_to_j);
    terms.emplace_back(i, j, -w * std::conj(i_to_j));
  }
}

}  // namespace

LineField smooth_line_field(const QuadNet& net, std::span<const Vec3> X,
                            std::span<const LinePiece> pieces, double adherence) {
  require(to_index(X.size()) == net.n_vertices, "a line field needs a point for every vertex");
  require(!pieces.empty(), "a line field needs a line");
  const std::vector<Frame> frames = frames_of(net, X);
  Triplets terms;
  // Half of each of both ways to cut a quadrilateral, so that mirror images are treated alike.
  for (const auto& [a, b, c, d] : net.quads) {
    for (const std::array<Index, 3>& half : {std::array{a, b, c}, {a, c, d}, {a, b, d}, {b, c, d}})
      add_triangle(half, X, frames, 0.5, terms);
  }
  Eigen::VectorXcd pull = Eigen::VectorXcd::Zero(net.n_vertices);
  for (const LinePiece& piece : pieces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = piece.vertices.at(k);
      const double weight = adherence * piece.parts[static_cast<Index>(k)];
      terms.emplace_back(v, v, weight * piece.along.norm());
      pull[v] += weight * doubled(frames[at(v)].number(piece.along));
    }
  }
  Eigen::SparseMatrix<Complex> matrix(net.n_vertices, net.n_vertices);
  matrix.setFromTriplets(terms.begin(), terms.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver(matrix);
  require(solver.info() == Eigen::Success, "a surface with a flat corner has no line field");
  const Eigen::VectorXcd z = solver.solve(pull);
  LineField field;
  for (Index v = 0; v < net.n_vertices; ++v) {
    field.directions.push_back(frames[at(v)].direction(std::polar(1.0, 0.5 * std::arg(z[v]))));
    field.strength.push_back(std::abs(z[v]));
  }
  return field;
}

}  // namespace facies::mesh
