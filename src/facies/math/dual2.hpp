// SPDX-License-Identifier: Apache-2.0
// Numbers that carry their exact first and second derivatives by N variables (forward automatic differentiation).
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace facies {

/// A value with its gradient [N] and Hessian [N, N]. Constants have zero derivatives.
template <int N>
struct Dual2 {
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Hessian = Eigen::Matrix<double, N, N>;

  double value = 0.0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  Dual2() = default;
  explicit Dual2(double constant) : value(constant) {}

  /// The variable number `index` of 0..N-1 at `value`.
  [[nodiscard]] static Dual2 variable(double value, int index) {
    Dual2 x(value);
    x.gradient(index) = 1.0;
    return x;
  }

  Dual2& operator+=(const Dual2& other) {
    value += other.value;
    gradient += other.gradient;
    hessian += other.hessian;
    return *this;
  }
  Dual2& operator-=(const Dual2& other) {
    value -= other.value;
    gradient -= other.gradient;
    hessian -= other.hessian;
    return *this;
  }
  Dual2& operator*=(double factor) {
    value *= factor;
    gradient *= factor;
    hessian *= factor;
    return *this;
  }
};

/// f(x) from f, f' and f'' at x.value.
template <int N>
[[nodiscard]] Dual2<N> chain(const Dual2<N>& x, double f, double df, double d2f) {
  Dual2<N> y(f);
  y.gradient = df * x.gradient;
  y.hessian = df * x.hessian + d2f * x.gradient * x.gradient.transpose();
  return y;
}

template <int N>
[[nodiscard]] Dual2<N> operator+(Dual2<N> x, const Dual2<N>& y) {
  return x += y;
}

template <int N>
[[nodiscard]] Dual2<N> operator-(Dual2<N> x, const Dual2<N>& y) {
  return x -= y;
}

template <int N>
[[nodiscard]] Dual2<N> operator*(const Dual2<N>& x, const Dual2<N>& y) {
  Dual2<N> z(x.value * y.value);
  z.gradient = x.value * y.gradient + y.value * x.gradient;
  z.hessian = x.value * y.hessian + y.value * x.hessian + x.gradient * y.gradient.transpose() +
              y.gradient * x.gradient.transpose();
  return z;
}

template <int N>
[[nodiscard]] Dual2<N> operator/(const Dual2<N>& x, const Dual2<N>& y) {
  const double inverse = 1.0 / y.value;
  return x * chain(y, inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse);
}

template <int N>
[[nodiscard]] Dual2<N> operator+(const Dual2<N>& x) {
  return x;
}

template <int N>
[[nodiscard]] Dual2<N> operator-(Dual2<N> x) {
  return x *= -1.0;
}

template <int N>
[[nodiscard]] Dual2<N> operator+(Dual2<N> x, double y) {
  x.value += y;
  return x;
}

template <int N>
[[nodiscard]] Dual2<N> operator+(double x, Dual2<N> y) {
  y.value += x;
  return y;
}

template <int N>
[[nodiscard]] Dual2<N> operator-(Dual2<N> x, double y) {
  x.value -= y;
  return x;
}

template <int N>
[[nodiscard]] Dual2<N> operator-(double x, Dual2<N> y) {
  y *= -1.0;
  y.value += x;
  return y;
}

template <int N>
[[nodiscard]] Dual2<N> operator*(Dual2<N> x, double y) {
  return x *= y;
}

template <int N>
[[nodiscard]] Dual2<N> operator*(double x, Dual2<N> y) {
  return y *= x;
}

template <int N>
[[nodiscard]] Dual2<N> operator/(Dual2<N> x, double y) {
  return x *= 1.0 / y;
}

template <int N>
[[nodiscard]] Dual2<N> operator/(double x, const Dual2<N>& y) {
  return Dual2<N>(x) / y;
}

template <int N>
[[nodiscard]] Dual2<N> exp(const Dual2<N>& x) {
  const double e = std::exp(x.value);
  return chain(x, e, e, e);
}

/// exp(x) - 1, accurate near x = 0.
template <int N>
[[nodiscard]] Dual2<N> expm1(const Dual2<N>& x) {
  const double e = std::exp(x.value);
  return chain(x, std::expm1(x.value), e, e);
}

/// Natural logarithm, x > 0.
template <int N>
[[nodiscard]] Dual2<N> log(const Dual2<N>& x) {
  const double inverse = 1.0 / x.value;
  return chain(x, std::log(x.value), inverse, -inverse * inverse);
}

/// x to a constant power, x > 0.
template <int N>
[[nodiscard]] Dual2<N> pow(const Dual2<N>& x, double exponent) {
  const double f = std::pow(x.value, exponent);
  const double df = exponent * f / x.value;
  return chain(x, f, df, (exponent - 1.0) * df / x.value);
}

/// Square root, x > 0.
template <int N>
[[nodiscard]] Dual2<N> sqrt(const Dual2<N>& x) {
  const double root = std::sqrt(x.value);
  const double df = 0.5 / root;
  return chain(x, root, df, -0.5 * df / x.value);
}

}  // namespace facies
