// SPDX-License-Identifier: Apache-2.0
// What every law of the catalog owes its callers. The cases come from the catalog: a new law is tested by being in it.
#include "cases.hpp"
#include "support/random.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/material/tissue.hpp"

namespace facies::material {
namespace {

constexpr double strains[] = {1e-3, 0.1, 0.5};  // small, medium, large: bounds of the log stretches
constexpr int samples = 8;
constexpr double rounding = 1e-12;  // of an energy [kPa] that is a difference of numbers of size 1

Mat3 cauchy_stress(const Mat3& F, const Response& response) {
  return to_matrix(push_forward(F, from_stress_voigt(response.S)));
}

class MatrixLaw : public ::testing::TestWithParam<Case<LawSpec>> {
 protected:
  [[nodiscard]] std::unique_ptr<const Law> make(const Mat3& axes) const {
    return GetParam().spec->make(GetParam().values, axes);
  }
};

TEST_P(MatrixLaw, IsFreeOfEnergyAndStressAtRest) {
  const auto law = make(support::Random(1).rotation());
  EXPECT_EQ(law->energy(identity_sym3()), 0.0);
  EXPECT_LT(distortional_response(*law, {}, identity_sym3()).S.norm(), 1e-12);
}

TEST_P(MatrixLaw, IsStiffAtRestInEveryDistortion) {
  const auto law = make(support::Random(2).rotation());
  const Mat6 C4 = distortional_response(*law, {}, identity_sym3()).C4;
  support::Random random(3);
  for (int i = 0; i < samples; ++i) {
    const Sym3<double> E = random.direction();
    const StrainVoigt shape = strain_voigt(E - scaled(identity_sym3(), trace(E) / 3.0));
    EXPECT_GT(shape.dot(C4 * shape), 0.0);
  }
}

TEST_P(MatrixLaw, HasNoNegativeEnergy) {
  support::Random random(4);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    for (int i = 0; i < samples; ++i) {
      EXPECT_GE(distortional_energy(*law, {}, random.right_cauchy_green(strain)), 0.0) << strain;
    }
  }
}

TEST_P(MatrixLaw, StressIsTwiceTheGradientOfTheEnergy) {
  support::Random random(5);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    for (int i = 0; i < samples; ++i) {
      const Sym3<double> C = random.right_cauchy_green(strain);
      const Sym3<double> dC = random.direction();
      const double derivative = 0.5 * law->respond(C).S_bar.dot(strain_voigt(dC));
      const auto psi = [&](double h) { return law->energy(C + scaled(dC, h)); };
      EXPECT_GE(support::remainder_slope(psi, derivative), 1.9) << strain;
    }
  }
}

TEST_P(MatrixLaw, TangentIsTwiceTheGradientOfTheStress) {
  support::Random random(6);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    for (int i = 0; i < samples; ++i) {
      const Sym3<double> C = random.right_cauchy_green(strain);
      const Sym3<double> dC = random.direction();
      const StressVoigt derivative = 0.5 * law->respond(C).C4_bar * strain_voigt(dC);
      const auto S = [&](double h) -> Eigen::VectorXd {
        return law->respond(C + scaled(dC, h)).S_bar;
      };
      EXPECT_GE(support::remainder_slope(S, derivative), 1.9) << strain;
    }
  }
}

TEST_P(MatrixLaw, ClosedFormIsTheAutomaticDerivative) {
  support::Random random(7);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    for (int i = 0; i < samples; ++i) {
      const Sym3<double> C = random.right_cauchy_green(strain);
      const LawResponse closed = law->respond(C);
      const LawResponse exact = differentiate(*law, C);
      EXPECT_NEAR(closed.psi, exact.psi, 1e-10 * std::abs(exact.psi));
      EXPECT_LE((closed.S_bar - exact.S_bar).norm(), 1e-10 * exact.S_bar.norm());
      EXPECT_LE((closed.C4_bar - exact.C4_bar).norm(), 1e-10 * exact.C4_bar.norm());
      EXPECT_NEAR(closed.psi, law->energy(C), 1e-10 * std::abs(exact.psi));
    }
  }
}

TEST_P(MatrixLaw, StressAloneIsThatOfTheWholeResponse) {
  support::Random random(12);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    const Sym3<double> C = random.right_cauchy_green(strain);
    const StressVoigt S_bar = law->respond(C).S_bar;
    EXPECT_LE((law->stress(C) - S_bar).norm(), 1e-13 * S_bar.norm());
  }
}

TEST_P(MatrixLaw, TangentHasMajorSymmetry) {
  support::Random random(8);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    const Sym3<double> C = random.right_cauchy_green(strain);
    const Mat6 C4_bar = law->respond(C).C4_bar;
    const Mat6 C4 = distortional_response(*law, {}, C).C4;
    EXPECT_LE((C4_bar - C4_bar.transpose()).norm(), 1e-14 * C4_bar.norm());
    EXPECT_LE((C4 - C4.transpose()).norm(), 1e-14 * C4.norm());
  }
}

TEST_P(MatrixLaw, TurnsWithTheObserver) {
  support::Random random(9);
  const auto law = make(random.rotation());
  for (const double strain : strains) {
    const Mat3 F = random.deformation_gradient(strain);
    const Mat3 R = random.rotation();
    const Response before = distortional_response(*law, {}, right_cauchy_green(F));
    const Response after = distortional_response(*law, {}, right_cauchy_green(R * F));
    EXPECT_NEAR(after.psi, before.psi, 1e-9 * before.psi + rounding);
    const Mat3 sigma = cauchy_stress(F, before);
    const Mat3 sigma_turned = cauchy_stress(R * F, after);
    EXPECT_LE((sigma_turned - R * sigma * R.transpose()).norm(), 1e-10 * sigma.norm());
  }
}

TEST_P(MatrixLaw, KnowsNoDirectionsButItsAxes) {
  support::Random random(10);
  const Mat3 axes = random.rotation();
  for (const double strain : strains) {
    const Sym3<double> C = random.right_cauchy_green(strain);
    const Mat3 R = random.rotation();
    const Sym3<double> C_turned = to_sym3(R * to_matrix(C) * R.transpose());
    const auto turned = make(GetParam().spec->has_axes ? Mat3(R * axes) : axes);
    const double psi = distortional_energy(*make(axes), {}, C);
    EXPECT_NEAR(distortional_energy(*turned, {}, C_turned), psi, 1e-9 * psi + rounding);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, MatrixLaw, ::testing::ValuesIn(cases_of(laws())), LabelOf{});

class VolumeLaw : public ::testing::TestWithParam<Case<VolumetricSpec>> {
 protected:
  void SetUp() override { law_ = GetParam().spec->make(GetParam().values); }

  std::unique_ptr<const VolumetricLaw> law_;
};

TEST_P(VolumeLaw, IsFreeOfEnergyAndPressureAtRestAndStiff) {
  const VolumetricResponse rest = law_->respond(1.0);
  EXPECT_EQ(rest.U, 0.0);
  EXPECT_EQ(rest.dU_dJ, 0.0);
  EXPECT_DOUBLE_EQ(rest.d2U_dJ2, GetParam().values.at("kappa"));
}

TEST_P(VolumeLaw, DerivativesFollowFromTheEnergy) {
  for (const double J : {0.3, 0.7, 0.999, 1.0, 1.001, 1.5, 3.0}) {
    const VolumetricResponse v = law_->respond(J);
    const auto U = [&](double h) { return law_->respond(J + h).U; };
    const auto dU_dJ = [&](double h) { return law_->respond(J + h).dU_dJ; };
    EXPECT_GE(v.U, 0.0) << J;
    EXPECT_GE(support::remainder_slope(U, v.dU_dJ), 1.9) << J;
    EXPECT_GE(support::remainder_slope(dU_dJ, v.d2U_dJ2), 1.9) << J;
  }
}

TEST_P(VolumeLaw, PushesBackMoreTheSmallerTheVolume) {
  double before = 0.0;
  for (const double J : {0.9, 0.5, 0.1, 1e-3, 1e-6}) {
    const double dU_dJ = law_->respond(J).dU_dJ;
    EXPECT_LT(dU_dJ, before) << J;
    before = dU_dJ;
  }
}

TEST_P(VolumeLaw, PointwiseResponseFollowsFromTheEnergy) {
  support::Random random(11);
  for (int i = 0; i < samples; ++i) {
    const Sym3<double> C = random.right_cauchy_green(0.4);
    const Sym3<double> dC = random.direction();
    const Response r = volumetric_response(*law_, C);
    const auto at = [&](double h) { return volumetric_response(*law_, C + scaled(dC, h)); };
    const auto psi = [&](double h) { return at(h).psi; };
    const auto S = [&](double h) -> Eigen::VectorXd { return at(h).S; };
    const StrainVoigt half = 0.5 * strain_voigt(dC);
    EXPECT_GE(support::remainder_slope(psi, r.S.dot(half)), 1.9);
    EXPECT_GE(support::remainder_slope(S, r.C4 * half), 1.9);
    EXPECT_LE((r.C4 - r.C4.transpose()).norm(), 1e-14 * r.C4.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, VolumeLaw, ::testing::ValuesIn(cases_of(volumetric_laws())),
                         LabelOf{});

class FibreFamily : public ::testing::TestWithParam<Case<FibreSpec>> {};

TEST_P(FibreFamily, DerivativesFollowFromTheEnergyInEveryUnit) {
  const FibreSpec& spec = *GetParam().spec;
  for (const std::string& passive : spec.passive_choices) {
    const auto law = spec.make(GetParam().values, passive);
    for (const double alpha : {0.0, 0.3, 1.0}) {
      for (const double lambda_bar : {0.5, 0.9, 1.1, 1.3, 1.6, 2.5}) {
        const FibreResponse f = law->respond(lambda_bar, alpha);
        const auto psi = [&](double h) { return law->respond(lambda_bar + h, alpha).psi; };
        const auto stress = [&](double h) {
          return law->respond(lambda_bar + h, alpha).dpsi_dlambda_bar;
        };
        EXPECT_GE(support::remainder_slope(psi, f.dpsi_dlambda_bar), 1.9) << passive << lambda_bar;
        EXPECT_GE(support::remainder_slope(stress, f.d2psi_dlambda_bar2), 1.9)
            << passive << lambda_bar;
      }
    }
  }
}

TEST_P(FibreFamily, AtRestIsFreeOfEnergyAndStress) {
  const FibreSpec& spec = *GetParam().spec;
  for (const std::string& passive : spec.passive_choices) {
    const FibreResponse f = spec.make(GetParam().values, passive)->respond(1.0, 0.0);
    EXPECT_EQ(f.psi, 0.0) << passive;
    EXPECT_EQ(f.dpsi_dlambda_bar, 0.0) << passive;
  }
}

TEST_P(FibreFamily, NeverPushesAndPullsMoreWhenActivated) {
  const FibreSpec& spec = *GetParam().spec;
  for (const std::string& passive : spec.passive_choices) {
    const auto law = spec.make(GetParam().values, passive);
    for (const double lambda_bar : {0.6, 1.0, 1.2, 2.0}) {
      const double relaxed = law->respond(lambda_bar, 0.0).dpsi_dlambda_bar;
      EXPECT_GE(relaxed, 0.0);
      EXPECT_GE(law->respond(lambda_bar, 0.0).psi, 0.0);
      EXPECT_GT(law->respond(lambda_bar, 0.5).dpsi_dlambda_bar, relaxed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, FibreFamily, ::testing::ValuesIn(cases_of(fibre_laws())),
                         LabelOf{});

}  // namespace
}  // namespace facies::material
