// SPDX-License-Identifier: Apache-2.0
// What every term owes: a residual that is the derivative of its energy, a tangent that is the derivative of its residual,
// a pattern that holds the tangent. A new term is one more line of all_terms().
#include <functional>
#include <set>

#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

namespace facies::mechanics {
namespace {

using support::BlockCells;

struct TermCase {
  std::string name;
  std::function<std::unique_ptr<const Term>(const mesh::Mesh&)> make;
};

std::ostream& operator<<(std::ostream& out, const TermCase& which) {
  return out << which.name;
}

/// Tissue with a pre-stretch that differs from element to element and three muscles: the state of the tests lengthens
/// two of them and shortens one, far from the kink at rest length.
std::unique_ptr<const Term> make_solid(const mesh::Mesh& mesh, const std::string& law,
                                       const std::string& passive) {
  support::Random random(17);
  SolidDescription description = support::uniform_solid(mesh, nullptr, support::log_volume(250.0));
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    description.law[e] = support::example_law(law, random.rotation());
    description.F0[e] = 1.1 * random.deformation_gradient(0.02);
  }
  const support::FibrePointer fibre = support::example_fibre(passive);
  const std::array<Vec3, 3> directions = {Vec3(1, 0.2, 0), Vec3(-0.3, 1, 0), Vec3(0.1, 0, 1)};
  for (std::size_t m = 0; m < directions.size(); ++m) {
    description.fibres.push_back(
        support::uniform_fibres(mesh, fibre, to_index(m), directions[m].normalized()));
  }
  return std::make_unique<const Solid>(mesh, std::move(description), 2);
}

std::vector<TermCase> all_terms() {
  std::vector<TermCase> cases;
  for (const material::LawSpec& law : material::laws()) {
    for (const std::string passive : {"none", "kPa", "sigma_max"}) {
      cases.push_back({"solid_" + law.name + "_passive_" + passive, [=](const mesh::Mesh& mesh) {
                         return make_solid(mesh, law.name, passive);
                       }});
    }
  }
  cases.push_back({"gravity", [](const mesh::Mesh& mesh) {
                     const std::vector<double> density(mesh.n_elements(), 1e-6);
                     return std::make_unique<const Gravity>(lumped_mass(mesh, density, {}));
                   }});
  cases.push_back(
      {"nodal_forces", [](const mesh::Mesh&) { return std::make_unique<const NodalForces>(); }});
  return cases;
}

class AnyTerm : public ::testing::TestWithParam<TermCase> {
 protected:
  void SetUp() override {
    model_.add(GetParam().make(mesh_));
    controls_.activation = {0.3, 0.0, 1.0};
    controls_.gravity = {100, 0, -9800};
    support::Random random(9);
    for (std::size_t node = 0; node < mesh_.n_nodes(); ++node)
      controls_.nodal_force.push_back(random.vector(-1, 1));
  }

  mesh::Mesh mesh_ = support::make_block(
      {.size = {3, 2, 2}, .n = {3, 2, 2}, .cells = BlockCells::mixed, .shake = 0.15});
  Model model_{mesh_.n_nodes()};
  Controls controls_;
  State state_ = support::affine_state(mesh_, Vec3(1.2, 1.15, 0.85).asDiagonal(), {1, 2, 3}, 0.02);
};

TEST_P(AnyTerm, HasTheDerivativeOfItsEnergyAsResidual) {
  const Eigen::VectorXd r = support::residual(model_, state_, controls_);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Eigen::VectorXd d = support::random_direction(model_.n_dofs(), seed);
    const auto W = [&](double h) { return model_.energy(support::moved(state_, d, h), controls_); };
    EXPECT_GE(support::remainder_slope(W, support::inner_product(r, d)), 1.9);
  }
}

TEST_P(AnyTerm, HasTheDerivativeOfItsResidualAsTangent) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Eigen::VectorXd d = support::random_direction(model_.n_dofs(), seed);
    const auto r = [&](double h) {
      return support::residual(model_, support::moved(state_, d, h), controls_);
    };
    EXPECT_GE(support::remainder_slope(r, K * d), 1.9);
  }
}

TEST_P(AnyTerm, ListsGroupsOfUnknownsThatExistOnce) {
  Stencils stencils;
  model_.terms()[0]->list_stencils(state_, stencils);
  for (std::size_t g = 0; g < stencils.size(); ++g) {
    std::set<Index> seen;
    for (const Index dof : stencils[g]) {
      EXPECT_GE(dof, 0);
      EXPECT_LT(at(dof), model_.n_dofs());
      EXPECT_TRUE(seen.insert(dof).second);
    }
  }
}

TEST_P(AnyTerm, HasAName) {
  EXPECT_FALSE(model_.terms()[0]->name().empty());
}

INSTANTIATE_TEST_SUITE_P(Terms, AnyTerm, ::testing::ValuesIn(all_terms()),
                         [](const auto& which) { return which.param.name; });

/// Terms that come from inside feel no rigid motion; dead loads do.
using InnerTerm = AnyTerm;

TEST_P(InnerTerm, KeepsItsEnergyAndTurnsItsForcesInARigidMotion) {
  const Mat3 Q = support::Random(4).rotation();
  const Vec3 b(5, -3, 2);
  State turned = state_;
  for (std::size_t node = 0; node < turned.u.size(); ++node) {
    const Vec3 X = mesh_.X()[node];
    turned.u[node] = Q * (X + state_.u[node]) + b - X;
  }
  const double W = model_.energy(state_, controls_);
  EXPECT_NEAR(model_.energy(turned, controls_), W, 1e-11 * std::abs(W));
  const Eigen::VectorXd r = support::residual(model_, state_, controls_);
  const Eigen::VectorXd r_turned = support::residual(model_, turned, controls_);
  Eigen::VectorXd expected = r;
  for (Eigen::Index i = 0; i < r.size(); i += 3)
    expected.segment<3>(i) = Q * r.segment<3>(i);
  EXPECT_LE(support::norm_of(r_turned - expected), 1e-11 * support::norm_of(r));
}

TEST_P(InnerTerm, HasTranslationsInTheNullSpaceOfItsTangent) {
  const Eigen::MatrixXd K = support::dense_tangent(model_, state_, controls_);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd translation =
        Vec3::Unit(axis).replicate(static_cast<Eigen::Index>(mesh_.n_nodes()), 1);
    EXPECT_LE(support::norm_of(K * translation), 1e-12 * support::norm_of(K));
  }
}

INSTANTIATE_TEST_SUITE_P(Terms, InnerTerm, ::testing::ValuesIn([] {
                           std::vector<TermCase> cases = all_terms();
                           std::erase_if(cases, [](const TermCase& c) {
                             return c.name.rfind("solid", 0) != 0;
                           });
                           return cases;
                         }()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace facies::mechanics
