// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "facies/material/catalog.hpp"
#include "facies/material/tissue.hpp"

namespace facies::material {
namespace {

constexpr double C10 = 0.4, C01 = 0.15, C20 = 1.4;
constexpr double stretches[] = {0.6, 0.9, 1.0, 1.1, 1.5, 2.0};

std::unique_ptr<const Law> make() {
  return find_law("mooney_rivlin")
      ->make({{"C10", C10}, {"C01", C01}, {"C20", C20}}, Mat3::Identity());
}

/// sigma_xx - sigma_zz [kPa]
double stress_difference(const Law& law, const Mat3& F) {
  const Response r = distortional_response(law, {}, right_cauchy_green(F));
  const Sym3<double> sigma = push_forward(F, from_stress_voigt(r.S));
  return sigma.xx - sigma.zz;
}

TEST(MooneyRivlin, HasTheUniaxialClosedForm) {
  const auto law = make();
  for (const double l : stretches) {
    const Mat3 F = Vec3(l, 1.0 / std::sqrt(l), 1.0 / std::sqrt(l)).asDiagonal();
    const double I1 = l * l + 2.0 / l;
    const double expected = 2.0 * (l * l - 1.0 / l) * (C10 + 2.0 * C20 * (I1 - 3.0) + C01 / l);
    EXPECT_NEAR(stress_difference(*law, F), expected, 1e-12 * (1.0 + std::abs(expected))) << l;
  }
}

TEST(MooneyRivlin, HasTheEquibiaxialClosedForm) {
  const auto law = make();
  for (const double l : stretches) {
    const Mat3 F = Vec3(l, l, 1.0 / (l * l)).asDiagonal();
    const double I1 = 2.0 * l * l + 1.0 / (l * l * l * l);
    const double expected =
        2.0 * (l * l - 1.0 / (l * l * l * l)) * (C10 + 2.0 * C20 * (I1 - 3.0) + C01 * l * l);
    EXPECT_NEAR(stress_difference(*law, F), expected, 1e-12 * (1.0 + std::abs(expected))) << l;
  }
}

TEST(MooneyRivlin, HasTheSimpleShearClosedForm) {
  const auto law = make();
  for (const double gamma : {0.1, 0.5, 1.5}) {
    Mat3 F = Mat3::Identity();
    F(0, 1) = gamma;
    const Response r = distortional_response(*law, {}, right_cauchy_green(F));
    const double shear = push_forward(F, from_stress_voigt(r.S)).xy;
    EXPECT_NEAR(shear, 2.0 * gamma * (C10 + C01 + 2.0 * C20 * gamma * gamma), 1e-12) << gamma;
  }
}

TEST(MooneyRivlin, HypodermisAndNazariSkinHaveThePublishedStresses) {
  // Uniaxial, incompressible, from an independent calculation; the digits are those printed there.
  struct Row {
    const char* preset;
    double stretch, stress, half_digit;
  };
  for (const Row& row :
       {Row{"flynn2015_hypodermis", 1.1, 0.29, 0.0051},
        Row{"flynn2015_hypodermis", 1.2, 0.85, 0.0051},
        Row{"flynn2015_hypodermis", 1.4, 3.7, 0.051}, Row{"nazari2010_skin", 1.1, 1.5, 0.051},
        Row{"nazari2010_skin", 1.2, 3.3, 0.051}, Row{"nazari2010_skin", 1.4, 8.5, 0.051}}) {
    const auto law =
        find_law("mooney_rivlin")->make(find_preset(row.preset)->values, Mat3::Identity());
    const double width = 1.0 / std::sqrt(row.stretch);
    const Mat3 F = Vec3(row.stretch, width, width).asDiagonal();
    EXPECT_NEAR(stress_difference(*law, F), row.stress, row.half_digit)
        << row.preset << row.stretch;
  }
}

}  // namespace
}  // namespace facies::material
