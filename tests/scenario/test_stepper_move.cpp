// SPDX-License-Identifier: Apache-2.0
// A sheet of skin that goes in parts or in time: in as many as asked for, along its curves, slowly to where statics ends.
#include "scenario/reading.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/sources.hpp"
#include "facies/scenario/motion_model.hpp"
#include "facies/scenario/stepper.hpp"

namespace facies::scenario {
namespace {

/// The sheet after tension, release and one more step.
struct Carried {
  explicit Carried(const std::string& last)
      : scenario(
            read("steps:\n  - tension: {tsf: 1.10}\n  - release\n  - " + last + "\n").scenario),
        model(
            build_model(anatomy::load_face("patch:width=30,height=30,ny=4,nz=4", {}), scenario, 1)),
        stepper(*model, scenario) {
    solve::Observer nobody;
    for (int step = 1; step <= 3; ++step) {
      report = stepper.take(step, nobody, [&](double part) {
        parts.push_back(part);
        times.push_back(stepper.time());
        activations.push_back(stepper.controls().activation.at(0));
      });
      EXPECT_TRUE(report.converged) << report.last.reason;
    }
  }

  Scenario scenario;
  std::unique_ptr<FaceModel> model;
  Stepper stepper;
  solve::StepReport report;
  std::vector<double> parts, times, activations;
};

double distance(const mechanics::State& a, const mechanics::State& b) {
  double largest = 0.0;
  for (std::size_t node = 0; node < a.u.size(); ++node)
    largest = std::max(largest, (a.u[node] - b.u[node]).norm());
  return largest;
}

TEST(Move, FollowsItsCurvesFrameByFrame) {
  for (const char* method : {"dynamic", "quasi_static"}) {
    const Carried carried("move: {duration: 0.4 s, frames: 4, method: " + std::string(method) +
                          ", STRIP: [[0 s, 0.1], [0.2 s, 0.3]]}");
    EXPECT_EQ(carried.parts, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(carried.times.at(k), 0.1 * static_cast<double>(k), 1e-12);
    const std::vector<double> wanted = {0.0, 0.2, 0.3, 0.3, 0.3};
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(carried.activations.at(k), wanted[k], 1e-12) << method << k;
  }
}

TEST(Express, GoesInAsManyPartsAsAskedFor) {
  const Carried once("express: {STRIP: 0.3}");
  EXPECT_EQ(once.report.increments, 1);
  const Carried thrice("express: {STRIP: 0.3}\nsolver: {parts: 3}");
  EXPECT_EQ(thrice.report.increments, 3);
  EXPECT_TRUE(thrice.parts.empty()) << "no frames were asked for";
  EXPECT_LT(distance(once.stepper.state(), thrice.stepper.state()), 1e-4);
}

TEST(Express, ShowsItsFramesHoweverManyPartsItGoesIn) {
  const Carried carried("express: {STRIP: 0.3}\nsolver: {parts: 3}\noutput: {frames: 2}");
  EXPECT_EQ(carried.report.increments, 4);
  EXPECT_EQ(carried.parts, (std::vector<double>{0.0, 0.5, 1.0}));
}

TEST(Move, EndsSlowlyWhereTheExpressionEnds) {
  const Carried still("express: {STRIP: 0.3}");
  const Carried rest("express: {STRIP: 0}");
  const Carried slow("move: {duration: 20 s, frames: 1, STRIP: [[2 s, 0], [5 s, 0.3]]}");
  const Carried stages(
      "move: {duration: 1 s, frames: 3, method: quasi_static, STRIP: [[0 s, 0], [1 s, 0.3]]}");
  EXPECT_GT(distance(still.stepper.state(), rest.stepper.state()), 0.5);
  EXPECT_LT(distance(still.stepper.state(), slow.stepper.state()), 1e-3);
  EXPECT_LT(distance(still.stepper.state(), stages.stepper.state()), 1e-5);
}

TEST(ControlsInMove, BeginWhereTheyWereAndReachTheCurvesAfterATenth) {
  const Carried carried("move: {duration: 1 s, frames: 1, method: quasi_static, STRIP: 0.4}");
  const auto& step = std::get<MoveStep>(carried.scenario.steps[2]);
  mechanics::Controls before;
  before.activation = {0.8, 0.8};  // STRIP_L, STRIP_R
  const auto at = [&](double time) {
    return controls_in_move(*carried.model, step, {0, 0, -9800}, before, time);
  };
  EXPECT_DOUBLE_EQ(at(0.0).activation[0], 0.8);
  EXPECT_DOUBLE_EQ(at(0.05).activation[0], 0.6);
  EXPECT_DOUBLE_EQ(at(0.05).gravity.z(), -4900.0);
  EXPECT_DOUBLE_EQ(at(0.1).activation[0], 0.4);
  EXPECT_DOUBLE_EQ(at(1.0).activation[0], 0.4);
}

}  // namespace
}  // namespace facies::scenario
