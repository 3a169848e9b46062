// SPDX-License-Identifier: Apache-2.0
// The same bits for any number of threads.
#include "support/blocks.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/contact.hpp"

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

/// A sheet of n by n squares of 1 mm, with bumps.
ContactSurface bumpy_sheet(Index n, support::Random& random) {
  ContactSurface sheet{"sheet", {}, {}};
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      sheet.vertices.push_back(
          Anchor::on_node(to_index(sheet.vertices.size()), Vec3(i, j, random.uniform(-0.1, 0.1))));
      if (i == n || j == n) continue;
      const Index a = i * (n + 1) + j;
      sheet.triangles.push_back({a, a + n + 1, a + n + 2});
      sheet.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  return sheet;
}

/// Everything that a contact answers: points over a sheet, of tissue or of bone, that fall on it.
struct ContactAnswers {
  double E = 0.0;
  double longest_step = 0.0;
  std::vector<double> r;
  std::vector<double> K;
  std::vector<double> bent;
  std::vector<Index> likely;
};

ContactAnswers ask_contact(bool is_bone, int threads) {
  support::Random random(6);
  ContactSurface sheet = bumpy_sheet(6, random);
  const auto n_vertices = to_index(sheet.vertices.size());
  std::vector<ContactPoint> points;
  for (Index k = 0; k < 60; ++k) {
    const Vec3 X = Vec3(3.0, 3.0, 0.5) + random.vector(-3.0, 3.0).cwiseProduct(Vec3(1, 1, 0.1));
    points.push_back({Anchor::on_node(n_vertices + k, X), random.uniform(0.5, 2.0)});
  }
  for (Anchor& vertex : sheet.vertices) {
    if (is_bone) vertex = Anchor::in_space(vertex.X);
  }
  Model model(at(n_vertices + 60));
  const Contact& contact = model.add(std::make_unique<Contact>(
      model, points, std::move(sheet), ContactSettings{.threads = threads}));
  const State state = model.initial_state();

  ContactAnswers answers;
  answers.E = model.energy(state, {});
  answers.r.resize(model.n_dofs());
  EXPECT_TRUE(model.residual(state, {}, answers.r));
  const Eigen::MatrixXd K = support::dense_tangent(model, state, {});
  answers.K.assign(K.data(), K.data() + K.size());
  std::vector<double> fall(model.n_dofs());
  for (Index k = 0; k < 60; ++k)
    fall[at(dof(n_vertices + k, 2))] = -random.uniform(0.0, 2.0);
  answers.longest_step = contact.longest_step(state, model.moved(state, fall, 1.0));
  answers.bent = fall;
  contact.bend(state, fall, answers.bent);
  EXPECT_NE(answers.bent, fall) << "some would run into it";
  Stencils likely;
  contact.likely_stencils(state, likely);
  answers.likely = likely.dofs;
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

TEST_P(Threads, DoNotChangeABitOfContact) {
  for (const bool is_bone : {false, true}) {
    const ContactAnswers one = ask_contact(is_bone, 1);
    const ContactAnswers many = ask_contact(is_bone, GetParam());
    EXPECT_GT(one.E, 0.0);
    EXPECT_LT(one.longest_step, 1.0);
    EXPECT_TRUE(support::same_bits<double>({one.E, one.longest_step}, {many.E, many.longest_step}));
    EXPECT_TRUE(support::same_bits(one.r, many.r)) << "residual";
    EXPECT_TRUE(support::same_bits(one.K, many.K)) << "tangent";
    EXPECT_TRUE(support::same_bits(one.bent, many.bent)) << "bent step";
    EXPECT_EQ(one.likely, many.likely);
  }
}

INSTANTIATE_TEST_SUITE_P(Numbers, Threads, ::testing::Values(1, 2, 3, 4, 7));

}  // namespace
}  // namespace facies::mechanics
