// SPDX-License-Identifier: Apache-2.0
// One element of each type: derivatives, invariances, closed forms, and where it has no energy.
#include <cmath>
#include <limits>

#include "support/closed_forms.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/element_kernel.hpp"

namespace facies::mechanics {
namespace {

using mesh::CellType;
using support::norm_of;

constexpr double C10 = 0.4;
constexpr double C01 = 0.15;
constexpr double C20 = 1.4;
constexpr double kappa = 50.0;

/// A distorted element with a pre-stretch, a law of the catalog and three fibre families.
class Element : public ::testing::TestWithParam<std::tuple<CellType, std::string>> {
 protected:
  void SetUp() override {
    const auto& [type, law_name] = GetParam();
    n_ = static_cast<Eigen::Index>(mesh::n_nodes(type));
    for (Eigen::Index a = 0; a < n_; ++a)
      X_.col(a) = mesh::node_xi(type, static_cast<std::size_t>(a)) + random_.vector(-0.2, 0.2);
    for (const mesh::QuadraturePoint& q : mesh::quadrature(type)) {
      const Mat3 dX_dxi = X_ * q.dN_dxi;
      points_.push_back(
          {q.dN_dxi * dX_dxi.inverse() * F0_, q.weight * dX_dxi.determinant() / F0_.determinant()});
      V0_ += points_.back().dV0;
    }
    law_ = support::example_law(law_name, random_.rotation());
    // Two families that stretch_ lengthens and one that it shortens, far from the kink at rest length.
    fibres_ = {{fibre_.get(), Vec3(1, 0.2, 0).normalized(), 0.0},
               {fibre_.get(), Vec3(-0.3, 1, 0).normalized(), 0.6},
               {fibre_.get(), Vec3(0.1, 0, 1).normalized(), 1.0}};
  }

  [[nodiscard]] ElementView view() const {
    return {points_, V0_, law_.get(), volumetric_.get(), fibres_};
  }

  /// Nodes at A X + b, shaken.
  [[nodiscard]] NodeColumns placed(const Mat3& A, const Vec3& b, double shake) {
    NodeColumns x = NodeColumns::Zero();
    for (Eigen::Index a = 0; a < n_; ++a)
      x.col(a) = A * X_.col(a) + b + random_.vector(-shake, shake);
    return x;
  }

  [[nodiscard]] NodeColumns loaded() { return placed(stretch_, Vec3(3, -1, 2), 0.04); }

  [[nodiscard]] NodeColumns direction() {
    NodeColumns d = NodeColumns::Zero();
    for (Eigen::Index a = 0; a < n_; ++a)
      d.col(a) = random_.vector(-1.0, 1.0);
    return d;
  }

  static Eigen::VectorXd flat(const NodeColumns& columns) { return columns.reshaped(); }

  support::Random random_{3};
  Mat3 F0_ = Vec3(1.1, 1.05, 1.08).asDiagonal();
  Mat3 stretch_ = Vec3(1.2, 1.15, 0.85).asDiagonal();
  Eigen::Index n_ = 0;
  NodeColumns X_ = NodeColumns::Zero();
  std::vector<ElementPoint> points_;
  double V0_ = 0.0;
  support::LawPointer law_;
  support::VolumetricPointer volumetric_ = support::log_volume(kappa);
  support::FibrePointer fibre_ = support::example_fibre("kPa");
  std::vector<material::Fibre> fibres_;
};

TEST_P(Element, ResidualIsTheDerivativeOfTheEnergy) {
  for (int i = 0; i < 5; ++i) {
    const NodeColumns x = loaded();
    const NodeColumns d = direction();
    const auto W = [&](double h) { return element_energy(view(), x + h * d); };
    const double dW = support::inner_product(element_residual(view(), x), d);
    EXPECT_GE(support::remainder_slope(W, dW), 1.9);
  }
}

TEST_P(Element, TangentIsTheDerivativeOfTheResidual) {
  for (int i = 0; i < 5; ++i) {
    const NodeColumns x = loaded();
    const NodeColumns d = direction();
    ElementMatrix K;
    element_tangent(view(), x, K);
    const auto r = [&](double h) { return flat(element_residual(view(), x + h * d)); };
    EXPECT_GE(support::remainder_slope(r, K * flat(d)), 1.9);
  }
}

TEST_P(Element, TangentIsSymmetric) {
  ElementMatrix K;
  element_tangent(view(), loaded(), K);
  EXPECT_LE(norm_of(K - K.transpose()), 1e-14 * norm_of(K));
}

TEST_P(Element, FeelsNoTranslation) {
  const NodeColumns x = loaded();
  const Vec3 shift(0.3, -2.0, 0.7);
  NodeColumns translation = NodeColumns::Zero();
  for (Eigen::Index a = 0; a < n_; ++a)
    translation.col(a) = shift;
  ElementMatrix K;
  element_tangent(view(), x, K);
  EXPECT_LE(norm_of(K * flat(translation)), 1e-12 * norm_of(K));
  const NodeColumns r = element_residual(view(), x);
  EXPECT_LE(norm_of(element_residual(view(), x + translation) - r), 1e-12 * norm_of(r));
  EXPECT_LE(norm_of(r * Eigen::Matrix<double, 8, 1>::Ones()), 1e-12 * norm_of(r))
      << "inner forces balance";
}

TEST_P(Element, TurnsItsForcesWithItself) {
  const NodeColumns x = loaded();
  const Mat3 Q = random_.rotation();
  const double W = element_energy(view(), x);
  EXPECT_NEAR(element_energy(view(), Q * x), W, 1e-12 * std::abs(W));
  const NodeColumns r = element_residual(view(), x);
  EXPECT_LE(norm_of(element_residual(view(), Q * x) - Q * r), 1e-12 * norm_of(r));
}

TEST_P(Element, TangentTurnsTheForcesInASmallRotation) {
  // d/dt of r(exp(t W) x) = exp(t W) r(x) at t = 0.
  const NodeColumns x = loaded();
  Mat3 spin;
  spin << 0, -0.3, 0.7, 0.3, 0, -0.2, -0.7, 0.2, 0;
  const NodeColumns r = element_residual(view(), x);
  ElementMatrix K;
  element_tangent(view(), x, K);
  EXPECT_LE(norm_of(K * flat(spin * x) - flat(spin * r)), 1e-12 * norm_of(K));
}

TEST_P(Element, IsAtRestUnderAnyRigidMotionOfItsStressFreeState) {
  fibres_.clear();
  const NodeColumns x = placed(random_.rotation() * F0_.inverse(), random_.vector(-5, 5), 0.0);
  EXPECT_NEAR(element_energy(view(), x), 0.0, 1e-14);
  EXPECT_LE(norm_of(element_residual(view(), x)), 1e-12);
  ElementMatrix K;
  element_tangent(view(), x, K);
  const std::vector<double> values =
      support::symmetric_eigenvalues(K.topLeftCorner(3 * n_, 3 * n_));
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(values[i], 0.0, 1e-11) << "six rigid motions";
  EXPECT_GT(values[6], 1e-3) << "and nothing else without energy";
}

TEST_P(Element, HasNoEnergyWhereAPointIsInsideOut) {
  NodeColumns x = loaded();
  EXPECT_GT(smallest_jacobian(view(), x), 0.0);
  x.row(0) *= -1.0;
  EXPECT_LT(smallest_jacobian(view(), x), 0.0);
  EXPECT_EQ(element_energy(view(), x), std::numeric_limits<double>::infinity());
}

TEST_P(Element, DoesNotTakeNotANumberForAdmissible) {
  NodeColumns x = loaded();
  x(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(smallest_jacobian(view(), x) > 0.0);
  EXPECT_EQ(element_energy(view(), x), std::numeric_limits<double>::infinity());
}

TEST_P(Element, KnowsItsVolumeAsTheRatioToTheStressFreeOne) {
  const double J = F0_.determinant() * stretch_.determinant();
  EXPECT_NEAR(element_means(view(), placed(stretch_, Vec3::Zero(), 0.0)).J, J, 1e-13);
}

TEST_P(Element, MeanStressIsTheWorkDoneByStretchingSpace) {
  // For x -> (I + h G) x the energy changes by h times the integral of sigma : G, whatever the deformation.
  const NodeColumns x = loaded();
  const ElementMeans means = element_means(view(), x);
  const NodeColumns r = element_residual(view(), x);
  const Mat3 virial = r.lazyProduct(x.transpose()) / (means.J * V0_);
  EXPECT_TRUE(to_matrix(means.sigma).isApprox(virial, 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Types, Element,
                         ::testing::Combine(::testing::Values(CellType::hex8, CellType::wedge6),
                                            ::testing::Values("mooney_rivlin", "fung_orthotropic")),
                         [](const auto& which) {
                           return std::string(mesh::name(std::get<0>(which.param))) + "_" +
                                  std::get<1>(which.param);
                         });

/// Elements of Mooney-Rivlin tissue, whose stress has a closed form at any F.
class HomogeneousElement : public Element {};

TEST_P(HomogeneousElement, HasTheStressOfTheClosedForm) {
  const double sigma_max = 100.0;
  const Vec3 a0 = Vec3(0.2, 0.1, 1).normalized();
  const auto active = support::example_fibre("none");
  fibres_ = {{active.get(), a0, 0.6}};
  for (int i = 0; i < 5; ++i) {
    const Mat3 F = random_.deformation_gradient(0.3);
    const Mat3 F_e = F * F0_;
    const Mat3 expected = support::mooney_rivlin_cauchy(C10, C01, C20, kappa, F_e) +
                          support::fibre_cauchy(F_e, a0, [&](double) { return 0.6 * sigma_max; });
    const ElementMeans means = element_means(view(), placed(F, random_.vector(-1, 1), 0.0));
    EXPECT_TRUE(to_matrix(means.sigma).isApprox(expected, 1e-12));
    EXPECT_NEAR(means.J, F_e.determinant(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, HomogeneousElement,
                         ::testing::Combine(::testing::Values(CellType::hex8, CellType::wedge6),
                                            ::testing::Values("mooney_rivlin")),
                         [](const auto& which) {
                           return std::string(mesh::name(std::get<0>(which.param)));
                         });

using Hexahedron = Element;

TEST_P(Hexahedron, PaysForTheVolumeOfTheWholeElementOnly) {
  // One half swells as much as the other shrinks: det F is 1 + 0.3 zeta, its mean 1. What that costs cannot depend on kappa.
  F0_.setIdentity();
  points_.clear();
  V0_ = 0.0;
  NodeColumns x;
  for (std::size_t a = 0; a < 8; ++a) {
    const Vec3 xi = mesh::node_xi(CellType::hex8, a);
    x.col(static_cast<Eigen::Index>(a)) = Vec3(xi.x() * (1.0 + 0.3 * xi.z()), xi.y(), xi.z());
  }
  for (const mesh::QuadraturePoint& q : mesh::quadrature(CellType::hex8)) {
    points_.push_back({q.dN_dxi, q.weight});
    V0_ += q.weight;
  }
  fibres_.clear();
  const double soft = element_energy(view(), x);
  volumetric_ = support::log_volume(1e5 * kappa);
  EXPECT_NEAR(element_energy(view(), x), soft, 1e-12 * soft);
  EXPECT_NEAR(element_means(view(), x).J, 1.0, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(MeanDilatation, Hexahedron,
                         ::testing::Values(std::make_tuple(CellType::hex8, "fung_orthotropic")));

}  // namespace
}  // namespace facies::mechanics
