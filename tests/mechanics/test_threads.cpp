// SPDX-License-Identifier: Apache-2.0
// The same bits for any number of threads.
#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include <gtest/gtest.h>

namespace facies::mechanics {
namespace {

/// Everything that a solid answers, computed with `threads` threads.
struct Answers {
  double W = 0.0;
  std::vector<double> r;
  std::vector<double> K;
  std::vector<double> sigma;
  Inadmissible why;
};

Answers ask(int threads) {
  const mesh::Mesh mesh =
      support::make_block({.n = {5, 4, 3}, .cells = support::BlockCells::mixed, .shake = 0.2});
  SolidDescription description = support::uniform_solid(
      mesh, support::example_law("fung_orthotropic"), support::log_volume(250.0));
  description.fibres.push_back(
      support::uniform_fibres(mesh, support::example_fibre("kPa"), 0, Vec3::UnitX()));
  const support::SolidModel model(mesh, std::move(description), threads);
  const Controls controls = support::activated({0.5});
  State state = support::affine_state(mesh, Vec3(1.1, 0.95, 1.0).asDiagonal(), {1, 2, 3}, 0.01);

  Answers answers;
  answers.W = model.model.energy(state, controls);
  answers.r.resize(model.model.n_dofs());
  EXPECT_TRUE(model.model.residual(state, controls, answers.r));
  const Eigen::MatrixXd K = support::dense_tangent(model.model, state, controls);
  answers.K.assign(K.data(), K.data() + K.size());
  for (const ElementMeans& means : model.solid->means(state, controls)) {
    const auto components = means.sigma.components();
    answers.sigma.insert(answers.sigma.end(), components.begin(), components.end());
    answers.sigma.push_back(means.J);
  }
  for (const std::size_t node : {40U, 70U, 100U})
    state.u[node] = {1, 1, 1};
  std::vector<double> worthless(model.model.n_dofs());
  EXPECT_FALSE(model.model.residual(state, controls, worthless, &answers.why));
  return answers;
}

class Threads : public ::testing::TestWithParam<int> {};

TEST_P(Threads, DoNotChangeABit) {
  const Answers one = ask(1);
  const Answers many = ask(GetParam());
  EXPECT_TRUE(support::same_bits<double>({one.W}, {many.W})) << "energy";
  EXPECT_TRUE(support::same_bits(one.r, many.r)) << "residual";
  EXPECT_TRUE(support::same_bits(one.K, many.K)) << "tangent";
  EXPECT_TRUE(support::same_bits(one.sigma, many.sigma)) << "stress";
  EXPECT_EQ(one.why.element, many.why.element) << "of several inverted elements the first";
  EXPECT_TRUE(support::same_bits<double>({one.why.J}, {many.why.J}));
}

INSTANTIATE_TEST_SUITE_P(Numbers, Threads, ::testing::Values(1, 2, 3, 4, 7));

}  // namespace
}  // namespace facies::mechanics
