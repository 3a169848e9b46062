// SPDX-License-Identifier: Apache-2.0
// Sparse tangents against dense ones, prescribed unknowns that move, and threads.
#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/solve/assembly.hpp"

namespace facies::solve {
namespace {

using support::SolidModel;

SolidModel make_model(int threads) {
  const mesh::Mesh mesh =
      support::make_block({.n = {4, 3, 2}, .cells = support::BlockCells::mixed, .shake = 0.2});
  mechanics::SolidDescription description = support::uniform_solid(
      mesh, support::example_law("fung_orthotropic"), support::log_volume(250.0));
  description.fibres.push_back(
      support::uniform_fibres(mesh, support::example_fibre("kPa"), 0, Vec3::UnitX()));
  return {mesh, std::move(description), threads};
}

class AssemblyOfASolid : public ::testing::Test {
 protected:
  SolidModel model_ = make_model(1);
  std::vector<Index> held_ = support::Supports()
                                 .clamp(model_.mesh.nodes("z_min"))
                                 .hold(model_.mesh.nodes("x_max"), 0)
                                 .prescribed()
                                 .dofs;
  Assembly assembly_{model_.model, held_};
  mechanics::State state_ =
      support::affine_state(model_.mesh, Vec3(1.1, 0.95, 1.0).asDiagonal(), {1, 0, 0}, 0.01);
  mechanics::Controls controls_ = support::activated({0.5});
};

TEST_F(AssemblyOfASolid, IsTheDenseTangentOverTheFreeUnknowns) {
  const Eigen::MatrixXd dense = support::dense_tangent(model_.model, state_, controls_);
  std::vector<double> values(assembly_.pattern().n_nonzeros(), 7.0);  // overwritten
  assembly_.tangent(state_, controls_, Blocks::exact, values, {}, {});
  Eigen::MatrixXd left_over = dense;
  for (const Index dof : held_) {
    left_over.row(dof).setZero();
    left_over.col(dof).setZero();
  }
  const std::vector<Index>& dofs = assembly_.equations().dof_of_equation;
  for (Index row = 0; row < to_index(assembly_.pattern().size()); ++row) {
    for (Index k = assembly_.pattern().row_begin[at(row)];
         k < assembly_.pattern().row_begin[at(row) + 1]; ++k) {
      const Index i = dofs[at(row)];
      const Index j = dofs[at(assembly_.pattern().column[at(k)])];
      EXPECT_NEAR(values[at(k)], dense(i, j), 1e-11);
      left_over(i, j) = left_over(j, i) = 0.0;
    }
  }
  EXPECT_EQ(support::norm_of(left_over), 0.0) << "the pattern misses a coupling";
}

TEST_F(AssemblyOfASolid, GivesTheForcesOfPrescribedUnknownsThatMove) {
  const Eigen::MatrixXd dense = support::dense_tangent(model_.model, state_, controls_);
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(dense.rows());
  support::Random random(2);
  for (const Index dof : held_)
    moves(dof) = random.uniform(-1.0, 1.0);
  const Eigen::VectorXd expected = dense * moves;
  std::vector<double> values(assembly_.pattern().n_nonzeros());
  std::vector<double> coupling(assembly_.equations().size(), 0.0);
  assembly_.tangent(state_, controls_, Blocks::exact, values,
                    {moves.data(), static_cast<std::size_t>(moves.size())}, coupling);
  for (std::size_t k = 0; k < coupling.size(); ++k)
    EXPECT_NEAR(coupling[k], expected(assembly_.equations().dof_of_equation[k]), 1e-10);
}

TEST_F(AssemblyOfASolid, HasTheSameBitsForAnyNumberOfThreads) {
  std::vector<double> moves(model_.model.n_dofs(), 0.0);
  for (const Index dof : held_)
    moves[at(dof)] = 0.1 * dof;
  std::vector<double> values(assembly_.pattern().n_nonzeros());
  std::vector<double> coupling(assembly_.equations().size(), 0.0);
  assembly_.tangent(state_, controls_, Blocks::exact, values, moves, coupling);
  for (const int threads : {2, 3, 4}) {
    const SolidModel again = make_model(threads);
    const Assembly assembly(again.model, held_);
    std::vector<double> values_again(values.size());
    std::vector<double> coupling_again(coupling.size(), 0.0);
    assembly.tangent(state_, controls_, Blocks::exact, values_again, moves, coupling_again);
    EXPECT_TRUE(support::same_bits(values, values_again)) << threads;
    EXPECT_TRUE(support::same_bits(coupling, coupling_again)) << threads;
  }
}

}  // namespace
}  // namespace facies::solve
