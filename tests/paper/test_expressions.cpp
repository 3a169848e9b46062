// SPDX-License-Identifier: Apache-2.0
// The paper's own face through its own protocol, nothing tuned: tension, release and the expressions of Table 3, with contact and a
// jaw that moves. Numbers are compared with the paper's within 15 % and 4 points; what does not reach them yet
// (docs/paper.md) is held to its sign.
#include "face_run.hpp"

namespace facies::scenario {
namespace {

constexpr double aim = 0.15;         // of a displacement
constexpr double aim_percent = 4.0;  // points, of a change of distance

class Expressions : public FaceRun {};

TEST_F(Expressions, OpenSmileBeginsAtASkinUnderTensionAndMovesTheMouthAsPublished) {
  ASSERT_TRUE(carry_out("smile-open"));
  expect_contact_and_jaw_in_order();
  const results::Headline rest = headline(2);
  EXPECT_GE(rest.tension.away_from_borders.value(), 0.95);
  EXPECT_NEAR(rest.volumes.deformed / rest.volumes.stress_free, 1.0, 0.03);
  const results::Headline smile = headline(4);
  EXPECT_GT(smile.J.smallest, 0.0);
  EXPECT_GE(smile.J.smallest_element, 0);
  EXPECT_GE(smile.J.largest_element, 0);
  const std::map<std::string, double> displacement = displacements();
  EXPECT_NEAR(displacement.at("RMC"), 12.0, aim * 12.0);
  EXPECT_NEAR(displacement.at("PG"), 3.5, aim * 3.5);
  EXPECT_NEAR(change_percent("RMC", "LMC"), 18.0, aim_percent);
  EXPECT_NEAR(change_percent("RC", "RMC"), -18.0, aim_percent);
  EXPECT_GT(change_percent("PH", "SL"), 15.0);
}

// "The PG displacement was much greater than the displacement for an open-mouth smile": 3.5 mm.
TEST_F(Expressions, ClosedSmileMovesTheMouthCornerAsPublishedAndTheChinMuchFartherThanTheOpenOne) {
  ASSERT_TRUE(carry_out("smile-closed"));
  expect_contact_and_jaw_in_order();
  EXPECT_NEAR(displacements().at("RMC"), 10.7, aim * 10.7);
  EXPECT_GT(displacements().at("PG"), 1.5 * 3.5);
}

TEST_F(Expressions, TurningTheLipsDownMovesTheMouthCornerAsPublished) {
  ASSERT_TRUE(carry_out("lips-down"));
  expect_contact_and_jaw_in_order();
  EXPECT_NEAR(displacements().at("RMC"), 11.0, aim * 11.0);
}

TEST_F(Expressions, PursingBringsTheMouthCornersTogetherAsPublished) {
  ASSERT_TRUE(carry_out("purse"));
  expect_contact_and_jaw_in_order();
  EXPECT_NEAR(change_percent("RMC", "LMC"), -25.0, aim_percent);
}

TEST_F(Expressions, TheOpenersTakeTheIncisorsApartAsPublished) {
  ASSERT_TRUE(carry_out("mouth-open"));
  expect_contact_and_jaw_in_order();
  EXPECT_NEAR(measure_jaw(*model_, states_.back())->incisor_distance, 40.0, aim * 40.0);
}

TEST_F(Expressions, ShowBonesAndTeethOfAJawThatIsHeld) {
  Scenario scenario =
      read_scenario(std::filesystem::path(FACIES_SOURCE_DIR) / "scenarios" / "smile-open.yaml");
  scenario.jaw = "held";
  scenario.contact = {.bones = false, .skull = "none", .lips = false};
  scenario.steps.resize(3);  // without the one that opens the jaw
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

}  // namespace
}  // namespace facies::scenario
