// SPDX-License-Identifier: Apache-2.0
// Straight steps that are bent to what stiff parts allow.
#include <gtest/gtest.h>

#include "facies/mechanics/attachment.hpp"
#include "facies/mechanics/contact.hpp"
#include "facies/mechanics/joint.hpp"

namespace facies::mechanics {
namespace {

RigidBody bone() {
  return {"bone", {3, 1, -2}, 0.2, Vec3(250, 150, 280).asDiagonal()};
}

/// Increments of a model with one node and one body: a long way with a large turn.
std::vector<double> long_step(const Model& model) {
  std::vector<double> step(model.n_dofs());
  const std::vector<double> six = {3.0, -1.0, 2.0, 0.0, 8.0, 1.0};
  std::copy(six.begin(), six.end(), step.begin() + model.body_dof(0, 0));
  return step;
}

TEST(BentStep, KeepsATiedNodeOnTheBodyWhereItTurns) {
  Model model(1, {bone()});
  const Attachment& ties = model.add(std::make_unique<Attachment>(
      model,
      std::vector<Attachment::Tie>{{Anchor::on_node(0, {9, 9, 9}), Anchor::on_body(0, {9, 9, 9})}},
      1e7));
  const State from = model.initial_state();
  std::vector<double> step = long_step(model);
  Eigen::Map<Vec3>(step.data()) =
      way_of(model, from, Anchor::on_body(0, {9, 9, 9}), step);  // as Newton means it
  ASSERT_GT(ties.largest_gap(model.moved(from, step, 1.0)), 0.1) << "the turn is small";
  EXPECT_LT(ties.largest_gap(model.moved(from, model.bent(from, step, 1.0), 1.0)), 1e-12);
}

TEST(BentStep, KeepsGuidedPointsOnCurvedPaths) {
  Model model(1, {bone()});
  const SweptCurve valley = swept_curve(0.0, 0.0, 20.0, 0.0, -1.0, 1.0);
  const Joint& joint = model.add(
      std::make_unique<Joint>(model,
                              std::vector<Guide>{{"left", Anchor::on_body(0, {0, -8, 0}), valley},
                                                 {"right", Anchor::on_body(0, {0, 8, 0}), valley}},
                              std::vector<Stop>{}));
  const State from = model.initial_state();
  const auto farthest = [&](const State& state) {
    return std::max(std::abs(joint.view(state, 0).distance),
                    std::abs(joint.view(state, 1).distance));
  };
  ASSERT_NEAR(farthest(from), 0.0, 1e-12);
  // Along the tangent where both points stand.
  std::vector<double> step(model.n_dofs());
  step[at(model.body_dof(0, 0))] = -4.0;
  step[at(model.body_dof(0, 2))] = -4.0;
  ASSERT_GT(farthest(model.moved(from, step, 1.0)), 0.3) << "the path is nearly straight";
  EXPECT_LT(farthest(model.moved(from, model.bent(from, step, 1.0), 1.0)), 1e-4);
}

/// A bone on a level path, with a wall behind it, and a node that is tied to it.
class BoneBeforeAWall : public ::testing::Test {
 protected:
  static constexpr double level = -8.0;

  const Joint& add_joint(double wall) {
    const SweptCurve path = swept_curve(0.0, level, 20.0, 0.0, 0.0, 0.0);
    return model_.add(std::make_unique<Joint>(
        model_, std::vector<Guide>{{"path", Anchor::on_body(0, {0, 0, level}), path}},
        std::vector<Stop>{{"wall", Anchor::on_body(0, {5, 2, 3}), {wall, 0, 0}, Vec3::UnitX()}}));
  }

  const Attachment& add_tie() {
    const Vec3 X(9, 9, 9);
    return model_.add(std::make_unique<Attachment>(
        model_, std::vector<Attachment::Tie>{{Anchor::on_node(0, X), Anchor::on_body(0, X)}}, 1e7));
  }

  /// Backwards, and the tied node with the bone.
  [[nodiscard]] std::vector<double> backwards(double way) const {
    std::vector<double> step(model_.n_dofs());
    step[0] = step[at(model_.body_dof(0, 0))] = -way;
    return step;
  }

  [[nodiscard]] State after(const std::vector<double>& step) const {
    const State from = model_.initial_state();
    return model_.moved(from, model_.bent(from, step, 1.0), 1.0);
  }

  Model model_{1, {bone()}};
};

TEST_F(BoneBeforeAWall, StopsThereStaysOnItsPathAndKeepsWhatIsTiedToIt) {
  const Joint& joint = add_joint(4.0);
  const Attachment& tie = add_tie();
  const State state = after(backwards(3.0));
  EXPECT_NEAR(joint.distance(state, 0), -0.25 * Joint::rounding, 1e-6) << "where it is felt";
  EXPECT_NEAR(joint.view(state, 0).distance, 0.0, 1e-6);
  EXPECT_LT(tie.largest_gap(state), 1e-6);
}

TEST_F(BoneBeforeAWall, GoesWhereTheStepLeadsWhileItIsNotThere) {
  const Joint& joint = add_joint(1.0);
  add_tie();
  EXPECT_NEAR(joint.distance(after(backwards(3.0)), 0), 1.0, 1e-6);
}

TEST_F(BoneBeforeAWall, SinksInTwiceAsDeepAtMostUntilTheWallIsFullyFelt) {
  const Joint& joint = add_joint(5.003);
  EXPECT_NEAR(joint.distance(after(backwards(3.0)), 0), -0.006, 1e-6);
}

TEST_F(BoneBeforeAWall, GoesAsFarAsTheStepMeansWhereTheWallIsFullyFelt) {
  const Joint& joint = add_joint(5.02);
  EXPECT_NEAR(joint.distance(after(backwards(0.03)), 0), -0.05, 1e-6);
}

TEST(BentStep, OfASmallRatioIsTheStepItself) {
  Model model(1, {bone()});
  model.add(std::make_unique<Attachment>(
      model,
      std::vector<Attachment::Tie>{{Anchor::on_node(0, {9, 9, 9}), Anchor::on_body(0, {9, 9, 9})}},
      1e7));
  const State from = model.initial_state();
  std::vector<double> step = long_step(model);
  Eigen::Map<Vec3>(step.data()) = way_of(model, from, Anchor::on_body(0, {9, 9, 9}), step);
  const auto change = [&](double ratio) {
    const std::vector<double> bent = model.bent(from, step, ratio);
    double sum = 0.0;
    for (std::size_t k = 0; k < step.size(); ++k)
      sum += std::abs(bent[k] - ratio * step[k]);
    return sum;
  };
  EXPECT_NEAR(change(1e-3) / change(5e-4), 4.0, 0.01) << "of second order";
}

/// A node above a floor in space.
class NodeAboveAFloor : public ::testing::Test {
 protected:
  NodeAboveAFloor() {
    ContactSurface floor{"floor", {}, {{{0, 1, 2}}}};
    for (const Vec3& X : {Vec3(-90, -90, 0), Vec3(90, -90, 0), Vec3(0, 200, 0)})
      floor.vertices.push_back(Anchor::in_space(X));
    const ContactSettings settings{.d_hat = 0.5};
    model_.add(std::make_unique<Contact>(
        model_, std::vector<ContactPoint>{{Anchor::on_node(0, {0, 0, 2}), 1.0}}, floor, settings));
  }

  [[nodiscard]] Vec3 bent(const Vec3& step) const {
    const std::vector<double> increments = {step.x(), step.y(), step.z()};
    const std::vector<double> changed = model_.bent(model_.initial_state(), increments, 1.0);
    return {changed[0], changed[1], changed[2]};
  }

  Model model_{1};
};

TEST_F(NodeAboveAFloor, StopsShortOfItAndSlidesOn) {
  const Vec3 step = bent({3, -1, -5});
  EXPECT_NEAR(step.x(), 3.0, 1e-12);
  EXPECT_NEAR(step.y(), -1.0, 1e-12);
  EXPECT_GT(2.0 + step.z(), 0.1);
  EXPECT_LT(2.0 + step.z(), 0.5);
}

TEST_F(NodeAboveAFloor, GoesWhereNothingIsInTheWay) {
  EXPECT_EQ(bent({3, -1, 5}), Vec3(3, -1, 5));
  EXPECT_EQ(bent({0, 0, -1.2}), Vec3(0, 0, -1.2));
}

TEST(BentStep, GetsANodeDeeperIntoTheLayerByDegrees) {
  Model model(1);
  ContactSurface floor{"floor", {}, {{{0, 1, 2}}}};
  for (const Vec3& X : {Vec3(-90, -90, 0), Vec3(90, -90, 0), Vec3(0, 200, 0)})
    floor.vertices.push_back(Anchor::in_space(X));
  model.add(std::make_unique<Contact>(
      model, std::vector<ContactPoint>{{Anchor::on_node(0, {0, 0, 0.4}), 1.0}}, floor,
      ContactSettings{.d_hat = 0.5}));
  const std::vector<double> down = {0.0, 0.0, -0.35};  // passes nothing, but ends too near
  EXPECT_NEAR(0.4 + model.bent(model.initial_state(), down, 1.0)[2], 0.3, 1e-12)
      << "0.1 mm deep before, 0.2 after";
}

TEST(BentStep, TakesANodeHalfwayToTissueThatComesTowardsIt) {
  Model model(4);
  ContactSurface sheet{"sheet", {}, {{{0, 1, 2}}}};
  const std::array<Vec3, 3> corners = {Vec3(-90, -90, 0), Vec3(90, -90, 0), Vec3(0, 200, 0)};
  for (std::size_t k = 0; k < 3; ++k)
    sheet.vertices.push_back(Anchor::on_node(to_index(k), corners[k]));
  model.add(std::make_unique<Contact>(
      model, std::vector<ContactPoint>{{Anchor::on_node(3, {0, 0, 2}), 1.0}}, std::move(sheet),
      ContactSettings{.d_hat = 0.5}));
  std::vector<double> step(model.n_dofs());
  for (Index node = 0; node < 3; ++node)
    step[at(dof(node, 2))] = 3.0;
  step[at(dof(3, 2))] = -3.0;
  const std::vector<double> bent = model.bent(model.initial_state(), step, 1.0);
  EXPECT_NEAR(bent[at(dof(3, 2))], -0.5 * (2.0 - 0.45), 1e-12) << "0.45 mm are kept";
}

TEST_F(NodeAboveAFloor, PassesNothingHoweverFarItWants) {
  const std::vector<double> down = {0.0, 0.0, -5000.0};
  const State from = model_.initial_state();
  const State to = model_.moved(from, model_.bent(from, down, 1.0), 1.0);
  EXPECT_TRUE(model_.longest_step(from, to) < 1.0 || 2.0 + to.u[0].z() > 0.0);
}

}  // namespace
}  // namespace facies::mechanics
