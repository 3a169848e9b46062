// SPDX-License-Identifier: Apache-2.0
// Contact: forces from the barrier's energy, on both sides alike, and nothing that passes.
#include <cmath>
#include <limits>
#include <numbers>

#include "support/dense.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/math/barrier.hpp"
#include "facies/math/rotation.hpp"
#include "facies/mechanics/contact.hpp"

namespace facies::mechanics {
namespace {

constexpr ContactSettings settings{.d_hat = 0.5, .stiffness = 20.0, .reach = 2.0};

/// A roof of two triangles that share an edge, and a third beside them, tilted.
const std::vector<Vec3> roof_corners = {
    {0, 0, 0}, {4, 0, 0.3}, {4, 4, 0}, {0, 4, 0.5}, {8, 2, -0.4}};
const std::vector<std::array<Index, 3>> roof = {{{0, 1, 2}}, {{0, 2, 3}}, {{1, 4, 2}}};

/// What the roof belongs to; the points belong to nodes, but to the body where that presses on a roof of nodes.
enum class Surface { in_space, on_body, on_nodes, on_nodes_below_a_body };

/// Points above a roof that belongs to space, to a body or to nodes.
class PointsOnARoof : public ::testing::TestWithParam<Surface> {
 protected:
  PointsOnARoof() {
    contact_ = &add_contact(model_);
    state_ = model_.initial_state();
    support::Random random(3);
    for (std::size_t node = n_points; node < state_.u.size(); ++node)
      state_.u[node] = random.vector(-0.02, 0.02);
    state_.bodies[0] =
        moved(state_.bodies[0], random.vector(-0.02, 0.02), random.vector(-0.01, 0.01));
  }

  [[nodiscard]] const Contact& add_contact(Model& model) const {
    std::vector<ContactPoint> points;
    for (Index node = 0; node < n_points; ++node)
      points.push_back({anchor_of(node), 1.0 + 0.1 * node});
    ContactSurface surface{"roof", {}, roof};
    for (std::size_t v = 0; v < roof_corners.size(); ++v) {
      const Vec3& X = roof_corners[v];
      if (GetParam() == Surface::in_space) surface.vertices.push_back(Anchor::in_space(X));
      if (GetParam() == Surface::on_body) surface.vertices.push_back(Anchor::on_body(0, X));
      if (is_of_nodes()) surface.vertices.push_back(Anchor::on_node(n_points + to_index(v), X));
    }
    return model.add(std::make_unique<Contact>(model, points, surface, settings));
  }

  [[nodiscard]] bool is_of_nodes() const {
    return GetParam() == Surface::on_nodes || GetParam() == Surface::on_nodes_below_a_body;
  }

  [[nodiscard]] Anchor anchor_of(Index point) const {
    const Vec3& X = X_[at(point)];
    return GetParam() == Surface::on_nodes_below_a_body ? Anchor::on_body(0, X)
                                                        : Anchor::on_node(point, X);
  }

  [[nodiscard]] double energy(const State& state) const { return model_.energy(state, {}); }

  static constexpr Index n_points = 5;
  // Over a face, over the ridge, over an edge of the border, over a corner, far away.
  std::vector<Vec3> X_ = {
      {2.5, 1.0, 0.4}, {2, 2, 0.35}, {2, -0.1, 0.35}, {-0.1, -0.1, 0.2}, {2, 2, 5}};
  const std::vector<RigidBody> bone_ = {
      {"bone", {3, 1, -2}, 0.2, Vec3(250, 150, 280).asDiagonal()}};
  Model model_{10, bone_};
  const Contact* contact_ = nullptr;
  State state_;
};

TEST_P(PointsOnARoof, AreFeltWhereTheyAreNearAndNowhereElse) {
  const ContactReport report = contact_->report(state_);
  EXPECT_EQ(report.n_points, 4);
  EXPECT_GT(report.smallest_distance, 0.0);
  EXPECT_LT(report.smallest_distance, settings.d_hat);
  EXPECT_LT(report.force.z(), 0.0) << "the points press downwards";
}

TEST_P(PointsOnARoof, HaveForcesThatAreTheSlopeOfTheEnergy) {
  const Eigen::VectorXd r = support::residual(model_, state_, {});
  support::Random random(7);
  for (int trial = 0; trial < 4; ++trial) {
    std::vector<double> d(model_.n_dofs());
    for (double& component : d)
      component = random.uniform(-1.0, 1.0);
    const double h = 1e-5;
    const double slope =
        (energy(model_.moved(state_, d, h)) - energy(model_.moved(state_, d, -h))) / (2.0 * h);
    EXPECT_NEAR(r.dot(Eigen::Map<const Eigen::VectorXd>(d.data(), r.size())), slope,
                1e-6 * (1.0 + std::abs(slope)));
  }
}

TEST_P(PointsOnARoof, HaveATangentThatIsTheSecondSlopeOfTheEnergy) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, {});
  support::Random random(8);
  for (int trial = 0; trial < 4; ++trial) {
    std::vector<double> d(model_.n_dofs());
    for (double& component : d)
      component = random.uniform(-1.0, 1.0);
    const Eigen::Map<const Eigen::VectorXd> direction(d.data(), K.rows());
    const double h = 2e-4;
    const double second = (energy(model_.moved(state_, d, h)) - 2.0 * energy(state_) +
                           energy(model_.moved(state_, d, -h))) /
                          (h * h);
    EXPECT_NEAR(direction.dot(K * direction), second, 1e-4 * (1.0 + std::abs(second)));
  }
}

TEST_P(PointsOnARoof, PushTheSurfaceAsMuchAsItPushesThem) {
  if (GetParam() == Surface::in_space) GTEST_SKIP() << "space has no unknowns to push";
  const Eigen::VectorXd r = support::residual(model_, state_, {});
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  for (std::size_t node = 0; node < model_.n_nodes(); ++node) {
    const Vec3 f = r.segment<3>(static_cast<Eigen::Index>(3 * node));
    const Vec3 X = at(n_points) > node ? X_[node] : roof_corners[node - at(n_points)];
    force += f;
    moment += (X + state_.u[node]).cross(f);
  }
  const RigidBody& bone = model_.bodies()[0];
  const auto six = r.tail<6>();
  force += six.head<3>();
  moment +=
      (bone.centre + state_.bodies[0].u).cross(Vec3(six.head<3>())) + bone.arm() * six.tail<3>();
  EXPECT_LE(force.norm(), 1e-11);
  EXPECT_LE(moment.norm(), 1e-10);
}

TEST_P(PointsOnARoof, ListGroupsThatTheTangentFills) {
  Stencils now;
  contact_->list_stencils(state_, now);
  Stencils likely;
  contact_->likely_stencils(state_, likely);
  EXPECT_GE(now.size(), 4U);
  EXPECT_GE(likely.size(), now.size());
  EXPECT_TRUE(contact_->couplings_change());
}

TEST_P(PointsOnARoof, NeverPassInAStepOfAnySize) {
  for (const double way : {0.5, 5.0, 500.0}) {
    std::vector<double> down(model_.n_dofs(), 0.0);
    for (Index node = 0; node < n_points; ++node)
      down[at(dof(node, 2))] = -way;
    if (GetParam() == Surface::on_nodes_below_a_body) down[3 * model_.n_nodes() + 2] = -way;
    State state = state_;
    for (int step = 0; step < 50; ++step) {
      const double part = contact_->longest_step(state, model_.moved(state, down, 1.0));
      ASSERT_GE(part, 0.0);
      state = model_.moved(state, down, part);
      for (Index p = 0; p < 3; ++p)
        ASSERT_GT(place_of(model_, state, anchor_of(p)).z(), -0.5) << "over the roof";
      ASSERT_TRUE(std::isfinite(energy(state)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, PointsOnARoof,
                         ::testing::Values(Surface::in_space, Surface::on_body, Surface::on_nodes,
                                           Surface::on_nodes_below_a_body),
                         [](const auto& which) {
                           switch (which.param) {
                             case Surface::in_space:
                               return "space";
                             case Surface::on_body:
                               return "aBody";
                             case Surface::on_nodes:
                               return "nodes";
                             default:
                               return "nodesBelowABody";
                           }
                         });

TEST(Contact, PressesAsTheBarrierSaysOverAPlane) {
  Model model(1);
  const std::vector<ContactPoint> points = {{Anchor::on_node(0, {1, 1, 0.2}), 3.0}};
  ContactSurface plane{"plane", {}, {{{0, 1, 2}}}};
  for (const Vec3& X : {Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 20, 0)})
    plane.vertices.push_back(Anchor::in_space(X));
  const Contact& contact = model.add(std::make_unique<Contact>(model, points, plane, settings));
  const State state = model.initial_state();
  const double p = -settings.stiffness * barrier(0.2, settings.d_hat).db_dd;
  EXPECT_NEAR(support::residual(model, state, {})(2), -3.0 * p, 1e-12);
  EXPECT_NEAR(contact.report(state).largest_pressure, p, 1e-12);
  EXPECT_NEAR(contact.report(state).force.z(), -3.0 * p, 1e-12);
}

TEST(Contact, CostsNothingToSlideAlongAPlaneHoweverItIsCut) {
  Model model(1);
  const std::vector<ContactPoint> points = {{Anchor::on_node(0, {-0.31, -0.27, 0.2}), 3.0}};
  // The point comes over edges and, nearly, over the vertices of a plane in many triangles.
  ContactSurface plane{"plane", {}, {}};
  constexpr Index n = 40;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      plane.vertices.push_back(Anchor::in_space({i - 10.0, j - 10.0, 0.0}));
      if (i == n || j == n) continue;
      const Index a = i * (n + 1) + j;
      plane.triangles.push_back({a, a + n + 1, a + n + 2});
      plane.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  model.add(std::make_unique<Contact>(model, points, plane, settings));
  State state = model.initial_state();
  const double before = model.energy(state, {});
  for (int step = 0; step < 200; ++step) {
    state.u[0] += Vec3(0.057, 0.031, 0.0);
    EXPECT_NEAR(model.energy(state, {}), before, 1e-12);
    EXPECT_NEAR(support::residual(model, state, {}).head<2>().norm(), 0.0, 1e-12);
  }
}

TEST_P(PointsOnARoof, AreFeltTheSameWhateverStatesWereLookedAtBefore) {
  std::vector<State> states = {state_, state_, state_};
  states[1].u[1].z() -= 0.05;  // a point alone moves
  for (std::size_t node = n_points; node < state_.u.size(); ++node)
    states[2].u[node].z() += 0.05;  // the roof alone, where it can
  states[2].bodies[0].u.z() += 0.05;
  for (const std::size_t which : {0U, 1U, 2U, 0U, 2U, 2U, 1U, 0U}) {
    Model fresh(10, bone_);
    (void)add_contact(fresh);
    EXPECT_EQ(energy(states[which]), fresh.energy(states[which], {}));
    EXPECT_EQ(support::residual(model_, states[which], {}),
              support::residual(fresh, states[which], {}));
  }
}

TEST_P(PointsOnARoof, CannotGoWhereTheRoofHasGoneAstray) {
  if (!is_of_nodes()) GTEST_SKIP() << "only nodes can";
  for (const double wild : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t node = n_points; node < state_.u.size(); ++node) {
      State state = state_;
      state.u[node].x() = wild;
      EXPECT_EQ(contact_->longest_step(state_, state), 0.0) << wild << " at " << node;
    }
  }
}

TEST_P(PointsOnARoof, HaveNoEnergyWhereATrialHasGoneAstray) {
  for (const double wild : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    State state = state_;
    (GetParam() == Surface::on_nodes_below_a_body ? state.bodies[0].u : state.u[0]).x() = wild;
    EXPECT_EQ(energy(state), std::numeric_limits<double>::infinity());
    std::vector<double> r(model_.n_dofs());
    EXPECT_FALSE(model_.residual(state, {}, r));
    EXPECT_EQ(contact_->longest_step(state_, state), 0.0);
  }
}

TEST(Contact, IsNotFeltByAPointThatBelongsToTheTriangle) {
  Model model(3);
  ContactSurface surface{"skin", {}, {{{0, 1, 2}}}};
  std::vector<ContactPoint> points;
  for (Index node = 0; node < 3; ++node) {
    const Vec3 X(node == 1, node == 2, 0);
    surface.vertices.push_back(Anchor::on_node(node, X));
    points.push_back({Anchor::on_node(node, X), 1.0});
  }
  const Contact& contact = model.add(std::make_unique<Contact>(model, points, surface, settings));
  EXPECT_EQ(model.energy(model.initial_state(), {}), 0.0);
  EXPECT_EQ(contact.report(model.initial_state()).n_points, 0);
}

/// A strip of skin, a row of squares of 0.4 mm, rolled to this radius; every vertex is a point as well.
ContactReport report_of_rolled_strip(double radius) {
  constexpr Index n = 20;
  constexpr double size = 0.4;
  ContactSurface surface{"skin", {}, {}};
  std::vector<ContactPoint> points;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= 2; ++j) {
      const double angle = size * i / radius;
      const Vec3 X(radius * std::sin(angle), size * j, radius * (1.0 - std::cos(angle)));
      const Anchor anchor = Anchor::on_node(3 * i + j, X);
      surface.vertices.push_back(anchor);
      points.push_back({anchor, size * size});
      if (i == n || j == 2) continue;
      const Index a = 3 * i + j;
      surface.triangles.push_back({a, a + 3, a + 4});
      surface.triangles.push_back({a, a + 4, a + 1});
    }
  }
  Model model(3 * (n + 1));
  const Contact& contact = model.add(std::make_unique<Contact>(model, points, surface, settings));
  return contact.report(model.initial_state());
}

TEST(Contact, IsNotFeltByAPointFromItsOwnSurroundings) {
  EXPECT_NEAR(report_of_rolled_strip(4.0).largest_pressure, 0.0, 1e-12)
      << "bent, and nowhere near itself";
}

TEST(Contact, IsFeltWhereASurfaceComesRoundToItself) {
  const double full_turn = 0.4 * 20 / (2.0 * std::numbers::pi);
  EXPECT_GT(report_of_rolled_strip(1.05 * full_turn).largest_pressure, 0.0);
}

}  // namespace
}  // namespace facies::mechanics
