// SPDX-License-Identifier: Apache-2.0
// The force law of jaw muscles against its printed formula, and muscles that cannot be.
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mechanics/hill_muscle.hpp"

namespace facies::mechanics {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Superficial masseter of the reference jaw.
HillParameters masseter() {
  return {190400.0, 54.688267, 71.075617, 0.46, 0.015, 1.0};
}

/// The formula of the authors' program, its corners as they are.
double printed_force(const HillParameters& m, double l, double excitation) {
  const double l_n =
      (l - m.optimal_length * m.tendon_ratio) / (m.optimal_length * (1.0 - m.tendon_ratio));
  const double act =
      l_n > 0.5 && l_n < 1.5 ? 0.5 * (1.0 + std::cos(2.0 * std::numbers::pi * l_n)) : 0.0;
  const double pas =
      std::clamp((l - m.optimal_length) / (m.max_length - m.optimal_length), 0.0, 1.0);
  return m.max_force * (act * excitation + pas * m.passive_fraction);
}

TEST(HillForce, IsThePrintedOneAtEveryLength) {
  const HillParameters m = masseter();
  for (const double excitation : {0.0, 0.3, 1.0}) {
    for (double l = 20.0; l < 90.0; l += 0.1) {
      EXPECT_NEAR(hill_force(m, l, excitation).force, printed_force(m, l, excitation),
                  0.0025 * m.passive_fraction * m.max_force)
          << l;
    }
  }
}

TEST(HillForce, IsGreatestAtTheOptimalLengthAndNothingAtHalfTheBellyMoreOrLess) {
  const HillParameters m = masseter();
  const double belly = m.optimal_length * (1.0 - m.tendon_ratio);
  HillParameters active_only = m;
  active_only.passive_fraction = 0.0;
  EXPECT_DOUBLE_EQ(hill_force(active_only, m.optimal_length, 1.0).force, m.max_force);
  EXPECT_NEAR(hill_force(active_only, m.optimal_length, 1.0).stiffness, 0.0, 1e-9 * m.max_force);
  for (const double way : {-0.5, 0.5}) {
    EXPECT_NEAR(hill_force(active_only, m.optimal_length + way * belly, 1.0).force, 0.0,
                1e-9 * m.max_force);
  }
}

TEST(HillForce, IsPassiveHoweverFarTheEndsAreApart) {
  const HillParameters m = masseter();
  for (const double l : {80.0, 1e6, 1e20}) {
    EXPECT_DOUBLE_EQ(hill_force(m, l, 1.0).force, m.passive_fraction * m.max_force) << l;
    EXPECT_GE(hill_force(m, l, 0.0).energy, 0.1 * m.passive_fraction * m.max_force * l) << l;
  }
}

TEST(HillForce, DoublesWithTheExcitationWhereNothingIsPassive) {
  const HillParameters m = masseter();
  const double l = 0.9 * m.optimal_length;
  EXPECT_DOUBLE_EQ(hill_force(m, l, 0.8).force, 2.0 * hill_force(m, l, 0.4).force);
}

TEST(HillForce, HasTheIntegralOfTheForceAsEnergy) {
  // Simpson's rule over the printed force; its corners cost the last digits.
  const HillParameters m = masseter();
  const double from = 30.0;
  const double to = 80.0;
  const int n = 20000;
  const double h = (to - from) / n;
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * printed_force(m, from + i * h, 0.7) * h / 3.0;
  }
  const double W = hill_force(m, to, 0.7).energy - hill_force(m, from, 0.7).energy;
  EXPECT_NEAR(W, sum, 1e-6 * sum);
}

TEST(HillForce, IsTheDerivativeOfItsEnergyAndHasItsStiffness) {
  const HillParameters m = masseter();
  for (const double l : {30.0, 41.0, 50.0, 54.6, 54.7, 60.0, 71.0, 71.1, 80.0}) {
    const HillForce hill = hill_force(m, l, 0.6);
    EXPECT_GE(support::remainder_slope([&](double h) { return hill_force(m, l + h, 0.6).energy; },
                                       hill.force),
              1.9)
        << l;
    EXPECT_GE(support::remainder_slope([&](double h) { return hill_force(m, l + h, 0.6).force; },
                                       hill.stiffness),
              1.9)
        << l;
  }
}

HillMuscle between(const std::string& name, const Vec3& a, const Vec3& b) {
  return {name, Anchor::in_space(a), Anchor::in_space(b), masseter()};
}

/// What is told about muscles that cannot be.
std::string told(std::vector<HillMuscle> muscles) {
  const Model model(0);
  try {
    const HillMuscles term(model, std::move(muscles));
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(HillMuscles, WithCoincidentEndsAreRefusedByName) {
  EXPECT_EQ(told({between("lsm", {0, 0, 0}, {1, 0, 0})}), "");
  EXPECT_THAT(told({between("lsm", {1, 2, 3}, {1, 2, 3}), between("rsm", {0, 0, 0}, {0, 0, 1e-9}),
                    between("ldm", {0, 0, 0}, {1, 0, 0})}),
              AllOf(HasSubstr("muscle 'lsm': ends"), HasSubstr("muscle 'rsm': ends"),
                    testing::Not(HasSubstr("ldm"))));
}

TEST(HillMuscles, WithImpossibleParametersAreRefusedByName) {
  HillMuscle muscle = between("lad", {0, 0, 0}, {1, 0, 0});
  muscle.parameters.tendon_ratio = 1.0;
  muscle.parameters.max_length = muscle.parameters.optimal_length;
  muscle.parameters.max_force = -1.0;
  EXPECT_THAT(told({muscle}), AllOf(HasSubstr("muscle 'lad': tendon ratio 1"),
                                    HasSubstr("greatest length"), HasSubstr("nothing negative")));
  muscle.parameters.tendon_ratio = std::nan("");
  EXPECT_THAT(told({muscle}), HasSubstr("tendon ratio nan"));
}

TEST(HillMuscles, TellTheirLengthAndForce) {
  const Model model(0);
  const HillMuscles term(
      model, {between("a", {0, 0, 0}, {0, 0, 60}), between("b", {0, 0, 0}, {50, 0, 0})});
  Controls controls;
  controls.excitation = {0.0, 0.5};
  const State state = model.initial_state();
  EXPECT_DOUBLE_EQ(term.length(state, 0), 60.0);
  EXPECT_DOUBLE_EQ(term.force(state, controls, 0), hill_force(masseter(), 60.0, 0.0).force);
  EXPECT_DOUBLE_EQ(term.force(state, controls, 1), hill_force(masseter(), 50.0, 0.5).force);
  EXPECT_DOUBLE_EQ(term.force(state, {}, 1), 0.0);
  controls.excitation = {1.0};
  EXPECT_THROW((void)term.force(state, controls, 0), BugError);
}

TEST(HillMuscles, BetweenFixedPointsHaveNoUnknowns) {
  const Model model(0);
  const HillMuscles term(model, {between("lpd", {0, 0, 0}, {0, 0, 60})});
  Stencils stencils;
  term.list_stencils(model.initial_state(), stencils);
  EXPECT_EQ(stencils.size(), 0U);
}

}  // namespace
}  // namespace facies::mechanics
