// SPDX-License-Identifier: Apache-2.0
// The projection: any matrix law with any fibres, as one response to C.
#include <array>

#include "cases.hpp"
#include "support/random.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/material/tissue.hpp"

namespace facies::material {
namespace {

Mat3 cauchy_stress(const Mat3& F, const Response& response) {
  return to_matrix(push_forward(F, from_stress_voigt(response.S)));
}

/// A law of the catalog with two crossing fibre families, one of them active.
class Tissue : public ::testing::TestWithParam<Case<LawSpec>> {
 protected:
  void SetUp() override {
    law_ = GetParam().spec->make(GetParam().values, random_.rotation());
    for (const FibreSpec& spec : fibre_laws()) {
      fibre_laws_.push_back(spec.make(spec.example, "sigma_max"));
      fibres_.push_back({fibre_laws_.back().get(), random_.unit_vector(), 0.0});
      fibres_.push_back({fibre_laws_.back().get(), random_.unit_vector(), 0.4});
    }
  }

  [[nodiscard]] Response respond(const Sym3<double>& C) const {
    return distortional_response(*law_, fibres_, C);
  }

  support::Random random_{1};
  std::unique_ptr<const Law> law_;
  std::vector<std::unique_ptr<const FibreLaw>> fibre_laws_;
  std::vector<Fibre> fibres_;
};

TEST_P(Tissue, StressAndTangentFollowFromTheEnergy) {
  for (const double strain : {1e-3, 0.1, 0.5}) {
    for (int i = 0; i < 8; ++i) {
      const Sym3<double> C = random_.right_cauchy_green(strain);
      const Sym3<double> dC = random_.direction();
      const Response r = respond(C);
      const StrainVoigt half = 0.5 * strain_voigt(dC);
      // Small steps: the stiffness of a fibre jumps at its rest length, which no step should cross.
      const double h_max = 1e-3 * std::min(1.0, 10.0 * strain);
      const auto psi = [&](double h) {
        return distortional_energy(*law_, fibres_, C + scaled(dC, h));
      };
      const auto S = [&](double h) -> Eigen::VectorXd { return respond(C + scaled(dC, h)).S; };
      EXPECT_GE(support::remainder_slope(psi, r.S.dot(half), h_max), 1.9) << strain;
      EXPECT_GE(support::remainder_slope(S, r.C4 * half, h_max), 1.9) << strain;
      EXPECT_NEAR(r.psi, distortional_energy(*law_, fibres_, C), 1e-10 * std::abs(r.psi));
      EXPECT_LE((r.C4 - r.C4.transpose()).norm(), 1e-14 * r.C4.norm());
    }
  }
}

TEST_P(Tissue, StressAloneIsThatOfTheWholeResponse) {
  const Sym3<double> C = random_.right_cauchy_green(0.4);
  const StressVoigt S = respond(C).S;
  EXPECT_LE((distortional_stress(*law_, fibres_, C) - S).norm(), 1e-13 * S.norm());
}

TEST_P(Tissue, StressHasNoPressure) {
  const Mat3 F = random_.deformation_gradient(0.4);
  const Mat3 sigma = cauchy_stress(F, respond(right_cauchy_green(F)));
  EXPECT_LE(std::abs(sigma.trace()), 1e-12 * sigma.norm());
}

TEST_P(Tissue, DoesNotFeelAChangeOfVolume) {
  const Sym3<double> C = random_.right_cauchy_green(0.4);
  EXPECT_NEAR(distortional_energy(*law_, fibres_, scaled(C, 1.7)),
              distortional_energy(*law_, fibres_, C), 1e-12 * distortional_energy(*law_, {}, C));
}

TEST_P(Tissue, TurnsWithTheObserver) {
  const Mat3 F = random_.deformation_gradient(0.4);
  const Mat3 R = random_.rotation();
  const Mat3 sigma = cauchy_stress(F, respond(right_cauchy_green(F)));
  const Mat3 sigma_turned = cauchy_stress(R * F, respond(right_cauchy_green(R * F)));
  EXPECT_LE((sigma_turned - R * sigma * R.transpose()).norm(), 1e-11 * sigma.norm());
}

INSTANTIATE_TEST_SUITE_P(Catalog, Tissue, ::testing::ValuesIn(cases_of(laws())), LabelOf{});

TEST(TissueResponse, IsTheMatrixLawAloneWithoutFibres) {
  const LawSpec& spec = *find_law("mooney_rivlin");
  const auto law = spec.make({{"C10", 2.0}, {"C01", 0.0}, {"C20", 0.0}}, Mat3::Identity());
  // Neo-Hookean: sigma = 2 C10 J^(-5/3) dev(F F^T).
  const Mat3 F = support::Random(2).deformation_gradient(0.5);
  const Mat3 b = F * F.transpose();
  const Mat3 expected =
      4.0 * std::pow(F.determinant(), -5.0 / 3.0) * (b - b.trace() / 3.0 * Mat3::Identity());
  const Response r = distortional_response(*law, {}, right_cauchy_green(F));
  EXPECT_TRUE(cauchy_stress(F, r).isApprox(expected, 1e-12));
}

TEST(TissueResponse, AddsUpFibreFamilies) {
  const auto law =
      find_law("mooney_rivlin")->make({{"C10", 1.0}, {"C01", 0.0}, {"C20", 0.0}}, Mat3::Identity());
  const FibreSpec& spec = *find_fibre_law("fibre_blemker2005");
  const auto muscle = spec.make(spec.example, "kPa");
  support::Random random(3);
  const Fibre a{muscle.get(), random.unit_vector(), 0.2};
  const Fibre b{muscle.get(), random.unit_vector(), 0.7};
  const Sym3<double> C = random.right_cauchy_green(0.3);
  const StressVoigt none = distortional_response(*law, {}, C).S;
  const StressVoigt only_a = distortional_response(*law, std::array{a}, C).S;
  const StressVoigt only_b = distortional_response(*law, std::array{b}, C).S;
  const StressVoigt both = distortional_response(*law, std::array{a, b}, C).S;
  EXPECT_TRUE((both - none).isApprox((only_a - none) + (only_b - none), 1e-12));
}

TEST(TissueResponse, CountsAFibreByItsShareOfTheVolume) {
  const auto law =
      find_law("mooney_rivlin")->make({{"C10", 1.0}, {"C01", 0.0}, {"C20", 0.0}}, Mat3::Identity());
  const FibreSpec& spec = *find_fibre_law("fibre_blemker2005");
  const auto muscle = spec.make(spec.example, "sigma_max");
  support::Random random(4);
  const Fibre whole{muscle.get(), random.unit_vector(), 0.6};
  const Fibre third{whole.law, whole.a0, whole.alpha, 1.0 / 3.0};
  const Fibre rest{whole.law, whole.a0, whole.alpha, 2.0 / 3.0};
  const Sym3<double> C = random.right_cauchy_green(0.3);
  const Response one = distortional_response(*law, std::array{whole}, C);
  const Response two = distortional_response(*law, std::array{third, rest}, C);
  EXPECT_NEAR(two.psi, one.psi, 1e-12 * std::abs(one.psi));
  EXPECT_TRUE(two.S.isApprox(one.S, 1e-12));
  EXPECT_TRUE(two.C4.isApprox(one.C4, 1e-12));
  EXPECT_NEAR(distortional_energy(*law, std::array{third, rest}, C), one.psi,
              1e-12 * std::abs(one.psi));
  EXPECT_TRUE(distortional_stress(*law, std::array{third, rest}, C).isApprox(one.S, 1e-12));
}

TEST(VolumetricResponse, IsAPressure) {
  const VolumetricSpec& spec = *find_volumetric_law("volumetric_log");
  const auto law = spec.make({{"kappa", 50.0}});
  const Mat3 F = support::Random(4).deformation_gradient(0.3);
  const double J = F.determinant();
  const Response r = volumetric_response(*law, right_cauchy_green(F));
  const Mat3 expected = 50.0 * std::log(J) / J * Mat3::Identity();
  EXPECT_TRUE(cauchy_stress(F, r).isApprox(expected, 1e-12));
}

}  // namespace
}  // namespace facies::material
