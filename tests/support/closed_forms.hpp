// SPDX-License-Identifier: Apache-2.0
// Stresses of homogeneously deformed tissue written down from the printed equations, independent of the library.
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include <Eigen/LU>

#include "facies/material/catalog.hpp"

namespace facies::support {

/// lambda_bar_i dpsi/dlambda_bar_i [kPa] at the distortional stretches along three fixed axes.
using PrincipalResponse = std::function<Vec3(const Vec3& lambda_bar)>;

/// psi = C10 (I1 - 3) + C01 (I2 - 3) + C20 (I1 - 3)^2.
inline PrincipalResponse principal_mooney_rivlin(double C10, double C01, double C20) {
  return [=](const Vec3& lambda_bar) -> Vec3 {
    const Eigen::Array3d square = lambda_bar.array().square();
    const double I1 = square.sum();
    return 2.0 * (C10 + 2.0 * C20 * (I1 - 3.0) + C01 * (I1 - square)) * square;
  };
}

/// Flynn et al. 2015, Eqs. 2-3, with material axis a_(k+1) along coordinate axis[k].
inline PrincipalResponse principal_fung(const material::Parameters& p,
                                        const std::array<int, 3>& axis) {
  const double c = p.at("c");
  const Vec3 mu(p.at("mu1"), p.at("mu2"), p.at("mu3"));
  Mat3 lambda;
  lambda << p.at("lambda11"), p.at("lambda12"), p.at("lambda31"), p.at("lambda12"),
      p.at("lambda22"), p.at("lambda23"), p.at("lambda31"), p.at("lambda23"), p.at("lambda33");
  return [=](const Vec3& lambda_bar) -> Vec3 {
    Vec3 e;
    for (int k = 0; k < 3; ++k) {
      const double stretch = lambda_bar(axis[static_cast<std::size_t>(k)]);
      e(k) = 0.5 * (stretch * stretch - 1.0);
    }
    const Vec3 half_gradient = 2.0 * mu.cwiseProduct(e) + lambda * e;  // of c Q
    const double exp_Q = std::exp(e.dot(half_gradient) / c);
    Vec3 response;
    for (int k = 0; k < 3; ++k) {
      const int i = axis[static_cast<std::size_t>(k)];
      response(i) = lambda_bar(i) * lambda_bar(i) * exp_Q * half_gradient(k);
    }
    return response;
  };
}

/// Adds fibres along a coordinate axis whose nominal stress is `stress`(lambda_bar) [kPa].
inline PrincipalResponse with_fibres(PrincipalResponse matrix, int axis,
                                     std::function<double(double)> stress) {
  return [matrix = std::move(matrix), axis, stress = std::move(stress)](const Vec3& lambda_bar) {
    Vec3 response = matrix(lambda_bar);
    response(axis) += lambda_bar(axis) * stress(lambda_bar(axis));
    return response;
  };
}

/// Cauchy stresses along the axes [kPa], U = kappa/2 (ln J)^2.
inline Vec3 principal_cauchy(const PrincipalResponse& tissue, double kappa, const Vec3& lambda) {
  const double J = lambda.prod();
  const Vec3 tau = tissue(lambda / std::cbrt(J));
  return (tau.array() - tau.mean() + kappa * std::log(J)) / J;
}

inline Mat3 deviator(const Mat3& A) {
  return A - A.trace() / 3.0 * Mat3::Identity();
}

/// Cauchy stress of Mooney-Rivlin tissue at any F [kPa], U = kappa/2 (ln J)^2.
inline Mat3 mooney_rivlin_cauchy(double C10, double C01, double C20, double kappa, const Mat3& F) {
  const double J = F.determinant();
  const Mat3 b_bar = F * F.transpose() / std::cbrt(J * J);
  const double I1 = b_bar.trace();
  const Mat3 tau =
      2.0 * (C10 + 2.0 * C20 * (I1 - 3.0) + C01 * I1) * b_bar - 2.0 * C01 * b_bar * b_bar;
  return (deviator(tau) + kappa * std::log(J) * Mat3::Identity()) / J;
}

/// Cauchy stress that fibres along a0 add (Flynn et al. 2015, Eq. 4) with nominal stress `stress`(lambda_bar) [kPa].
inline Mat3 fibre_cauchy(const Mat3& F, const Vec3& a0,
                         const std::function<double(double)>& stress) {
  const double J = F.determinant();
  const Vec3 a = (F * a0).normalized();
  const double lambda_bar = (F * a0).norm() / std::cbrt(J);
  return lambda_bar * stress(lambda_bar) / J * deviator(a * a.transpose());
}

}  // namespace facies::support
