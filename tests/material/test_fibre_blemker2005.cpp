// SPDX-License-Identifier: Apache-2.0
// Muscle fibres against Eqs. 4-7 of the paper, typed again from the paper.
#include <cmath>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/material/catalog.hpp"
#include "facies/material/tissue.hpp"

namespace facies::material {
namespace {

constexpr double sigma_max = 100.0, P1 = 0.05, P2 = 6.6, lambda_star = 1.4;
constexpr double P3 = 4.624, P4 = -5.823;  // from C0 and C1 continuity, three digits

std::unique_ptr<const FibreLaw> make(const std::string& passive) {
  return find_fibre_law("fibre_blemker2005")
      ->make(find_preset("flynn2015_muscle")->values, passive);
}

/// Eq. 7.
double f_p(double l) {
  const double P3_exact = P1 * P2 * std::exp(P2 * (lambda_star - 1.0));
  const double P4_exact = P1 * (std::exp(P2 * (lambda_star - 1.0)) - 1.0) - P3_exact * lambda_star;
  if (l < 1.0) return 0.0;
  return l < lambda_star ? P1 * (std::exp(P2 * (l - 1.0)) - 1.0) : P3_exact * l + P4_exact;
}

/// What `passive` measures f_p in [kPa].
double unit_of(const std::string& passive) {
  if (passive == "none") return 0.0;
  return passive == "sigma_max" ? sigma_max : 1.0;
}

/// Eqs. 4 to 6.
Mat3 cauchy_stress_of_the_paper(const Mat3& F, const Vec3& a0, double alpha,
                                const std::string& passive) {
  const double J = F.determinant();
  const double lambda_f = std::pow(J, -1.0 / 3.0) * (F * a0).norm();
  const double W4 = (f_p(lambda_f) * unit_of(passive) + alpha * sigma_max) / (2.0 * lambda_f);
  const Vec3 a = (F * a0).normalized();
  return 2.0 * W4 * lambda_f * lambda_f / J * (a * a.transpose() - Mat3::Identity() / 3.0);
}

TEST(FibreBlemker2005, AddsTheCauchyStressOfThePaper) {
  support::Random random(1);
  const auto matrix = find_law("mooney_rivlin")
                          ->make(find_preset("flynn2015_hypodermis")->values, Mat3::Identity());
  for (const char* passive : {"none", "kPa", "sigma_max"}) {
    const auto muscle = make(passive);
    for (const double alpha : {0.0, 0.15, 1.0}) {
      for (int i = 0; i < 10; ++i) {
        const Mat3 F = random.deformation_gradient(0.6);
        const Fibre fibre{muscle.get(), random.unit_vector(), alpha};
        const Sym3<double> C = right_cauchy_green(F);
        const StressVoigt added = distortional_response(*matrix, {&fibre, 1}, C).S -
                                  distortional_response(*matrix, {}, C).S;
        const Mat3 sigma = to_matrix(push_forward(F, from_stress_voigt(added)));
        const Mat3 expected = cauchy_stress_of_the_paper(F, fibre.a0, alpha, passive);
        EXPECT_LE((sigma - expected).norm(), 1e-11 * (1.0 + expected.norm()))
            << passive << " " << alpha;
      }
    }
  }
}

TEST(FibreBlemker2005, ActiveStressGrowsWithStretchAlone) {
  const auto muscle = make("none");
  for (const double lambda_bar : {0.7, 1.0, 1.5, 2.0}) {
    const FibreResponse f = muscle->respond(lambda_bar, 0.5);
    EXPECT_DOUBLE_EQ(f.dpsi_dlambda_bar, 50.0);
    EXPECT_EQ(f.d2psi_dlambda_bar2, 0.0);
    EXPECT_NEAR(f.psi, 50.0 * (lambda_bar - 1.0), 1e-13);
  }
}

TEST(FibreBlemker2005, PassiveStressHasThePublishedValues) {
  for (const char* passive : {"kPa", "sigma_max"}) {
    const auto muscle = make(passive);
    const double unit = unit_of(passive);
    EXPECT_EQ(muscle->respond(0.99, 0.0).dpsi_dlambda_bar, 0.0);
    EXPECT_NEAR(muscle->respond(1.2, 0.0).dpsi_dlambda_bar, 0.137 * unit, 5e-4 * unit);
    EXPECT_NEAR(muscle->respond(1.4, 0.0).dpsi_dlambda_bar, 0.651 * unit, 5e-4 * unit);
    for (const double lambda_bar : {1.4, 1.6, 2.0}) {
      EXPECT_NEAR(muscle->respond(lambda_bar, 0.0).dpsi_dlambda_bar, (P3 * lambda_bar + P4) * unit,
                  2e-3 * unit);
      EXPECT_NEAR(muscle->respond(lambda_bar, 0.0).d2psi_dlambda_bar2, P3 * unit, 5e-4 * unit);
    }
  }
}

TEST(FibreBlemker2005, EnergyStressAndStiffnessAreContinuousWhereTheCurveTurnsLinear) {
  const auto muscle = make("sigma_max");
  const FibreResponse before = muscle->respond(std::nextafter(lambda_star, 0.0), 0.2);
  const FibreResponse after = muscle->respond(lambda_star, 0.2);
  EXPECT_NEAR(after.psi, before.psi, 1e-12);
  EXPECT_NEAR(after.dpsi_dlambda_bar, before.dpsi_dlambda_bar, 1e-11);
  EXPECT_NEAR(after.d2psi_dlambda_bar2, before.d2psi_dlambda_bar2, 1e-10);
}

TEST(FibreBlemker2005, EnergyAndStressAreContinuousAtRestLength) {
  const auto muscle = make("sigma_max");
  const FibreResponse before = muscle->respond(std::nextafter(1.0, 0.0), 0.0);
  const FibreResponse after = muscle->respond(1.0, 0.0);
  EXPECT_EQ(before.psi, after.psi);
  EXPECT_EQ(before.dpsi_dlambda_bar, after.dpsi_dlambda_bar);
  EXPECT_EQ(before.d2psi_dlambda_bar2, 0.0);
  EXPECT_DOUBLE_EQ(after.d2psi_dlambda_bar2, P1 * P2 * sigma_max);
}

}  // namespace
}  // namespace facies::material
