// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/element_kernel.hpp"

#include <algorithm>
#include <limits>

#include "facies/math/voigt.hpp"

namespace facies::mechanics {

namespace {

using StrainOperator = Eigen::Matrix<double, 6, 24>;

Mat3 deformation_gradient(const ElementPoint& point, const NodeColumns& x) {
  return x.lazyProduct(point.G);
}

double deformed_volume(const ElementView& element, const NodeColumns& x) {
  double v = 0.0;
  for (const ElementPoint& point : element.points)
    v += point.dV0 * deformation_gradient(point, x).determinant();
  return v;
}

/// J F^-T G^T dV0: the derivative by the nodal positions of the volume that a point stands for.
NodeColumns volume_gradient(const ElementPoint& point, const Mat3& F, double J) {
  const Mat3 cofactor = J * F.inverse().transpose();
  return point.dV0 * cofactor.lazyProduct(point.G.transpose());
}

/// B with delta E (Voigt strain) = B delta x for E = (F^T F - I) / 2.
void strain_operator(const ElementPoint& point, const Mat3& F, StrainOperator& B) {
  for (int node = 0; node < 8; ++node) {
    const double G0 = point.G(node, 0);
    const double G1 = point.G(node, 1);
    const double G2 = point.G(node, 2);
    for (int i = 0; i < 3; ++i) {
      auto column = B.col(3 * node + i);
      column(0) = F(i, 0) * G0;
      column(1) = F(i, 1) * G1;
      column(2) = F(i, 2) * G2;
      column(3) = F(i, 0) * G1 + F(i, 1) * G0;
      column(4) = F(i, 1) * G2 + F(i, 2) * G1;
      column(5) = F(i, 0) * G2 + F(i, 2) * G0;
    }
  }
}

/// Adds to S and C4 what the element's pressure p contributes at a point: S = p J C^-1 and its derivative at fixed p.
void add_pressure(double p, double J, const Sym3<double>& C, material::Response& response) {
  const Sym3<double> C_inv = inverse(C);
  const StressVoigt c = stress_voigt(C_inv);
  response.S += p * J * c;
  response.C4 += (p * J) * (c * c.transpose() - 2.0 * symmetric_square(C_inv));
}

}  // namespace

double smallest_jacobian(const ElementView& element, const NodeColumns& x) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const ElementPoint& point : element.points) {
    const double J = deformation_gradient(point, x).determinant();
    if (!(J >= smallest)) smallest = J;  // a NaN wins, so that it cannot pass for admissible
  }
  return smallest;
}

double element_energy(const ElementView& element, const NodeColumns& x) {
  if (!(smallest_jacobian(element, x) > 0.0)) return std::numeric_limits<double>::infinity();
  double W = element.V0 * element.volumetric->respond(deformed_volume(element, x) / element.V0).U;
  for (const ElementPoint& point : element.points) {
    const Sym3<double> C = right_cauchy_green(deformation_gradient(point, x));
    W += point.dV0 * material::distortional_energy(*element.law, element.fibres, C);
  }
  return W;
}

NodeColumns element_residual(const ElementView& element, const NodeColumns& x) {
  const double p = element.volumetric->respond(deformed_volume(element, x) / element.V0).dU_dJ;
  NodeColumns r = NodeColumns::Zero();
  for (const ElementPoint& point : element.points) {
    const Mat3 F = deformation_gradient(point, x);
    const StressVoigt S =
        material::distortional_stress(*element.law, element.fibres, right_cauchy_green(F));
    const Mat3 P = F * to_matrix(from_stress_voigt(S));
    r += point.dV0 * P.lazyProduct(point.G.transpose());
    r += p * volume_gradient(point, F, F.determinant());
  }
  return r;
}

void element_tangent(const ElementView& element, const NodeColumns& x, ElementMatrix& K) {
  const material::VolumetricResponse U =
      element.volumetric->respond(deformed_volume(element, x) / element.V0);
  K.setZero();
  NodeColumns dv_dx = NodeColumns::Zero();
  Eigen::Matrix<double, 8, 8> geometric = Eigen::Matrix<double, 8, 8>::Zero();
  StrainOperator B;
  for (const ElementPoint& point : element.points) {
    const Mat3 F = deformation_gradient(point, x);
    const double J = F.determinant();
    const Sym3<double> C = right_cauchy_green(F);
    material::Response response = material::distortional_response(*element.law, element.fibres, C);
    add_pressure(U.dU_dJ, J, C, response);
    strain_operator(point, F, B);
    const StrainOperator DB = (point.dV0 * response.C4).lazyProduct(B);
    K += B.transpose().lazyProduct(DB);
    const Mat3 S = to_matrix(from_stress_voigt(response.S));
    geometric += point.dV0 * point.G.lazyProduct(S.lazyProduct(point.G.transpose()).eval());
    dv_dx += volume_gradient(point, F, J);
  }
  const Eigen::Map<const Eigen::Matrix<double, 24, 1>> g(dv_dx.data());
  K += (U.d2U_dJ2 / element.V0) * g.lazyProduct(g.transpose());
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) {
      for (int i = 0; i < 3; ++i)
        K(3 * a + i, 3 * b + i) += geometric(a, b);
    }
  }
}

ElementMeans element_means(const ElementView& element, const NodeColumns& x) {
  const double v = deformed_volume(element, x);
  const double p = element.volumetric->respond(v / element.V0).dU_dJ;
  Sym3<double> weighted;  // sigma dv = F S F^T dV0
  for (const ElementPoint& point : element.points) {
    const Mat3 F = deformation_gradient(point, x);
    const StressVoigt S =
        material::distortional_stress(*element.law, element.fibres, right_cauchy_green(F));
    const Sym3<double> tau = to_sym3(F * to_matrix(from_stress_voigt(S)) * F.transpose());
    weighted = weighted + scaled(tau, point.dV0);
  }
  return {scaled(weighted, 1.0 / v) + scaled(identity_sym3(), p), v / element.V0};
}

}  // namespace facies::mechanics
