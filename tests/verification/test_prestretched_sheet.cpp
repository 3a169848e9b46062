// SPDX-License-Identifier: Apache-2.0
// Living tension: a sheet of skin on hypodermis with F0 = TSF I, held along its edge, against the one-dimensional solution
// of each layer (in-plane stretch TSF, no stress across the thickness).
#include "support/bisection.hpp"
#include "support/closed_forms.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/layered_sheet.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::State;
using support::SolidModel;

constexpr double tsf = 1.10;
constexpr double kappa_skin = 250.0;
constexpr double kappa_hypodermis = 50.0;

/// What one layer does: its stress along x (across the sheet), y and z, and the elastic stretch across the sheet.
struct LayerSolution {
  Vec3 lambda;  ///< elastic
  Vec3 sigma;   ///< [kPa]
};

LayerSolution solve_layer(const support::PrincipalResponse& response, double kappa) {
  const auto stretches = [](double across) { return Vec3(across, tsf, tsf); };
  const double across = support::bisect(
      [&](double s) { return support::principal_cauchy(response, kappa, stretches(s)).x(); }, 0.6,
      1.2);
  return {stretches(across), support::principal_cauchy(response, kappa, stretches(across))};
}

mesh::Mesh make_sheet(mesh::SheetCells cells) {
  mesh::SheetOptions options;
  options.n_y = options.n_z = 6;
  options.layers = {{"skin", 1.5, 1}, {"hypodermis", 5.0, 2}};
  options.cells = cells;
  return mesh::make_layered_sheet(options);
}

class PreStretchedSheet : public ::testing::TestWithParam<mesh::SheetCells> {
 protected:
  /// Skin with a1 along z, a2 outwards (-x), a3 = a1 x a2 (-y).
  static SolidModel make(const mesh::Mesh& mesh) {
    Mat3 axes;
    axes << Vec3::UnitZ(), -Vec3::UnitX(), -Vec3::UnitY();
    mechanics::SolidDescription description =
        support::uniform_solid(mesh, support::example_law("fung_orthotropic", axes),
                               support::log_volume(kappa_skin), tsf * Mat3::Identity());
    for (const Index e : mesh.elements("hypodermis")) {
      description.law[at(e)] = support::example_law("mooney_rivlin");
      description.volumetric[at(e)] = support::log_volume(kappa_hypodermis);
    }
    return {mesh, std::move(description)};
  }

  [[nodiscard]] LayerSolution expected(bool is_skin) const {
    if (!is_skin)
      return solve_layer(support::principal_mooney_rivlin(0.4, 0.15, 1.4), kappa_hypodermis);
    const material::Parameters p = material::find_law("fung_orthotropic")->example;
    return solve_layer(support::principal_fung(p, {2, 0, 1}), kappa_skin);
  }

  [[nodiscard]] static NewtonReport solve(const SolidModel& sheet, State& state,
                                          const support::Supports& supports) {
    return solve_equilibrium(sheet.model, state, {}, supports.prescribed(),
                             {.relative_tolerance = 1e-12});
  }
};

TEST_P(PreStretchedSheet,
       ClampedAtItsEdgeAndFreeInThicknessFollowsTheOneDimensionalSolutionOfEachLayer) {
  const SolidModel sheet = make(make_sheet(GetParam()));
  support::Supports supports;
  supports.hold(sheet.mesh.nodes("rim"), 1).hold(sheet.mesh.nodes("rim"), 2);
  supports.hold(sheet.mesh.nodes("inner"), 0);
  State state = sheet.model.initial_state();
  const NewtonReport report = solve(sheet, state, supports);
  ASSERT_TRUE(report.converged) << report.reason;

  const std::vector<mechanics::ElementMeans> means = sheet.solid->means(state, {});
  for (const bool is_skin : {true, false}) {
    const LayerSolution layer = expected(is_skin);
    for (const Index e : sheet.mesh.elements(is_skin ? "skin" : "hypodermis")) {
      const Sym3<double>& sigma = means[at(e)].sigma;
      EXPECT_LE((Vec3(sigma.xx, sigma.yy, sigma.zz) - layer.sigma).norm(), 1e-8);
      EXPECT_NEAR(means[at(e)].J, layer.lambda.prod(), 1e-9);
    }
  }
  // F0 stretches across the sheet, too: what the layers become is the elastic stretch by TSF.
  const double skin = 1.5 * expected(true).lambda.x() / tsf;
  const double hypodermis = 5.0 * expected(false).lambda.x() / tsf;
  for (const Index node : sheet.mesh.nodes("outer")) {
    EXPECT_NEAR(state.u[at(node)].x(), 6.5 - skin - hypodermis, 1e-8);
    EXPECT_LE(std::hypot(state.u[at(node)].y(), state.u[at(node)].z()), 1e-8);
  }
}

TEST_P(PreStretchedSheet, PutsMoreTensionAlongTheSkinLineThanAcross) {
  const Vec3 sigma = expected(true).sigma;
  EXPECT_GT(sigma.z(), 1.5 * sigma.y()) << "the independent solution itself";
  EXPECT_NEAR(sigma.x(), 0.0, 1e-12);
}

std::string name_of(mesh::SheetCells cells) {
  if (cells == mesh::SheetCells::hexahedra) return "hexahedra";
  return cells == mesh::SheetCells::wedges ? "wedges" : "checkerboard";
}

INSTANTIATE_TEST_SUITE_P(Cells, PreStretchedSheet,
                         ::testing::Values(mesh::SheetCells::hexahedra, mesh::SheetCells::wedges,
                                           mesh::SheetCells::checkerboard),
                         [](const auto& which) { return name_of(which.param); });

}  // namespace
}  // namespace facies::solve
