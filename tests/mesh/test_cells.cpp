// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include "support/random.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/mesh/cells.hpp"

namespace facies::mesh {
namespace {

class EveryCell : public ::testing::TestWithParam<CellType> {
 protected:
  CellType type = GetParam();

  /// A point inside the cell.
  Vec3 inside(support::Random& random) const {
    Vec3 xi = random.vector(-1.0, 1.0);
    if (type == CellType::wedge6) {
      xi(0) = random.uniform(0.0, 1.0);
      xi(1) = random.uniform(0.0, 1.0 - xi(0));
    }
    return xi;
  }
};

INSTANTIATE_TEST_SUITE_P(Cells, EveryCell, ::testing::Values(CellType::hex8, CellType::wedge6),
                         [](const auto& cell) { return std::string(name(cell.param)); });

TEST_P(EveryCell, HasShapeFunctionsThatAreOneAtTheirNodeAndZeroAtTheOthers) {
  for (std::size_t i = 0; i < n_nodes(type); ++i) {
    const ShapeValues N = shape_values(type, node_xi(type, i));
    for (std::size_t j = 0; j < max_nodes; ++j) {
      EXPECT_NEAR(N(Eigen::Index(j)), i == j ? 1.0 : 0.0, 1e-15) << i << ' ' << j;
    }
  }
}

TEST_P(EveryCell, SumsItsShapeFunctionsToOneEverywhere) {
  support::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 xi = inside(random);
    const ShapeValues N = shape_values(type, xi);
    const ShapeGradients dN = shape_gradients(type, xi);
    double sum = 0.0;
    Vec3 slopes = Vec3::Zero();
    for (Eigen::Index n = 0; n < N.size(); ++n) {
      sum += N(n);
      slopes += dN.row(n);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LT(slopes.norm(), 1e-14);
  }
}

TEST_P(EveryCell, ReproducesItsPolynomials) {
  // Everything in {1, r, s} x {1, zeta}, and r s and r s zeta for the hexahedron.
  const double bilinear = type == CellType::hex8 ? 1.0 : 0.0;
  const auto f = [&](const Vec3& p) {
    return 2.0 - p(0) + 3.0 * p(1) + 0.5 * p(2) + 4.0 * p(0) * p(2) - 2.0 * p(1) * p(2) +
           bilinear * (5.0 * p(0) * p(1) - 7.0 * p(0) * p(1) * p(2));
  };
  const auto gradient = [&](const Vec3& p) {
    return Vec3(-1.0 + 4.0 * p(2) + bilinear * (5.0 * p(1) - 7.0 * p(1) * p(2)),
                3.0 - 2.0 * p(2) + bilinear * (5.0 * p(0) - 7.0 * p(0) * p(2)),
                0.5 + 4.0 * p(0) - 2.0 * p(1) - bilinear * 7.0 * p(0) * p(1));
  };
  ShapeValues nodal = ShapeValues::Zero();
  for (std::size_t i = 0; i < n_nodes(type); ++i)
    nodal(Eigen::Index(i)) = f(node_xi(type, i));
  support::Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 xi = inside(random);
    const ShapeValues N = shape_values(type, xi);
    const ShapeGradients dN = shape_gradients(type, xi);
    double value = 0.0;
    Vec3 slope = Vec3::Zero();
    for (Eigen::Index i = 0; i < N.size(); ++i) {
      value += N(i) * nodal(i);
      slope += dN.row(i) * nodal(i);
    }
    EXPECT_NEAR(value, f(xi), 1e-13);
    EXPECT_LT((slope - gradient(xi)).norm(), 1e-13);
  }
}

TEST_P(EveryCell, LooksOutOfItselfThroughEveryFace) {
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < n_nodes(type); ++i)
    centre += node_xi(type, i) / double(n_nodes(type));
  Vec3 sum = Vec3::Zero();
  for (const auto& face : faces(type)) {
    const Vec3 a = node_xi(type, face[0]);
    const Vec3 diagonal = node_xi(type, face[2]) - a;
    const Vec3 other = node_xi(type, face.back()) - node_xi(type, face[1]);
    const Vec3 area = 0.5 * diagonal.cross(other);
    EXPECT_GT(area.dot(a - centre), 0.0);
    sum += area;
  }
  EXPECT_LT(sum.norm(), 1e-15);
}

TEST_P(EveryCell, HasEachEdgeInExactlyTwoFaces) {
  std::set<std::set<std::uint8_t>> listed;
  for (const auto& edge : edges(type)) {
    listed.insert({edge[0], edge[1]});
    int uses = 0;
    for (const auto& face : faces(type)) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::set<std::uint8_t> side{face[i], face[(i + 1) % face.size()]};
        uses += side == std::set<std::uint8_t>{edge[0], edge[1]} ? 1 : 0;
      }
    }
    EXPECT_EQ(uses, 2);
  }
  // Euler: nodes - edges + faces = 2.
  EXPECT_EQ(n_nodes(type) + faces(type).size(), listed.size() + 2);
}

double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

double line_integral(int power) {
  return power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
}

double integral_by_rule(CellType type, int a, int b, int c) {
  double sum = 0.0;
  for (const QuadraturePoint& point : quadrature(type)) {
    sum += point.weight * std::pow(point.xi(0), a) * std::pow(point.xi(1), b) *
           std::pow(point.xi(2), c);
  }
  return sum;
}

TEST(HexQuadrature, IsExactToDegreeThreeInEachCoordinate) {
  EXPECT_EQ(quadrature(CellType::hex8).size(), 8U);
  for (int a = 0; a <= 3; ++a) {
    for (int b = 0; b <= 3; ++b) {
      for (int c = 0; c <= 3; ++c) {
        EXPECT_NEAR(integral_by_rule(CellType::hex8, a, b, c),
                    line_integral(a) * line_integral(b) * line_integral(c), 1e-14);
      }
    }
  }
  EXPECT_GT(std::abs(integral_by_rule(CellType::hex8, 4, 0, 0) - 4.0 * line_integral(4)), 0.1);
}

TEST(WedgeQuadrature, IsExactToDegreeTwoInTheTriangleAndThreeAlongZeta) {
  EXPECT_EQ(quadrature(CellType::wedge6).size(), 6U);
  for (int a = 0; a <= 2; ++a) {
    for (int b = 0; a + b <= 2; ++b) {
      for (int c = 0; c <= 3; ++c) {
        // Integral of r^a s^b over the unit triangle: a! b! / (a + b + 2)!
        const double triangle = factorial(a) * factorial(b) / factorial(a + b + 2);
        EXPECT_NEAR(integral_by_rule(CellType::wedge6, a, b, c), triangle * line_integral(c),
                    1e-15);
      }
    }
  }
}

TEST_P(EveryCell, KeepsTheShapeFunctionsOfItsQuadraturePoints) {
  for (const QuadraturePoint& point : quadrature(type)) {
    EXPECT_EQ(point.N, shape_values(type, point.xi));
    EXPECT_EQ(point.dN_dxi, shape_gradients(type, point.xi));
    EXPECT_GT(point.weight, 0.0);
  }
}

}  // namespace
}  // namespace facies::mesh
