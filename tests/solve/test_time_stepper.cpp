// SPDX-License-Identifier: Apache-2.0
// How time steps adapt, what is told of them, and how a motion ends before its time. What motions are right: verification.
#include "support/models.hpp"
#include "support/motion.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/hill_muscle.hpp"

namespace facies::solve {
namespace {

using mechanics::Anchor;

/// A mass that is thrown against a spring that is stiff beyond 50 mm: a muscle without excitation.
struct Thrown {
  Thrown()
      : inertia(model.add(std::make_unique<mechanics::Inertia>(model, std::vector<Vec3>{X},
                                                               std::vector<double>{0.01}))) {
    model.add(std::make_unique<mechanics::HillMuscles>(
        model, std::vector<mechanics::HillMuscle>{{"m",
                                                   Anchor::in_space({0, 0, 0}),
                                                   Anchor::on_node(0, X),
                                                   {1e6, 50.0, 60.0, 0.0, 1.0, 0.0}}}));
  }

  const Vec3 X{20, 0, 0};
  mechanics::Model model{1};
  const mechanics::Inertia& inertia;
};

TEST(TimeStepper, TakesSmallStepsWhereMuchHappensAndLargeOnesElsewhere) {
  const Thrown thrown;
  struct Listener final : Observer {
    void time_step_done(const Motion& motion) override { times.push_back(motion.time); }
    std::vector<double> times{0.0};
  } listener;
  Equilibrium equilibrium(thrown.model, {});
  TimeSettings settings;
  settings.rho_inf = 1.0;
  settings.tolerance = 1e-3;
  TimeStepper stepper(equilibrium, thrown.inertia, settings);
  const ControlsInTime controls = support::constantly({});
  Motion motion = stepper.begin(0.0, thrown.model.initial_state(), controls, {0.01 * 1000.0, 0, 0});
  const MotionReport report = stepper.advance(motion, 0.1, controls, {}, listener);
  ASSERT_TRUE(report.converged);
  EXPECT_EQ(listener.times.size(), static_cast<std::size_t>(report.steps) + 1);
  EXPECT_EQ(listener.times.back(), 0.1);
  EXPECT_GT(report.refused_error, 0);
  double largest = 0.0;
  double smallest = 1.0;
  for (std::size_t k = 1; k < listener.times.size(); ++k) {
    largest = std::max(largest, listener.times[k] - listener.times[k - 1]);
    smallest = std::min(smallest, listener.times[k] - listener.times[k - 1]);
  }
  EXPECT_GT(largest, 8.0 * smallest);
  // It comes back as fast as it went.
  EXPECT_NEAR(motion.momentum[0], -10.0, 0.05);
  EXPECT_NEAR(motion.energy.kinetic + motion.energy.potential, 0.5 * 10.0 * 10.0 / 0.01, 50.0);
}

TEST(TimeStepper, RefusesStepsThatMakeEnergy) {
  const Thrown thrown;
  TimeSettings settings = support::fixed_steps(5e-3);
  support::Mover careless(thrown.model, thrown.inertia, {}, settings, support::constantly({}),
                          thrown.model.initial_state(), {10.0, 0, 0});
  settings.energy_tolerance = 1e-3;
  support::Mover careful(thrown.model, thrown.inertia, {}, settings, support::constantly({}),
                         thrown.model.initial_state(), {10.0, 0, 0});
  ASSERT_TRUE(careless.go(0.1).converged);
  const MotionReport report = careful.go(0.1);
  ASSERT_TRUE(report.converged);
  EXPECT_GT(report.refused_energy, 0);
  EXPECT_GT(std::abs(careless.motion.energy.numerical), 500.0);
  EXPECT_LT(careful.motion.energy.numerical, 50.0);
}

TEST(TimeStepper, StopsWhenAskedAtTheLastAcceptedStep) {
  const Thrown thrown;
  struct Listener final : Observer {
    void time_step_done(const Motion& /*motion*/) override { ++steps; }
    [[nodiscard]] bool stop_requested() const override { return steps == 3; }
    int steps = 0;
  } listener;
  Equilibrium equilibrium(thrown.model, {});
  TimeStepper stepper(equilibrium, thrown.inertia, {});
  const ControlsInTime controls = support::constantly({});
  Motion motion = stepper.begin(1.0, thrown.model.initial_state(), controls, {10.0, 0, 0});
  const MotionReport report = stepper.advance(motion, 2.0, controls, {}, listener);
  EXPECT_TRUE(report.interrupted);
  EXPECT_FALSE(report.converged);
  EXPECT_LE(report.steps, 4);
  EXPECT_LT(motion.time, 2.0);
}

TEST(TimeStepper, TellsWhichPartOfTheStepOfAScenarioItTakes) {
  const Thrown thrown;
  struct Listener final : Observer {
    void increment_begins(const Increment& increment) override { all.push_back(increment); }
    std::vector<Increment> all;
  } listener;
  Equilibrium equilibrium(thrown.model, {});
  TimeStepper stepper(equilibrium, thrown.inertia, support::fixed_steps(0.25));
  const ControlsInTime controls = support::constantly({});
  Motion motion = stepper.begin(0.0, thrown.model.initial_state(), controls);
  Increment label{"move", 2, 3, 10, 0.5, 1.0};
  ASSERT_TRUE(stepper.advance(motion, 1.0, controls, label, listener).converged);
  ASSERT_EQ(listener.all.size(), 4U);
  EXPECT_EQ(listener.all[1].number, 12);
  EXPECT_DOUBLE_EQ(listener.all[1].from, 0.625);
  EXPECT_DOUBLE_EQ(listener.all[1].to, 0.75);
}

TEST(TimeStepper, GivesUpAfterTheMostSteps) {
  const Thrown thrown;
  TimeSettings settings = support::fixed_steps(1e-3);
  settings.max_steps = 5;
  support::Mover mover(thrown.model, thrown.inertia, {}, settings, support::constantly({}),
                       thrown.model.initial_state());
  const MotionReport report = mover.go(1.0);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "not at the end after 5 steps");
  EXPECT_DOUBLE_EQ(mover.motion.time, 5e-3);
}

}  // namespace
}  // namespace facies::solve
