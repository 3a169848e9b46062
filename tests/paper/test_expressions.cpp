// SPDX-License-Identifier: Apache-2.0
// The paper's own face through its own protocol, nothing tuned: tension, release and the four expressions of Table 3
// that need no jaw. Contact is not there yet, so lips and chin are not compared; the mouth corner is.
#include <algorithm>

#include "anatomy/reference_face.hpp"
#include "support/session.hpp"

#include "facies/results/summary.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"
#include "facies/scenario/recorder.hpp"
#include "facies/scenario/stepper.hpp"

namespace facies::scenario {
namespace {

/// What may lie between model and paper while tissue passes through teeth: the band for the mouth corner's displacement [mm].
constexpr double mouth_corner_band = 3.0;

struct Outcome {
  bool converged = false;
  results::Headline rest, expression;
  std::map<std::string, double> displacement;  // landmark -> mm
};

Outcome carry_out(const std::string& name) {
  const Scenario scenario =
      read_scenario(std::filesystem::path(FACIES_SOURCE_DIR) / "scenarios" / (name + ".yaml"));
  const std::string spec = "artisynth:" + anatomy::reference_folder()->string();
  const auto model = build_model(anatomy::load_face(spec, anatomy::data_folder()), scenario, 2);
  const results::Subject subject = make_subject(*model);
  Stepper stepper(*model, scenario);
  solve::Observer silent;
  Outcome outcome;
  if (!stepper.take(1, silent).converged || !stepper.take(2, silent).converged) return outcome;
  const mechanics::State rest = stepper.state();
  outcome.rest =
      results::make_headline(subject, make_snapshot(*model, rest, stepper.controls()), nullptr);
  if (!stepper.take(3, silent).converged) return outcome;
  outcome.converged = true;
  outcome.expression = results::make_headline(
      subject, make_snapshot(*model, stepper.state(), stepper.controls()), &rest);
  for (const results::LandmarkMeasure& landmark : outcome.expression.landmarks) {
    outcome.displacement[landmark.landmark] = landmark.displacement;
  }
  return outcome;
}

double change_percent(const results::Headline& headline, const std::string& a,
                      const std::string& b) {
  for (const results::PairMeasure& pair : headline.pairs) {
    if (pair.a == a && pair.b == b) return pair.change_percent;
  }
  return 0.0;
}

class Expressions : public anatomy::ReferenceFaceTest {};

TEST_F(Expressions, ShowBonesAndTeethOfAJawThatIsHeld) {
  const Scenario scenario =
      read_scenario(std::filesystem::path(FACIES_SOURCE_DIR) / "scenarios" / "smile-open.yaml");
  const std::string spec = "artisynth:" + anatomy::reference_folder()->string();
  const auto model = build_model(anatomy::load_face(spec, anatomy::data_folder()), scenario, 1);
  const results::Subject subject = make_subject(*model);
  ASSERT_FALSE(subject.bones.empty());
  int n_teeth = 0;
  for (const results::BoneShape& bone : subject.bones) {
    EXPECT_EQ(bone.body, -1) << bone.name << " does not move";
    n_teeth += static_cast<int>(std::ranges::count(bone.is_tooth, true));
  }
  EXPECT_GT(n_teeth, 100);
}

TEST_F(Expressions, OpenSmileConvergesFromASkinUnderTensionAndMovesTheMouthCornerAsPublished) {
  const Outcome smile = carry_out("smile-open");
  ASSERT_TRUE(smile.converged);
  EXPECT_GE(smile.rest.tension.away_from_borders.value(), 0.95);
  EXPECT_NEAR(smile.rest.volumes.deformed / smile.rest.volumes.stress_free, 1.0, 0.03);
  EXPECT_GT(smile.expression.J.smallest, 0.0);
  EXPECT_GE(smile.expression.J.smallest_element, 0);
  EXPECT_GE(smile.expression.J.largest_element, 0);
  EXPECT_NEAR(smile.displacement.at("RMC"), 12.0, mouth_corner_band);
  EXPECT_GT(change_percent(smile.expression, "RMC", "LMC"), 0.0);  // the mouth widens
  EXPECT_LT(change_percent(smile.expression, "RC", "RMC"), 0.0);   // its corner comes up
}

TEST_F(Expressions, ClosedSmileMovesTheMouthCornerAsPublished) {
  const Outcome smile = carry_out("smile-closed");
  ASSERT_TRUE(smile.converged);
  EXPECT_NEAR(smile.displacement.at("RMC"), 10.7, mouth_corner_band);
}

TEST_F(Expressions, TurningTheLipsDownMovesTheMouthCornerAsPublished) {
  const Outcome down = carry_out("lips-down");
  ASSERT_TRUE(down.converged);
  EXPECT_NEAR(down.displacement.at("RMC"), 11.0, mouth_corner_band);
}

TEST_F(Expressions, PursingConvergesAndBringsTheMouthCornersTogether) {
  const Outcome purse = carry_out("purse");
  ASSERT_TRUE(purse.converged);
  EXPECT_LT(change_percent(purse.expression, "RMC", "LMC"), 0.0);
}

}  // namespace
}  // namespace facies::scenario
