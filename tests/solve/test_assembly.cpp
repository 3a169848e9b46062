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
  /// The matrix of these nonzeros.
  [[nodiscard]] Eigen::MatrixXd dense(const std::vector<double>& values) const {
    const SparsityPattern& pattern = assembly_.pattern();
    const auto n = static_cast<Eigen::Index>(pattern.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    for (Index row = 0; row < to_index(pattern.size()); ++row) {
      for (Index k = pattern.row_begin[at(row)]; k < pattern.row_begin[at(row) + 1]; ++k)
        A(row, pattern.column[at(k)]) = A(pattern.column[at(k)], row) = values[at(k)];
    }
    return A;
  }

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
  const Eigen::MatrixXd K = support::dense_tangent(model_.model, state_, controls_);
  std::vector<double> values(assembly_.pattern().n_nonzeros(), 7.0);  // overwritten
  assembly_.tangent(state_, controls_, 0.0, values, {}, {});
  Eigen::MatrixXd left_over = K;
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
      EXPECT_NEAR(values[at(k)], K(i, j), 1e-11);
      left_over(i, j) = left_over(j, i) = 0.0;
    }
  }
  EXPECT_EQ(support::norm_of(left_over), 0.0) << "the pattern misses a coupling";
}

TEST_F(AssemblyOfASolid, GivesTheForcesOfPrescribedUnknownsThatMove) {
  const Eigen::MatrixXd K = support::dense_tangent(model_.model, state_, controls_);
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(K.rows());
  support::Random random(2);
  for (const Index dof : held_)
    moves(dof) = random.uniform(-1.0, 1.0);
  const Eigen::VectorXd expected = K * moves;
  std::vector<double> values(assembly_.pattern().n_nonzeros());
  std::vector<double> coupling(assembly_.equations().size(), 0.0);
  assembly_.tangent(state_, controls_, 0.0, values,
                    {moves.data(), static_cast<std::size_t>(moves.size())}, coupling);
  for (std::size_t k = 0; k < coupling.size(); ++k)
    EXPECT_NEAR(coupling[k], expected(assembly_.equations().dof_of_equation[k]), 1e-10);
}

TEST_F(AssemblyOfASolid, MadePositiveDoesNotLoseStiffnessAndHasNoNegativeEigenvalue) {
  // Pressed across its fibres the block is unstable.
  state_ = support::affine_state(model_.mesh, Vec3(1.0, 1.0, 0.75).asDiagonal());
  controls_.activation = {0.0};
  std::vector<double> exact(assembly_.pattern().n_nonzeros());
  std::vector<double> positive(assembly_.pattern().n_nonzeros());
  assembly_.tangent(state_, controls_, 0.0, exact, {}, {});
  assembly_.tangent(state_, controls_, 1.0, positive, {}, {});
  const Eigen::MatrixXd K = dense(exact);
  const Eigen::MatrixXd K_positive = dense(positive);
  ASSERT_LT(support::symmetric_eigenvalues(K).front(), -0.1)
      << "the case does not test what it should";
  EXPECT_GT(support::symmetric_eigenvalues(K_positive).front(), 0.0);
  EXPECT_GE(support::symmetric_eigenvalues(K_positive - K).front(), -1e-10)
      << "positive blocks may only add";
}

TEST_F(AssemblyOfASolid, MadePositiveIsTheTangentWhereThatIsPositiveAlready) {
  state_ = model_.model.initial_state();
  controls_.activation = {0.0};
  std::vector<double> exact(assembly_.pattern().n_nonzeros());
  std::vector<double> positive(assembly_.pattern().n_nonzeros());
  assembly_.tangent(state_, controls_, 0.0, exact, {}, {});
  assembly_.tangent(state_, controls_, 1.0, positive, {}, {});
  for (std::size_t k = 0; k < exact.size(); ++k)
    EXPECT_NEAR(positive[k], exact[k], 1e-11);
}

TEST_F(AssemblyOfASolid, HasTheSameBitsForAnyNumberOfThreads) {
  std::vector<double> moves(model_.model.n_dofs(), 0.0);
  for (const Index dof : held_)
    moves[at(dof)] = 0.1 * dof;
  for (const double positivity : {0.0, 0.5, 1.0}) {
    std::vector<double> values(assembly_.pattern().n_nonzeros());
    std::vector<double> coupling(assembly_.equations().size(), 0.0);
    assembly_.tangent(state_, controls_, positivity, values, moves, coupling);
    for (const int threads : {2, 3, 4}) {
      const SolidModel again = make_model(threads);
      const Assembly assembly(again.model, held_);
      std::vector<double> values_again(values.size());
      std::vector<double> coupling_again(coupling.size(), 0.0);
      assembly.tangent(state_, controls_, positivity, values_again, moves, coupling_again);
      EXPECT_TRUE(support::same_bits(values, values_again)) << threads;
      EXPECT_TRUE(support::same_bits(coupling, coupling_again)) << threads;
    }
  }
}

}  // namespace
}  // namespace facies::solve
