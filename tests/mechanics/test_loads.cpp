// SPDX-License-Identifier: Apache-2.0
// Masses and dead loads.
#include <numeric>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/loads.hpp"
#include "facies/mechanics/model.hpp"

namespace facies::mechanics {
namespace {

using support::BlockCells;

constexpr double density = 1.04e-6;  // [kg/mm^3]

Vec3 centre_of_mass(const mesh::Mesh& mesh, std::span<const double> mass) {
  Vec3 moment = Vec3::Zero();
  for (std::size_t node = 0; node < mass.size(); ++node)
    moment += mass[node] * mesh.X()[node];
  return moment / std::accumulate(mass.begin(), mass.end(), 0.0);
}

class LumpedMass : public ::testing::TestWithParam<BlockCells> {
 protected:
  mesh::Mesh mesh_ =
      support::make_block({.size = {3, 2, 4}, .n = {3, 2, 3}, .cells = GetParam(), .shake = 0.2});
  std::vector<double> density_ = std::vector<double>(mesh_.n_elements(), density);
};

TEST_P(LumpedMass, AddsUpToDensityTimesVolume) {
  const std::vector<double> mass = lumped_mass(mesh_, density_, {});
  EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0), density * 24.0, 1e-13 * density);
  for (const double m : mass)
    EXPECT_GT(m, 0.0);
}

TEST_P(LumpedMass, KeepsTheCentreOfMass) {
  // The integral of density X is exact for linear elements, so moments of weight are right as well as the weight.
  const std::vector<double> mass = lumped_mass(mesh_, density_, {});
  EXPECT_TRUE(centre_of_mass(mesh_, mass).isApprox(Vec3(1.5, 1, 2), 1e-13));
}

TEST_P(LumpedMass, IsThatOfTheStressFreeTissue) {
  const Mat3 F0 = Vec3(1.1, 1.2, 0.9).asDiagonal();
  const std::vector<Mat3> field(mesh_.n_elements(), F0);
  const std::vector<double> mass = lumped_mass(mesh_, density_, field);
  EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0), density * 24.0 / F0.determinant(),
              1e-13 * density);
}

INSTANTIATE_TEST_SUITE_P(Blocks, LumpedMass,
                         ::testing::Values(BlockCells::hexahedra, BlockCells::wedges,
                                           BlockCells::mixed),
                         [](const auto& which) { return support::name_of(which.param); });

TEST(Gravity, PullsEveryMassAndDoesWork) {
  const Gravity gravity({2e-6, 5e-6});
  State state{{{0, 0, 0}, {1, 0, 3}}};
  Controls controls;
  controls.gravity = {0, 0, -9800};
  std::vector<double> r(6, 1.0);  // terms add
  ASSERT_TRUE(gravity.add_residual(state, controls, r, nullptr));
  EXPECT_DOUBLE_EQ(r[2], 1.0 + 2e-6 * 9800);
  EXPECT_DOUBLE_EQ(r[5], 1.0 + 5e-6 * 9800);
  EXPECT_DOUBLE_EQ(r[4], 1.0);
  EXPECT_DOUBLE_EQ(gravity.energy(state, controls), 5e-6 * 9800 * 3);
}

TEST(Gravity, PullsRigidBodiesAtTheirCentres) {
  RigidBody body;
  body.mass = 0.2;
  const Model model(1, {body, body});
  const Gravity gravity({2e-6}, model.bodies());
  State state = model.initial_state();
  state.bodies[1].u = {0, 0, 5};
  Controls controls;
  controls.gravity = controls.body_gravity = {0, 0, -9800};
  std::vector<double> r(model.n_dofs(), 0.0);
  ASSERT_TRUE(gravity.add_residual(state, controls, r, nullptr));
  for (const Index b : {0, 1}) {
    EXPECT_DOUBLE_EQ(r[at(model.body_dof(b, 2))], 0.2 * 9800);
    EXPECT_EQ(r[at(model.body_dof(b, 3))], 0.0);
  }
  EXPECT_DOUBLE_EQ(r[2], 2e-6 * 9800);
  EXPECT_DOUBLE_EQ(gravity.energy(state, controls), 0.2 * 9800 * 5);
}

TEST(NodalForces, AreNothingWhereNoneAreGiven) {
  const NodalForces forces;
  const State state{{{1, 2, 3}}};
  std::vector<double> r(3, 0.0);
  ASSERT_TRUE(forces.add_residual(state, {}, r, nullptr));
  EXPECT_EQ(r, std::vector<double>(3, 0.0));
  EXPECT_EQ(forces.energy(state, {}), 0.0);
}

}  // namespace
}  // namespace facies::mechanics
