// SPDX-License-Identifier: Apache-2.0
// What test_terms.cpp asks of every term, for terms that act on rigid bodies in any pose. A new one is one more line of
// body_terms().
#include <array>
#include <functional>
#include <set>

#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/math/rotation.hpp"
#include "facies/mechanics/attachment.hpp"
#include "facies/mechanics/hill_muscle.hpp"
#include "facies/mechanics/joint.hpp"

namespace facies::mechanics {
namespace {

constexpr std::array<int, 3> axes{0, 1, 2};

Anchor of_body(Index body, const Vec3& X) {
  return Anchor::on_body(body, X);
}

std::unique_ptr<const Term> make_muscles(const Model& model, bool inner) {
  const HillParameters active{5e3, 30.0, 45.0, 0.1, 0.5, 0.0};
  std::vector<HillMuscle> muscles{
      {"bodies", of_body(0, {10, 2, 0}), of_body(1, {-12, 5, 20}), active},
      {"one body", of_body(1, {3, 2, 0}), of_body(1, {-12, 5, 20}), active},
      {"node", Anchor::on_node(0, {1, 1, 1}), of_body(1, {5, 20, 3}), active},
      {"nodes", Anchor::on_node(0, {1, 1, 1}), Anchor::on_node(1, {15, 18, 3}), active}};
  if (!inner) {
    muscles.push_back({"space", Anchor::in_space({40, 0, 0}), of_body(0, {5, -7, 3}), active});
    muscles.push_back({"fixed", Anchor::in_space({40, 0, 0}), Anchor::in_space({0, 0, 0}), active});
  }
  return std::make_unique<const HillMuscles>(model, std::move(muscles));
}

std::unique_ptr<const Term> make_attachment(const Model& model, bool inner) {
  std::vector<Attachment::Tie> ties{{Anchor::on_node(0, {1, 1, 1}), of_body(0, {1, 1, 1})},
                                    {of_body(0, {8, 0, 3}), of_body(1, {8, 0, 3})},
                                    {Anchor::on_node(0, {1, 1, 1}), Anchor::on_node(1, {1, 1, 1})}};
  if (!inner) ties.push_back({of_body(1, {2, 4, 9}), Anchor::in_space({2, 4, 9})});
  return std::make_unique<const Attachment>(model, std::move(ties), 300.0);
}

std::unique_ptr<const Term> make_guides(const Model& model) {
  const SweptCurve curve = swept_curve(20.0, 5.0, 12.0, 5.0, -0.7, -0.2);
  return std::make_unique<const Joint>(
      model,
      std::vector<Guide>{{"a", of_body(0, {3, 4, 5}), curve},
                         {"b", of_body(1, {-3, 9, 2}), curve},
                         {"c", Anchor::on_node(1, {12, 0, 2}), curve}},
      std::vector<Stop>{}, 200.0);
}

/// Planes that their points have passed by `sunk` in the state of the tests.
std::unique_ptr<const Term> make_stops(const Model& model, const State& state, double sunk) {
  support::Random random(31);
  std::vector<Stop> stops;
  for (const Anchor& anchor :
       {of_body(0, {3, 4, 5}), of_body(1, {-3, 9, 2}), Anchor::on_node(1, {12, 0, 2})}) {
    const Vec3 normal = random.unit_vector();
    stops.push_back({"s", anchor, place_of(model, state, anchor) + sunk * normal, normal});
  }
  return std::make_unique<const Joint>(model, std::vector<Guide>{}, std::move(stops), 200.0);
}

struct BodyTerm {
  std::string name;
  std::function<std::unique_ptr<const Term>(const Model&, const State&)> make;
  bool inner = false;   ///< exerts forces between things that move, only
  double h_max = 1e-2;  ///< within which it is smooth
};

std::ostream& operator<<(std::ostream& out, const BodyTerm& which) {
  return out << which.name;
}

std::vector<BodyTerm> body_terms() {
  return {
      {"muscles", [](const Model& m, const State&) { return make_muscles(m, false); }},
      {"inner_muscles", [](const Model& m, const State&) { return make_muscles(m, true); }, true},
      {"attachment", [](const Model& m, const State&) { return make_attachment(m, false); }},
      {"inner_attachment", [](const Model& m, const State&) { return make_attachment(m, true); },
       true},
      {"guides", [](const Model& m, const State&) { return make_guides(m); }},
      {"stops_passed", [](const Model& m, const State& s) { return make_stops(m, s, 0.4); }},
      {"stops_touched", [](const Model& m, const State& s) { return make_stops(m, s, 0.005); },
       false, 1e-4},
      {"stops_free", [](const Model& m, const State& s) { return make_stops(m, s, -0.4); }},
      {"gravity",
       [](const Model& m, const State&) {
         return std::make_unique<const Gravity>(std::vector<double>{2.0, 3.0}, m.bodies());
       }},
  };
}

RigidBody body(const Vec3& centre, double mass) {
  return {"bone", centre, mass, (mass * Vec3(20, 30, 40)).asDiagonal()};
}

class AnyBodyTerm : public ::testing::TestWithParam<BodyTerm> {
 protected:
  void SetUp() override {
    support::Random random(12);
    state_ = model_.initial_state();
    for (Vec3& u : state_.u)
      u = random.vector(-3, 3);
    for (Pose& pose : state_.bodies)
      pose = {random.vector(-4, 4), random.rotation()};
    controls_.excitation = {0.8, 0.4, 1.0, 0.2, 0.6, 0.5};
    if (GetParam().inner) controls_.excitation.resize(4);
    if (GetParam().name.find("muscles") == std::string::npos) controls_.excitation.clear();
    controls_.gravity = {30, 0, -98};
    controls_.body_gravity = {-20, 5, -97};
    model_.add(GetParam().make(model_, state_));
  }

  /// Increments of the unknowns [n_dofs], each within +-1; those of rotations nothing where there are to be none.
  [[nodiscard]] Eigen::VectorXd direction(std::uint64_t seed, bool with_rotations) const {
    Eigen::VectorXd d = support::random_direction(model_.n_dofs(), seed);
    for (const Index b : {0, 1}) {
      if (!with_rotations) d.segment<3>(model_.body_dof(b, 3)).setZero();
    }
    return d;
  }

  [[nodiscard]] State moved(const Eigen::VectorXd& d, double h) const {
    return model_.moved(state_, {d.data(), static_cast<std::size_t>(d.size())}, h);
  }

  Model model_{2, {body({2, 3, 4}, 0.3), body({-5, 6, 10}, 0.7)}};
  State state_;
  Controls controls_;
};

TEST_P(AnyBodyTerm, HasTheDerivativeOfItsEnergyAsResidual) {
  const Eigen::VectorXd r = support::residual(model_, state_, controls_);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Eigen::VectorXd d = direction(seed, true);
    const auto E = [&](double h) { return model_.energy(moved(d, h), controls_); };
    EXPECT_GE(support::remainder_slope(E, support::inner_product(r, d), GetParam().h_max), 1.9);
  }
}

// Along exp(h w) R the derivative of the energy is r . d at every h, so that of r . d is the energy's second one.
TEST_P(AnyBodyTerm, HasTheSecondDerivativeOfItsEnergyAsTangent) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Eigen::VectorXd d = direction(seed, true);
    const auto dE = [&](double h) {
      return support::inner_product(support::residual(model_, moved(d, h), controls_), d);
    };
    const Eigen::VectorXd Kd = K * d;
    EXPECT_GE(support::remainder_slope(dE, support::inner_product(d, Kd), GetParam().h_max), 1.9);
  }
}

TEST_P(AnyBodyTerm, HasTheDerivativeOfItsResidualByPlacesAsTangent) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Eigen::VectorXd d = direction(seed, false);
    const auto r = [&](double h) { return support::residual(model_, moved(d, h), controls_); };
    EXPECT_GE(support::remainder_slope(r, Eigen::VectorXd(K * d), GetParam().h_max), 1.9);
  }
}

TEST_P(AnyBodyTerm, ListsGroupsOfUnknownsThatExistOnce) {
  Stencils stencils;
  model_.terms()[0]->list_stencils(state_, stencils);
  for (std::size_t g = 0; g < stencils.size(); ++g) {
    std::set<Index> seen;
    EXPECT_FALSE(stencils[g].empty());
    for (const Index dof : stencils[g]) {
      EXPECT_TRUE(dof >= 0 && at(dof) < model_.n_dofs());
      EXPECT_TRUE(seen.insert(dof).second);
    }
  }
}

TEST_P(AnyBodyTerm, HasAName) {
  EXPECT_FALSE(model_.terms()[0]->name().empty());
}

std::string name_of(const ::testing::TestParamInfo<BodyTerm>& which) {
  return which.param.name;
}

INSTANTIATE_TEST_SUITE_P(Terms, AnyBodyTerm, ::testing::ValuesIn(body_terms()), name_of);

/// Forces between things that move feel no common rigid motion.
class InnerBodyTerm : public AnyBodyTerm {
 protected:
  /// Places of the mesh: what displacements count from.
  const std::array<Vec3, 2> X_{Vec3(1, 1, 1), Vec3(15, 18, 3)};
};

TEST_P(InnerBodyTerm, BalancesItsForcesAndMoments) {
  const Eigen::VectorXd r = support::residual(model_, state_, controls_);
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  // Where anchors of one node count from different places the test would have to know; they do not here.
  const bool tied = GetParam().name == "inner_attachment";
  for (std::size_t node = 0; node < 2; ++node) {
    const Vec3 f = r.segment<3>(static_cast<Eigen::Index>(3 * node));
    force += f;
    moment += ((tied ? X_[0] : X_[node]) + state_.u[node]).cross(f);
  }
  for (const Index b : {0, 1}) {
    const Vec3 f = r.segment<3>(model_.body_dof(b, 0));
    force += f;
    moment += (model_.bodies()[at(b)].centre + state_.bodies[at(b)].u).cross(f);
    moment += model_.bodies()[at(b)].arm() * Vec3(r.segment<3>(model_.body_dof(b, 3)));
  }
  EXPECT_GT(support::norm_of(r), 1.0);
  EXPECT_LE(force.norm(), 1e-12 * support::norm_of(r));
  EXPECT_LE(moment.norm(), 1e-11 * support::norm_of(r));
}

TEST_P(InnerBodyTerm, KeepsItsEnergyAndTurnsItsForcesInARigidMotion) {
  const Mat3 Q = support::Random(4).rotation();
  const Vec3 b(5, -3, 2);
  const bool tied = GetParam().name == "inner_attachment";
  State turned = state_;
  for (std::size_t node = 0; node < 2; ++node) {
    const Vec3& X = tied ? X_[0] : X_[node];
    turned.u[node] = Q * (X + state_.u[node]) + b - X;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3& centre = model_.bodies()[k].centre;
    turned.bodies[k] = {Q * (centre + state_.bodies[k].u) + b - centre, Q * state_.bodies[k].R};
  }
  const double E = model_.energy(state_, controls_);
  EXPECT_NEAR(model_.energy(turned, controls_), E, 1e-11 * std::abs(E));
  const Eigen::VectorXd r = support::residual(model_, state_, controls_);
  Eigen::VectorXd expected = r;
  for (Eigen::Index i = 0; i < r.size(); i += 3)
    expected.segment<3>(i) = Q * r.segment<3>(i);
  EXPECT_LE(support::norm_of(support::residual(model_, turned, controls_) - expected),
            1e-11 * support::norm_of(r));
}

TEST_P(InnerBodyTerm, FeelsNoCommonTranslation) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
  for (const int axis : axes) {
    Eigen::VectorXd translation = Eigen::VectorXd::Zero(K.rows());
    for (const Index first : {dof(0, 0), dof(1, 0), model_.body_dof(0, 0), model_.body_dof(1, 0)})
      translation(first + axis) = 1.0;
    EXPECT_LE(support::norm_of(K * translation), 1e-12 * support::norm_of(K));
  }
}

INSTANTIATE_TEST_SUITE_P(Terms, InnerBodyTerm, ::testing::ValuesIn([] {
                           std::vector<BodyTerm> cases = body_terms();
                           std::erase_if(cases, [](const BodyTerm& c) { return !c.inner; });
                           return cases;
                         }()),
                         name_of);

TEST(Attachment, TellsHowFarItsWorstTieHasGivenWay) {
  const Model model(1, {body({0, 0, 0}, 1.0)});
  const Attachment ties(model, {{Anchor::on_node(0, {10, 0, 0}), of_body(0, {10, 0, 0})}}, 1e6);
  State state = model.initial_state();
  EXPECT_EQ(ties.largest_gap(state), 0.0);
  state.bodies[0] = moved({}, {0, 0, 1}, {0, 0, 0.3});
  state.u[0] = place_of(model, state, of_body(0, {10, 0, 0})) - Vec3(10, 0, 0) + Vec3(0, 0.02, 0);
  EXPECT_NEAR(ties.largest_gap(state), 0.02, 1e-14);
  EXPECT_NEAR(ties.energy(state, {}), 0.5 * 1e6 * 0.02 * 0.02, 1e-8);
}

}  // namespace
}  // namespace facies::mechanics
