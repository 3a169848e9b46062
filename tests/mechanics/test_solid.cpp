// SPDX-License-Identifier: Apache-2.0
// The solid on a mesh: volumes, pre-stretch, stress, and what it says about states and input that it cannot use.
#include <gmock/gmock.h>
#include <limits>
#include <numeric>

#include "support/blocks.hpp"
#include "support/closed_forms.hpp"
#include "support/dense.hpp"
#include "support/models.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"

namespace facies::mechanics {
namespace {

using support::BlockCells;
using support::SolidModel;
using support::uniform_solid;
using ::testing::HasSubstr;

constexpr double kappa = 50.0;

mesh::Mesh distorted_block(BlockCells cells) {
  return support::make_block({.size = {3, 2, 4}, .n = {3, 2, 3}, .cells = cells, .shake = 0.2});
}

/// Mooney-Rivlin tissue with one muscle along `a0`.
SolidDescription muscle_tissue(const mesh::Mesh& mesh, const Mat3& F0, const Vec3& a0) {
  SolidDescription description =
      uniform_solid(mesh, support::example_law("mooney_rivlin"), support::log_volume(kappa), F0);
  description.fibres.push_back(
      support::uniform_fibres(mesh, support::example_fibre("none"), 0, a0));
  return description;
}

const Controls half_active = support::activated({0.5});

class SolidOnABlock : public ::testing::TestWithParam<BlockCells> {
 protected:
  mesh::Mesh mesh_ = distorted_block(GetParam());
};

TEST_P(SolidOnABlock, HasTheVolumeOfTheStressFreeTissue) {
  const Mat3 F0 = Vec3(1.1, 1.2, 0.9).asDiagonal();
  const SolidModel model(mesh_, muscle_tissue(mesh_, F0, Vec3::UnitX()));
  const std::span<const double> V0 = model.solid->volume0();
  ASSERT_EQ(V0.size(), mesh_.n_elements());
  EXPECT_NEAR(std::accumulate(V0.begin(), V0.end(), 0.0), 24.0 / F0.determinant(), 1e-12);
}

TEST_P(SolidOnABlock, WithPreStretchIsTheSmallerBlockStretched) {
  // F0 = TSF I on the mesh, or no F0 on the mesh divided by TSF: at the same positions the same forces.
  const double tsf = 1.1;
  const Vec3 a0 = Vec3(1, 2, 0.5).normalized();
  const mesh::Mesh small = support::mapped(mesh_, [&](const Vec3& X) -> Vec3 { return X / tsf; });
  const SolidModel stretched(mesh_, muscle_tissue(mesh_, tsf * Mat3::Identity(), a0));
  const SolidModel scaled(small, muscle_tissue(small, Mat3::Identity(), a0));
  const State state =
      support::affine_state(mesh_, Vec3(1.1, 0.95, 1.0).asDiagonal(), {1, 2, 3}, 0.05);
  State same_place = state;
  for (std::size_t node = 0; node < state.u.size(); ++node)
    same_place.u[node] += mesh_.X()[node] - small.X()[node];
  const Eigen::VectorXd r = support::residual(stretched.model, state, half_active);
  const Eigen::VectorXd r_scaled = support::residual(scaled.model, same_place, half_active);
  EXPECT_GT(support::norm_of(r), 1.0);
  EXPECT_LE(support::norm_of(r - r_scaled), 1e-12 * support::norm_of(r));
  const double W = stretched.model.energy(state, half_active);
  EXPECT_NEAR(scaled.model.energy(same_place, half_active), W, 1e-12 * std::abs(W));
}

TEST_P(SolidOnABlock, PullsWithTheShareOfAnElementThatIsFibre) {
  const Vec3 a0 = Vec3(1, 2, 0.5).normalized();
  SolidDescription shared = muscle_tissue(mesh_, Mat3::Identity(), a0);
  FibreFamily rest = shared.fibres.front();
  for (std::size_t k = 0; k < rest.elements.size(); ++k) {
    const double share = (1.0 + static_cast<double>(k)) / (2.0 + static_cast<double>(k));
    shared.fibres.front().shares.push_back(share);
    rest.shares.push_back(1.0 - share);
  }
  shared.fibres.push_back(rest);
  const SolidModel whole(mesh_, muscle_tissue(mesh_, Mat3::Identity(), a0));
  const SolidModel parts(mesh_, shared);
  const State state =
      support::affine_state(mesh_, Vec3(1.1, 0.95, 1.0).asDiagonal(), {1, 2, 3}, 0.05);
  const Eigen::VectorXd r = support::residual(whole.model, state, half_active);
  EXPECT_LE(support::norm_of(r - support::residual(parts.model, state, half_active)),
            1e-12 * support::norm_of(r));
}

TEST_P(SolidOnABlock, CarriesFibresBackWithThePreStretch) {
  // A fibre that lies along a0 in the mesh lies along F0^-1 a0 in the stress-free tissue, and F F0 brings it back.
  Mat3 F0;
  F0 << 1.1, 0.2, 0, 0, 0.95, -0.1, 0.05, 0, 1.05;
  const Vec3 a0 = Vec3(1, 2, 0.5).normalized();
  const Mat3 F = Vec3(1.1, 0.9, 1.2).asDiagonal();
  const SolidModel model(mesh_, muscle_tissue(mesh_, F0, a0));
  const Mat3 F_e = F * F0;
  const Mat3 expected =
      support::mooney_rivlin_cauchy(0.4, 0.15, 1.4, kappa, F_e) +
      support::fibre_cauchy(F_e, (F0.inverse() * a0).normalized(), [](double) { return 50.0; });
  for (const ElementMeans& means :
       model.solid->means(support::affine_state(mesh_, F, {1, 0, 0}), half_active)) {
    EXPECT_TRUE(to_matrix(means.sigma).isApprox(expected, 1e-11));
    EXPECT_NEAR(means.J, F_e.determinant(), 1e-12);
  }
}

TEST_P(SolidOnABlock, HasNoForceInARigidMotion) {
  const SolidModel model(mesh_, uniform_solid(mesh_, support::example_law("fung_orthotropic"),
                                              support::log_volume(kappa)));
  const Mat3 Q = support::Random(8).rotation();
  const State state = support::affine_state(mesh_, Q, {4, -5, 6});
  EXPECT_LE(support::norm_of(support::residual(model.model, state, {})), 1e-11);
  EXPECT_NEAR(model.model.energy(state, {}), 0.0, 1e-12);
}

TEST_P(SolidOnABlock, NamesTheElementThatIsInsideOut) {
  const SolidModel model(mesh_, muscle_tissue(mesh_, Mat3::Identity(), Vec3::UnitX()));
  // The last node of the last element goes far through the block: that element is inside out, the first ones are not.
  State state = model.model.initial_state();
  const Index last = to_index(mesh_.n_elements()) - 1;
  state.u[at(mesh_.element(last).connectivity().back())] = {0, 0, -3.0};
  std::vector<double> r(model.model.n_dofs());
  Inadmissible why;
  EXPECT_FALSE(model.model.residual(state, half_active, r, &why));
  EXPECT_FALSE(model.model.residual(state, half_active, r)) << "asking why is optional";
  EXPECT_LT(why.J, 0.0);
  const auto touched = mesh_.element(why.element).connectivity();
  EXPECT_NE(std::find(touched.begin(), touched.end(), mesh_.element(last).connectivity().back()),
            touched.end());
  EXPECT_EQ(model.model.energy(state, half_active), std::numeric_limits<double>::infinity());
}

TEST_P(SolidOnABlock, NamesTheElementThatHasGrownTheMostBeyondItsLaw) {
  // F0 has the volume 1.5: at 4.9 times the volume of the mesh J is 7.35 (e^2 is 7.389), at 5 times 7.5.
  const Mat3 F0 = std::cbrt(1.5) * Mat3::Identity();
  const SolidModel model(mesh_, muscle_tissue(mesh_, F0, Vec3::UnitX()));
  const auto grown = [&](double volume) {
    return support::affine_state(mesh_, std::cbrt(volume) * Mat3::Identity());
  };
  EXPECT_EQ(model.model.overgrown(model.model.initial_state()).element, -1);
  EXPECT_EQ(model.model.overgrown(grown(4.9)).element, -1);
  State state = grown(5.0);
  const Inadmissible found = model.model.overgrown(state);
  EXPECT_GE(found.element, 0);
  EXPECT_NEAR(found.J, 7.5, 1e-12);

  const Index last = to_index(mesh_.n_elements()) - 1;
  state.u[at(mesh_.element(last).connectivity().back())] += Vec3(0.1, 0.1, 0.1);
  const auto touched = mesh_.element(model.model.overgrown(state).element).connectivity();
  EXPECT_NE(std::find(touched.begin(), touched.end(), mesh_.element(last).connectivity().back()),
            touched.end());
  EXPECT_GT(model.model.overgrown(state).J, 7.5);
}

TEST_P(SolidOnABlock, DoesNotAcceptNotANumber) {
  const SolidModel model(mesh_, muscle_tissue(mesh_, Mat3::Identity(), Vec3::UnitX()));
  State state = model.model.initial_state();
  state.u[0].x() = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> r(model.model.n_dofs());
  EXPECT_FALSE(model.model.residual(state, half_active, r));
}

INSTANTIATE_TEST_SUITE_P(Blocks, SolidOnABlock,
                         ::testing::Values(BlockCells::hexahedra, BlockCells::wedges,
                                           BlockCells::mixed),
                         [](const auto& which) { return support::name_of(which.param); });

TEST(Solid, AddsToWhatIsThere) {
  const SolidModel model(
      distorted_block(BlockCells::mixed),
      muscle_tissue(distorted_block(BlockCells::mixed), Mat3::Identity(), Vec3::UnitX()));
  const State state = model.model.initial_state();
  std::vector<double> once(model.model.n_dofs(), 0.0);
  std::vector<double> twice(model.model.n_dofs(), 0.0);
  ASSERT_TRUE(model.solid->add_residual(state, half_active, once, nullptr));
  ASSERT_TRUE(model.solid->add_residual(state, half_active, twice, nullptr));
  ASSERT_TRUE(model.solid->add_residual(state, half_active, twice, nullptr));
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_NEAR(twice[i], 2.0 * once[i], 1e-12);
}

TEST(Solid, RefusesElementsThatAreInsideOutOrFlat) {
  const mesh::Mesh good = support::make_block({.n = {2, 1, 1}});
  std::vector<Vec3> X(good.X().begin(), good.X().end());
  for (const Index node : good.nodes("x_max"))
    X[at(node)].x() = 0.2;  // the second of the two elements turns inside out
  const mesh::Mesh bad(X, {good.elements().begin(), good.elements().end()});
  try {
    const Solid solid(bad, muscle_tissue(bad, Mat3::Identity(), Vec3::UnitX()), 1);
    FAIL() << "accepted";
  } catch (const DataError& error) {
    ASSERT_EQ(error.problems().size(), 1U);
    EXPECT_EQ(error.problems()[0].where, "element 1 (counted from 0)");
    EXPECT_THAT(error.problems()[0].found, HasSubstr("inverted or flat"));
  }
  for (const Index node : good.nodes("x_max"))
    X[at(node)].x() = 0.5;
  const mesh::Mesh flat(X, {good.elements().begin(), good.elements().end()});
  EXPECT_THROW(Solid(flat, muscle_tissue(flat, Mat3::Identity(), Vec3::UnitX()), 1), DataError);
}

TEST(Solid, RefusesMoreFibreFamiliesThanAnElementCanCarry) {
  const mesh::Mesh mesh = support::make_block({.n = {1, 1, 1}});
  SolidDescription description = muscle_tissue(mesh, Mat3::Identity(), Vec3::UnitX());
  const FibreFamily family = description.fibres.front();
  description.fibres.resize(Solid::max_families, family);
  EXPECT_NO_THROW(Solid(mesh, description, 1));
  description.fibres.push_back(family);
  try {
    const Solid solid(mesh, description, 1);
    FAIL() << "accepted";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("element 0 (counted from 0)"));
    EXPECT_THAT(error.what(), HasSubstr("17 muscles"));
    EXPECT_THAT(error.what(), HasSubstr("at most 16"));
  }
}

TEST(Solid, RefusesADescriptionOfAnotherMesh) {
  const mesh::Mesh mesh = support::make_block({.n = {2, 1, 1}});
  const SolidDescription good = muscle_tissue(mesh, Mat3::Identity(), Vec3::UnitX());
  SolidDescription bad = good;
  bad.law.pop_back();
  EXPECT_THROW(Solid(mesh, bad, 1), BugError);
  bad = good;
  bad.volumetric.pop_back();
  EXPECT_THROW(Solid(mesh, bad, 1), BugError);
  bad = good;
  bad.F0.pop_back();
  EXPECT_THROW(Solid(mesh, bad, 1), BugError);
  bad = good;
  bad.fibres[0].directions.pop_back();
  EXPECT_THROW(Solid(mesh, bad, 1), BugError);
  bad = good;
  bad.fibres[0].elements[0] = 2;
  EXPECT_THROW(Solid(mesh, bad, 1), BugError);
}

TEST(Solid, RefusesAPreStretchThatTurnsTissueInsideOut) {
  const mesh::Mesh mesh = support::make_block({.n = {2, 1, 1}});
  SolidDescription description = muscle_tissue(mesh, Mat3::Identity(), Vec3::UnitX());
  description.F0[1] = -Mat3::Identity();
  EXPECT_THROW(Solid(mesh, description, 1), BugError);
  description.F0[1] = Mat3::Zero();
  EXPECT_THROW(Solid(mesh, description, 1), BugError);
}

TEST(Solid, NeedsAnActivationForEveryMuscle) {
  const mesh::Mesh mesh = support::make_block({.n = {1, 1, 1}});
  const SolidModel model(mesh, muscle_tissue(mesh, Mat3::Identity(), Vec3::UnitX()));
  std::vector<double> r(model.model.n_dofs());
  const State state = model.model.initial_state();
  EXPECT_THROW((void)model.model.energy(state, {}), BugError);
  EXPECT_THROW((void)model.model.residual(state, {}, r), BugError);
  EXPECT_THROW((void)support::dense_tangent(model.model, state, {}), BugError);
  EXPECT_THROW((void)model.solid->means(state, {}), BugError);
}

}  // namespace
}  // namespace facies::mechanics
