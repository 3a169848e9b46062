// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "facies/math/dual2.hpp"

namespace facies {
namespace {

using Dual = Dual2<2>;

constexpr double x0 = 1.3;
constexpr double y0 = 0.7;
const Dual x = Dual::variable(x0, 0);
const Dual y = Dual::variable(y0, 1);

/// f with f_x, f_y, f_xx, f_xy, f_yy from pen and paper.
void expect_derivatives(const Dual& f, double value, double fx, double fy, double fxx, double fxy,
                        double fyy) {
  constexpr double tolerance = 1e-13;
  EXPECT_NEAR(f.value, value, tolerance);
  EXPECT_NEAR(f.gradient(0), fx, tolerance);
  EXPECT_NEAR(f.gradient(1), fy, tolerance);
  EXPECT_NEAR(f.hessian(0, 0), fxx, tolerance);
  EXPECT_NEAR(f.hessian(0, 1), fxy, tolerance);
  EXPECT_NEAR(f.hessian(1, 0), fxy, tolerance);
  EXPECT_NEAR(f.hessian(1, 1), fyy, tolerance);
}

TEST(Dual2, DifferentiatesSumsAndDifferences) {
  expect_derivatives(x + y - 2.0 * x, y0 - x0, -1, 1, 0, 0, 0);
  expect_derivatives(3.0 - x + (2.0 + y) - 1.0, 4.0 - x0 + y0, -1, 1, 0, 0, 0);
  expect_derivatives(-x, -x0, -1, 0, 0, 0, 0);
  expect_derivatives(+x, x0, 1, 0, 0, 0, 0);
}

TEST(Dual2, DifferentiatesProducts) {
  expect_derivatives(x * x * y, x0 * x0 * y0, 2 * x0 * y0, x0 * x0, 2 * y0, 2 * x0, 0);
  expect_derivatives(x * 4.0, 4 * x0, 4, 0, 0, 0, 0);
}

TEST(Dual2, DifferentiatesQuotients) {
  expect_derivatives(x / y, x0 / y0, 1 / y0, -x0 / (y0 * y0), 0, -1 / (y0 * y0),
                     2 * x0 / (y0 * y0 * y0));
  expect_derivatives(2.0 / x, 2 / x0, -2 / (x0 * x0), 0, 4 / (x0 * x0 * x0), 0, 0);
  expect_derivatives(x / 4.0, x0 / 4, 0.25, 0, 0, 0, 0);
}

TEST(Dual2, DifferentiatesTheExponential) {
  const double e = std::exp(x0 * y0);
  expect_derivatives(exp(x * y), e, y0 * e, x0 * e, y0 * y0 * e, (1 + x0 * y0) * e, x0 * x0 * e);
  expect_derivatives(expm1(x * y), std::expm1(x0 * y0), y0 * e, x0 * e, y0 * y0 * e,
                     (1 + x0 * y0) * e, x0 * x0 * e);
}

TEST(Dual2, DifferentiatesTheLogarithm) {
  const double s = x0 + 2 * y0;
  expect_derivatives(log(x + 2.0 * y), std::log(s), 1 / s, 2 / s, -1 / (s * s), -2 / (s * s),
                     -4 / (s * s));
}

TEST(Dual2, DifferentiatesPowers) {
  expect_derivatives(pow(x, -2.0 / 3.0), std::pow(x0, -2.0 / 3.0),
                     -2.0 / 3.0 * std::pow(x0, -5.0 / 3.0), 0,
                     10.0 / 9.0 * std::pow(x0, -8.0 / 3.0), 0, 0);
  expect_derivatives(sqrt(x * y), std::sqrt(x0 * y0), 0.5 * std::sqrt(y0 / x0),
                     0.5 * std::sqrt(x0 / y0), -0.25 * std::sqrt(y0 / x0) / x0,
                     0.25 / std::sqrt(x0 * y0), -0.25 * std::sqrt(x0 / y0) / y0);
}

TEST(Dual2, ConstantsHaveNoDerivatives) {
  expect_derivatives(Dual(5.0), 5, 0, 0, 0, 0, 0);
}

}  // namespace
}  // namespace facies
