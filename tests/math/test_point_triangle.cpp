// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/random.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/math/point_triangle.hpp"

namespace facies {
namespace {

using support::Random;
using Vec12 = Eigen::Matrix<double, 12, 1>;

/// p, a, b, c.
using Points = std::array<Vec3, 4>;

Vec12 stacked(const Points& x) {
  Vec12 all;
  all << x[0], x[1], x[2], x[3];
  return all;
}

Points unstacked(const Vec12& x) {
  return {x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x.segment<3>(9)};
}

ClosestOnTriangle closest(const Points& x) {
  return closest_on_triangle(x[0], x[1], x[2], x[3]);
}

DistanceResponse response(const Points& x) {
  return distance_response(x[0], x[1], x[2], x[3]);
}

/// A triangle in the plane z = 0 and a point above each of its seven regions, far from their boundaries.
constexpr std::array<TriangleFeature, 7> features{
    TriangleFeature::face,    TriangleFeature::edge0,   TriangleFeature::edge1,
    TriangleFeature::edge2,   TriangleFeature::vertex0, TriangleFeature::vertex1,
    TriangleFeature::vertex2,
};

Points above(TriangleFeature feature) {
  const Vec3 a(0.0, 0.0, 0.0);
  const Vec3 b(4.0, 0.5, 0.0);
  const Vec3 c(1.0, 3.0, 0.0);
  const std::array<Vec3, 7> over{Vec3(1.5, 1.2, 0.7),  Vec3(2.0, -0.8, 0.5),  Vec3(3.2, 2.4, -0.6),
                                 Vec3(-0.5, 1.8, 0.4), Vec3(-1.0, -0.9, 0.8), Vec3(5.0, 0.3, -0.9),
                                 Vec3(0.9, 4.0, 1.1)};
  return {over[std::size_t(feature)], a, b, c};
}

/// How far from optimal a closest point is: zero where no vertex lies nearer to p along p - q (the variational
/// inequality, which holds for the closest point of a convex set and for no other).
double excess(const Points& x, const ClosestOnTriangle& found) {
  const Vec3 q =
      found.barycentric(0) * x[1] + found.barycentric(1) * x[2] + found.barycentric(2) * x[3];
  double worst = 0.0;
  for (std::size_t i = 1; i < 4; ++i)
    worst = std::max(worst, (x[0] - q).dot(x[i] - q));
  return worst;
}

TEST(ClosestOnTriangle, NamesTheNearestFeature) {
  for (const TriangleFeature feature : features)
    EXPECT_EQ(closest(above(feature)).feature, feature);
}

TEST(ClosestOnTriangle, IsTheOnlyPointThatNoVertexIsNearerThan) {
  Random random(1);
  std::array<int, 7> met{};
  for (int i = 0; i < 20000; ++i) {
    const Points x{random.vector(-1.5, 1.5), random.vector(-1.0, 1.0), random.vector(-1.0, 1.0),
                   random.vector(-1.0, 1.0)};
    const ClosestOnTriangle found = closest(x);
    ++met[std::size_t(found.feature)];
    ASSERT_LT(excess(x, found), 1e-12);
    ASSERT_GE(found.barycentric.minCoeff(), 0.0);
    ASSERT_NEAR(found.barycentric.sum(), 1.0, 1e-15);
    const Vec3 q = x[0] - found.offset;
    ASSERT_LT((found.barycentric(0) * x[1] + found.barycentric(1) * x[2] +
               found.barycentric(2) * x[3] - q)
                  .norm(),
              1e-10);
    ASSERT_DOUBLE_EQ(found.distance_squared, found.offset.squaredNorm());
  }
  EXPECT_GT(*std::ranges::min_element(met), 100);
}

TEST(ClosestOnTriangle, IsAsGoodForTrianglesWithoutArea) {
  Random random(2);
  for (const double height : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
    for (int i = 0; i < 2000; ++i) {
      const Vec3 a = random.vector(-1.0, 1.0);
      const Vec3 b = random.vector(-1.0, 1.0);
      const Vec3 c = a + random.uniform(-0.5, 1.5) * (b - a) + height * random.unit_vector();
      const Points x{random.vector(-1.5, 1.5), a, b, c};
      const ClosestOnTriangle found = closest(x);
      ASSERT_LT(excess(x, found), 2e-8) << height;
      ASSERT_GE(found.barycentric.minCoeff(), 0.0);
    }
  }
  const Vec3 point(1.0, 2.0, 3.0);
  const ClosestOnTriangle found = closest({point + Vec3(0.0, 3.0, 4.0), point, point, point});
  EXPECT_DOUBLE_EQ(found.distance_squared, 25.0);
  EXPECT_EQ(found.feature, TriangleFeature::vertex0);
}

TEST(ClosestOnTriangle, FindsAPointOfTheTriangleAtDistanceZero) {
  const Points x = above(TriangleFeature::face);
  const Vec3 inside = 0.2 * x[1] + 0.3 * x[2] + 0.5 * x[3];
  EXPECT_LT(closest({inside, x[1], x[2], x[3]}).distance_squared, 1e-30);
  EXPECT_EQ(closest({x[2], x[1], x[2], x[3]}).distance_squared, 0.0);
}

TEST(ClosestOnTriangle, TellsADistanceFarBelowTheSizeOfTheTriangle) {
  const Points x = above(TriangleFeature::face);
  for (const double height : {1e-3, 1e-7, 1e-11}) {
    const ClosestOnTriangle found = closest({Vec3(1.5, 1.2, height), x[1], x[2], x[3]});
    EXPECT_NEAR(std::sqrt(found.distance_squared) / height, 1.0, 1e-12);
    EXPECT_LT((found.offset.normalized() - Vec3::UnitZ()).norm(), 1e-14);
  }
}

TEST(IsFlat, HoldsForNeedlesAndPointsOnly) {
  const Vec3 a(0.0, 0.0, 0.0);
  const Vec3 b(100.0, 0.0, 0.0);
  EXPECT_TRUE(is_flat(a, a, a));
  EXPECT_TRUE(is_flat(a, b, b));
  EXPECT_TRUE(is_flat(a, b, Vec3(30.0, 1e-7, 0.0)));
  EXPECT_FALSE(is_flat(a, b, Vec3(30.0, 1e-5, 0.0)));
  EXPECT_FALSE(is_flat(a, 1e-9 * b, Vec3(0.0, 1e-7, 0.0)));
}

TEST(DistanceResponse, HasTheSlopesOfTheDistanceInEveryRegion) {
  Random random(3);
  for (const TriangleFeature feature : features) {
    const Points x = above(feature);
    const DistanceResponse at_x = response(x);
    EXPECT_DOUBLE_EQ(at_x.d, std::sqrt(closest(x).distance_squared));
    for (int i = 0; i < 5; ++i) {
      const Vec12 dx = stacked(
          {random.unit_vector(), random.unit_vector(), random.unit_vector(), random.unit_vector()});
      const auto moved = [&](double h) {
        const Points y = unstacked(stacked(x) + h * dx);
        EXPECT_EQ(closest(y).feature, feature);
        return response(y);
      };
      EXPECT_GT(
          support::remainder_slope([&](double h) { return moved(h).d; }, at_x.gradient.dot(dx)),
          1.9);
      EXPECT_GT(
          support::remainder_slope([&](double h) { return Eigen::VectorXd(moved(h).gradient); },
                                   Eigen::VectorXd(at_x.hessian * dx)),
          1.9);
    }
  }
}

TEST(DistanceResponse, HasASymmetricHessian) {
  for (const TriangleFeature feature : features) {
    const auto H = response(above(feature)).hessian;
    EXPECT_LT((H - H.transpose()).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(DistanceResponse, TurnsWithTheFourPoints) {
  Random random(4);
  for (const TriangleFeature feature : features) {
    const Points x = above(feature);
    const Mat3 R = random.rotation();
    const Vec3 shift = random.vector(-50.0, 50.0);
    Points y;
    std::ranges::transform(x, y.begin(), [&](const Vec3& v) { return Vec3(R * v + shift); });
    const DistanceResponse at_x = response(x);
    const DistanceResponse at_y = response(y);
    EXPECT_NEAR(at_y.d, at_x.d, 1e-13);
    for (Eigen::Index i = 0; i < 12; i += 3) {
      const Vec3 turned = R * at_x.gradient.segment<3>(i);
      EXPECT_LT((at_y.gradient.segment<3>(i) - turned).norm(), 1e-12);
      for (Eigen::Index j = 0; j < 12; j += 3) {
        const Mat3 block = R * at_x.hessian.block<3, 3>(i, j) * R.transpose();
        EXPECT_LT((at_y.hessian.block<3, 3>(i, j) - block).cwiseAbs().maxCoeff(), 1e-12);
      }
    }
  }
}

TEST(DistanceResponse, ExertsNeitherForceNorMomentAsAWhole) {
  for (const TriangleFeature feature : features) {
    const Points x = above(feature);
    const Vec12 g = response(x).gradient;
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 f = g.segment<3>(Eigen::Index(3 * i));
      force += f;
      moment += Vec3(x[i].y() * f.z() - x[i].z() * f.y(), x[i].z() * f.x() - x[i].x() * f.z(),
                     x[i].x() * f.y() - x[i].y() * f.x());
    }
    EXPECT_LT(force.norm(), 1e-15);
    EXPECT_LT(moment.norm(), 1e-14);
  }
}

TEST(DistanceResponse, HasAContinuousGradientAcrossRegions) {
  // From above the face straight through every boundary between regions: walks around the triangle at two heights.
  const Points triangle = above(TriangleFeature::face);
  const auto jump = [&](double step) {
    double largest = 0.0;
    for (const double height : {0.3, 1.5}) {
      for (int line = 0; line < 20; ++line) {
        Points x = triangle;
        const double angle = 0.3 + 0.31 * line;
        const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
        Vec12 before = Vec12::Zero();
        for (int i = 0; i * step <= 8.0; ++i) {
          x[0] = Vec3(1.6, 1.1, height) + (i * step - 4.0) * along;
          const Vec12 g = response(x).gradient;
          if (i > 0) largest = std::max(largest, (g - before).norm());
          before = g;
        }
      }
    }
    return largest;
  };
  // The gradient changes by no more than its largest slope times the step, wherever the step crosses a boundary.
  EXPECT_LT(jump(1e-2), 0.1);
  EXPECT_LT(jump(1e-3), 0.01);
}

TEST(DistanceResponse, StaysBoundedOverAFaceAtContact) {
  Points x = above(TriangleFeature::face);
  x[0].z() = 1e-9;
  EXPECT_LT(response(x).hessian.cwiseAbs().maxCoeff(), 2.0);
}

TEST(DistanceResponse, IsRefusedAtContact) {
  const Points x = above(TriangleFeature::face);
  EXPECT_THROW((void)distance_response(x[1], x[1], x[2], x[3]), BugError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)distance_response(Vec3(nan, 0.0, 0.0), x[1], x[2], x[3]), BugError);
}

}  // namespace
}  // namespace facies
