// SPDX-License-Identifier: Apache-2.0
// The skin law against pen and paper: one-dimensional problems solved here without the law's code.
#include <array>
#include <cmath>

#include "support/bisection.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/material/catalog.hpp"
#include "facies/material/tissue.hpp"

namespace facies::material {
namespace {

const LawSpec& fung() {
  return *find_law("fung_orthotropic");
}

Parameters preset_values(const std::string& name) {
  Parameters values = find_preset(name)->values;
  values.erase("kappa");
  return values;
}

std::unique_ptr<const Law> make_preset(const std::string& name,
                                       const Mat3& axes = Mat3::Identity()) {
  return fung().make(preset_values(name), axes);
}

/// Cauchy stress [kPa] of an incompressible block with these stretches and no stress along axis `free`.
Vec3 block_stress(const Law& law, const Vec3& stretches, int free) {
  const Mat3 F = stretches.asDiagonal();
  const Response r = distortional_response(law, {}, right_cauchy_green(F));
  const Vec3 sigma = to_matrix(push_forward(F, from_stress_voigt(r.S))).diagonal();
  return sigma.array() - sigma(free);
}

/// Cauchy stress [kPa] of a strip pulled along `axis`, the other two free of stress.
double strip_stress(const Law& law, int axis, double stretch) {
  const int width = (axis + 1) % 3;
  const int free = (axis + 2) % 3;
  const auto stretches = [&](double narrowing) {
    Vec3 l;
    l(axis) = stretch;
    l(width) = narrowing;
    l(free) = 1.0 / (stretch * narrowing);
    return l;
  };
  const auto side = [&](double narrowing) {
    return block_stress(law, stretches(narrowing), free)(width);
  };
  return block_stress(law, stretches(support::bisect(side, 0.3, 1.5)), free)(axis);
}

/// Eq. 2-3 for stretches along the material axes, written out by hand: sigma_a - sigma_free with
/// sigma_a + p = l_a^2 e^Q (2 mu_a E_a + sum_b lambda_ab E_b).
struct ByHand {
  double c = 0.0;
  std::array<double, 3> mu{};
  std::array<std::array<double, 3>, 3> lambda{};

  explicit ByHand(const Parameters& v)
      : c(v.at("c")),
        mu{v.at("mu1"), v.at("mu2"), v.at("mu3")},
        lambda{{{v.at("lambda11"), v.at("lambda12"), v.at("lambda31")},
                {v.at("lambda12"), v.at("lambda22"), v.at("lambda23")},
                {v.at("lambda31"), v.at("lambda23"), v.at("lambda33")}}} {}

  [[nodiscard]] double stress(const std::array<double, 3>& l, std::size_t a,
                              std::size_t free) const {
    std::array<double, 3> E{};
    for (std::size_t i = 0; i < 3; ++i)
      E[i] = 0.5 * (l[i] * l[i] - 1.0);
    double Q = 0.0;
    std::array<double, 3> gradient{};
    for (std::size_t i = 0; i < 3; ++i) {
      Q += 2.0 * mu[i] * E[i] * E[i] / c;
      gradient[i] += 2.0 * mu[i] * E[i];
      for (std::size_t j = 0; j < 3; ++j) {
        Q += lambda[i][j] * E[i] * E[j] / c;
        gradient[i] += lambda[i][j] * E[j];
      }
    }
    return std::exp(Q) * (l[a] * l[a] * gradient[a] - l[free] * l[free] * gradient[free]);
  }

  [[nodiscard]] double strip_stress(std::size_t axis, double stretch) const {
    const std::size_t width = (axis + 1) % 3;
    const std::size_t free = (axis + 2) % 3;
    const auto at = [&](double narrowing, std::size_t which) {
      std::array<double, 3> l{};
      l[axis] = stretch;
      l[width] = narrowing;
      l[free] = 1.0 / (stretch * narrowing);
      return stress(l, which, free);
    };
    return at(support::bisect([&](double narrowing) { return at(narrowing, width); }, 0.3, 1.5),
              axis);
  }
};

constexpr int along = 0, normal = 1, across = 2;

TEST(FungOrthotropic, StripAgreesWithTheEquationSolvedByHand) {
  for (const Parameters& values :
       {fung().example, preset_values("flynn2015_normal"), preset_values("artisynth_normal"),
        preset_values("flynn2015_stiff_as_printed")}) {
    const auto law = fung().make(values, Mat3::Identity());
    const ByHand by_hand(values);
    for (const int axis : {along, normal, across}) {
      for (const double stretch : {0.8, 0.95, 1.05, 1.2, 1.4}) {
        const double expected = by_hand.strip_stress(static_cast<std::size_t>(axis), stretch);
        EXPECT_NEAR(strip_stress(*law, axis, stretch), expected, 1e-8 * std::abs(expected));
      }
    }
  }
}

/// Stress along and across the skin line [kPa] at a stretch, and one unit of the last digit given: the independent
/// calculation behind the numbers had moduli that differ in the third digit.
struct Row {
  const char* preset;
  double stretch, along, across, digit;
};

TEST(FungOrthotropic, StripHasTheStressesOfAnIndependentCalculation) {
  for (const Row& row :
       {Row{"flynn2015_normal", 1.1, 5.1, 2.2, 0.1}, Row{"flynn2015_normal", 1.2, 13.3, 5.1, 0.1},
        Row{"flynn2015_normal", 1.3, 27.2, 9.1, 0.1}, Row{"flynn2015_normal", 1.4, 52.6, 15.1, 0.1},
        Row{"artisynth_normal", 1.1, 5.6, 2.3, 0.1}, Row{"artisynth_normal", 1.2, 20.0, 6.1, 0.1},
        Row{"artisynth_normal", 1.3, 73.0, 13.7, 0.1},
        Row{"artisynth_normal", 1.4, 348.8, 31.9, 0.1}}) {
    const auto law = make_preset(row.preset);
    const std::string which = std::string(row.preset) + " " + std::to_string(row.stretch);
    EXPECT_NEAR(strip_stress(*law, along, row.stretch), row.along, row.digit) << which;
    EXPECT_NEAR(strip_stress(*law, across, row.stretch), row.across, row.digit) << which;
  }
}

TEST(FungOrthotropic, SheetHasTheStressesOfAnIndependentCalculation) {
  // Equibiaxial in the plane of the skin: the tension that a tension scale factor of the same size implies.
  for (const Row& row :
       {Row{"flynn2015_normal", 1.05, 2.9, 1.6, 0.1}, Row{"flynn2015_normal", 1.10, 6.1, 2.9, 0.1},
        Row{"flynn2015_normal", 1.15, 9.9, 4.4, 0.1}, Row{"flynn2015_normal", 1.2, 15, 6.2, 1},
        Row{"flynn2015_normal", 1.3, 31, 12, 1}, Row{"flynn2015_stiff", 1.05, 5.8, 3.2, 0.2},
        Row{"artisynth_normal", 1.1, 7.2, 3.5, 0.1}, Row{"artisynth_normal", 1.2, 29, 12, 1},
        Row{"artisynth_normal", 1.3, 145, 56, 1}}) {
    const Vec3 stretches(row.stretch, 1.0 / (row.stretch * row.stretch), row.stretch);
    const Vec3 sigma = block_stress(*make_preset(row.preset), stretches, normal);
    const std::string which = std::string(row.preset) + " " + std::to_string(row.stretch);
    EXPECT_NEAR(sigma(along), row.along, row.digit) << which;
    EXPECT_NEAR(sigma(across), row.across, row.digit) << which;
    const std::array<double, 3> l = {stretches(0), stretches(1), stretches(2)};
    const ByHand by_hand(preset_values(row.preset));
    EXPECT_NEAR(sigma(along), by_hand.stress(l, along, normal), 1e-10 * sigma(along)) << which;
  }
}

TEST(FungOrthotropic, DoublingAllModuliDoublesTheStress) {
  support::Random random(1);
  const Mat3 axes = random.rotation();
  Parameters doubled = fung().example;
  for (auto& [name, value] : doubled)
    value *= 2.0;
  const auto single_law = fung().make(fung().example, axes);
  const auto double_law = fung().make(doubled, axes);
  for (int i = 0; i < 10; ++i) {
    const Sym3<double> C = random.right_cauchy_green(0.4);
    const LawResponse once = single_law->respond(C);
    const LawResponse twice = double_law->respond(C);
    // Exact: doubling is a change of the exponent only, and Q stays what it is.
    EXPECT_EQ(twice.psi, 2.0 * once.psi);
    EXPECT_EQ(twice.S_bar, 2.0 * once.S_bar);
    EXPECT_EQ(twice.C4_bar, 2.0 * once.C4_bar);
  }
}

TEST(FungOrthotropic, PublishedSkinFeelsTheSkinLineAlone) {
  // mu2 = mu3 and equal lambda: turning a2, a3 about a1 changes nothing.
  support::Random random(2);
  const Mat3 axes = random.rotation();
  const Mat3 spun = axes * Eigen::AngleAxisd(0.7, Vec3::UnitX()).toRotationMatrix();
  const auto law = make_preset("flynn2015_normal", axes);
  const auto spun_law = make_preset("flynn2015_normal", spun);
  for (int i = 0; i < 10; ++i) {
    const Sym3<double> C = random.right_cauchy_green(0.4);
    const LawResponse r = law->respond(C);
    EXPECT_TRUE(spun_law->respond(C).S_bar.isApprox(r.S_bar, 1e-12));
    EXPECT_TRUE(spun_law->respond(C).C4_bar.isApprox(r.C4_bar, 1e-12));
  }
}

TEST(FungOrthotropic, FeelsAllAxesWhereTheModuliDiffer) {
  support::Random random(3);
  const Mat3 spin = Eigen::AngleAxisd(0.7, Vec3::UnitX()).toRotationMatrix();
  const Sym3<double> C = random.right_cauchy_green(0.4);
  const double psi = fung().make(fung().example, Mat3::Identity())->energy(C);
  EXPECT_GT(std::abs(fung().make(fung().example, spin)->energy(C) - psi), 1e-3 * psi);
}

TEST(FungOrthotropic, AxesArePutInColumns) {
  Mat3 axes;
  axes.col(0) = Vec3::UnitY();
  axes.col(1) = Vec3::UnitZ();
  axes.col(2) = Vec3::UnitX();
  const auto turned = make_preset("flynn2015_normal", axes);
  const auto straight = make_preset("flynn2015_normal");
  EXPECT_NEAR(strip_stress(*turned, 1, 1.2), strip_stress(*straight, along, 1.2), 1e-10);
}

TEST(FungOrthotropic, OverflowsToInfiniteEnergyWithoutCrashing) {
  const auto law = make_preset("artisynth_normal");
  const Mat3 F = Vec3(20.0, 0.2, 0.25).asDiagonal();
  EXPECT_EQ(law->energy(right_cauchy_green(F)), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(distortional_response(*law, {}, right_cauchy_green(F)).S.allFinite());
}

}  // namespace
}  // namespace facies::material
