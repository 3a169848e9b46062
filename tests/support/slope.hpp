// SPDX-License-Identifier: Apache-2.0
// Is df the derivative of f? Decided by how fast the Taylor remainder falls, not by one chosen difference step.
#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/Core>

namespace facies::support {

/// A . B, the sum of the products of their entries. Plain loops: the vectorised sums of Eigen draw false warnings from
/// g++ 12 with AVX-512.
template <class A, class B>
double inner_product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  double sum = 0.0;
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      sum += a.derived().coeff(i, j) * b.derived().coeff(i, j);
  }
  return sum;
}

/// Euclidean (Frobenius) norm.
template <class A>
double norm_of(const Eigen::MatrixBase<A>& a) {
  const typename A::PlainObject values = a;
  return std::sqrt(inner_product(values, values));
}

/// The slope of log |f(h) - f(0) - h df| over log h, from `h_max` down over three decades of h.
/// It is 2 where df = f'(0) and 1 where it is not. Decades in which the remainder is mere rounding are left out;
/// infinity where all are (f is linear, and df its derivative). Steps h should be seen beside a state of size 1.
inline double remainder_slope(const std::function<Eigen::VectorXd(double)>& f,
                              const Eigen::VectorXd& df, double h_max = 1e-2) {
  const Eigen::VectorXd f0 = f(0.0);
  const auto remainder = [&](double h) {
    Eigen::VectorXd r = f(h);
    r -= f0;
    r -= h * df;
    return norm_of(r);
  };
  const double rounding =
      100.0 * std::numeric_limits<double>::epsilon() * (norm_of(f0) + norm_of(df));
  const double first = remainder(h_max);
  for (const int decades : {3, 2, 1}) {
    const double h = h_max * std::pow(10.0, -decades);
    const double last = remainder(h);
    if (last > rounding) return std::log10(first / last) / decades;
  }
  return std::numeric_limits<double>::infinity();
}

/// The same for one scalar function.
inline double remainder_slope(const std::function<double(double)>& f, double df,
                              double h_max = 1e-2) {
  const auto as_vector = [](double x) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, x)); };
  return remainder_slope([&](double h) { return as_vector(f(h)); }, as_vector(df), h_max);
}

}  // namespace facies::support
