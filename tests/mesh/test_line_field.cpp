// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mesh/line_field.hpp"

namespace facies::mesh {
namespace {

constexpr double pi = std::numbers::pi;

/// n x n squares; vertex i (n + 1) + j at `place`(i / n, j / n).
struct Sheet {
  Index n;
  QuadNet net;
  std::vector<Vec3> X;

  template <class Place>
  Sheet(Index n_squares, const Place& place) : n(n_squares) {
    net.n_vertices = (n + 1) * (n + 1);
    for (Index i = 0; i <= n; ++i) {
      for (Index j = 0; j <= n; ++j)
        X.push_back(place(static_cast<double>(i) / n, static_cast<double>(j) / n));
    }
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j)
        net.quads.push_back(
            {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  [[nodiscard]] Index vertex(Index i, Index j) const { return i * (n + 1) + j; }
};

LinePiece piece_at(Index v, const Vec3& along) {
  return {{v, v, v}, Vec3(1.0, 0.0, 0.0), along};
}

/// The angle between two lines.
double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Vec3 at_angle(double angle) {
  return {std::cos(angle), std::sin(angle), 0.0};
}

Vec3 flat(double s, double t) {
  return {20.0 * s - 10.0, 20.0 * t - 10.0, 0.0};
}

TEST(LineField, OfParallelLinesIsParallel) {
  const Sheet sheet(8, flat);
  const std::vector<LinePiece> pieces{piece_at(3, at_angle(1.0)),
                                      piece_at(60, -2.0 * at_angle(1.0))};
  const LineField field = smooth_line_field(sheet.net, sheet.X, pieces, 1.0);
  for (std::size_t v = 0; v < sheet.X.size(); ++v) {
    EXPECT_LT(angle_between(field.directions[v], at_angle(1.0)), 1e-9);
    EXPECT_NEAR(field.directions[v].norm(), 1.0, 1e-12);
    EXPECT_NEAR(field.strength[v], 1.0, 1e-9);
  }
}

// Harmonic between two borders: twice the angle belongs to a number that is linear across.
TEST(LineField, BetweenTwoBordersIsTheHarmonicOne) {
  const Sheet sheet(8, flat);
  const double a = 0.3;
  const double b = 1.4;
  std::vector<LinePiece> pieces;
  for (Index j = 0; j <= sheet.n; ++j) {
    pieces.push_back(piece_at(sheet.vertex(0, j), at_angle(a)));
    pieces.push_back(piece_at(sheet.vertex(sheet.n, j), at_angle(b)));
  }
  const LineField field = smooth_line_field(sheet.net, sheet.X, pieces, 1e9);
  for (Index i = 0; i <= sheet.n; ++i) {
    const double part = static_cast<double>(i) / sheet.n;
    const double re = (1.0 - part) * std::cos(2.0 * a) + part * std::cos(2.0 * b);
    const double im = (1.0 - part) * std::sin(2.0 * a) + part * std::sin(2.0 * b);
    for (Index j = 0; j <= sheet.n; ++j) {
      const Index v = sheet.vertex(i, j);
      EXPECT_LT(angle_between(field.directions[at(v)], at_angle(0.5 * std::atan2(im, re))), 1e-7);
      EXPECT_NEAR(field.strength[at(v)], std::hypot(re, im), 1e-7);
    }
  }
}

// Around a loop whose lines make half a turn, the harmonic number is x + i y: half the polar angle, no strength in the middle.
TEST(LineField, WithHalfATurnAroundHasItsSingularPointInTheMiddle) {
  const Sheet sheet(8, flat);
  std::vector<LinePiece> pieces;
  for (Index k = 0; k <= sheet.n; ++k) {
    for (const Index v : {sheet.vertex(0, k), sheet.vertex(sheet.n, k), sheet.vertex(k, 0),
                          sheet.vertex(k, sheet.n)}) {
      const Vec3& x = sheet.X[at(v)];
      pieces.push_back(piece_at(v, at_angle(0.5 * std::atan2(x.y(), x.x()))));
    }
  }
  const LineField field = smooth_line_field(sheet.net, sheet.X, pieces, 1e9);
  EXPECT_NEAR(field.strength[at(sheet.vertex(4, 4))], 0.0, 1e-9);
  for (std::size_t v = 0; v < sheet.X.size(); ++v) {
    const Vec3& x = sheet.X[v];
    if (x.norm() < 1.0) continue;
    EXPECT_GT(field.strength[v], 0.1);
    // Exact on the axes and diagonals of the square; between them the square's corners pull a little.
    EXPECT_LT(angle_between(field.directions[v], at_angle(0.5 * std::atan2(x.y(), x.x()))), 0.05);
  }
}

// A cylinder can be unrolled: one piece of a helix at one end makes helices everywhere.
TEST(LineField, OnACylinderIsThatOfTheUnrolledSheet) {
  static constexpr double radius = 5.0;
  const Sheet sheet(24, [](double s, double t) {
    return Vec3(radius * std::cos(pi * s), radius * std::sin(pi * s), 10.0 * t);
  });
  const auto helix = [](const Vec3& x) {
    return Vec3(0.8 * Vec3(-x.y(), x.x(), 0.0) / radius + 0.6 * Vec3::UnitZ());
  };
  const std::vector<LinePiece> pieces{piece_at(0, helix(sheet.X[0]))};
  const LineField field = smooth_line_field(sheet.net, sheet.X, pieces, 1.0);
  for (Index i = 1; i < sheet.n; ++i) {
    const Index v = sheet.vertex(i, 7);
    // The normal at the sheet's border is that of the last squares, half a square from the cylinder's.
    EXPECT_LT(angle_between(field.directions[at(v)], helix(sheet.X[at(v)])), 0.01);
    EXPECT_NEAR(field.strength[at(v)], 1.0, 0.01);
  }
}

TEST(LineField, OfAMirrorImageIsTheMirrorImage) {
  const auto bumpy = [](double s, double t) {
    return Vec3(20.0 * s + 2.0 * t * t, 15.0 * t + 3.0 * s * t, 4.0 * std::sin(3.0 * s + t));
  };
  const auto mirrored = [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); };
  const Sheet sheet(9, bumpy);
  Sheet image(9, [&](double s, double t) { return mirrored(bumpy(s, t)); });
  for (auto& quad : image.net.quads)
    std::swap(quad[1], quad[3]);
  std::vector<LinePiece> pieces{{{4, 5, 14}, Vec3(0.2, 0.3, 0.5), Vec3(1.0, 0.3, 0.2)},
                                {{70, 71, 80}, Vec3(0.6, 0.4, 0.0), Vec3(-0.2, 0.7, 0.1)}};
  const LineField field = smooth_line_field(sheet.net, sheet.X, pieces, 0.5);
  for (LinePiece& piece : pieces)
    piece.along = mirrored(piece.along);
  const LineField other = smooth_line_field(image.net, image.X, pieces, 0.5);
  for (std::size_t v = 0; v < sheet.X.size(); ++v) {
    EXPECT_LT(angle_between(mirrored(field.directions[v]), other.directions[v]), 1e-9);
    EXPECT_NEAR(field.strength[v], other.strength[v], 1e-9);
  }
}

TEST(LineField, NeedsAPointForEachVertexAndALine) {
  const Sheet sheet(2, flat);
  const std::vector<LinePiece> pieces{piece_at(0, Vec3::UnitX())};
  EXPECT_THROW((void)smooth_line_field(sheet.net, {}, pieces, 1.0), BugError);
  EXPECT_THROW((void)smooth_line_field(sheet.net, sheet.X, {}, 1.0), BugError);
}

}  // namespace
}  // namespace facies::mesh
