// SPDX-License-Identifier: Apache-2.0
// Sheets pulled in one or two directions against an independent solution: the stress along each axis written down from
// the printed equations, the free stretches found by bisection on the stress that must vanish.
#include "support/bisection.hpp"
#include "support/blocks.hpp"
#include "support/closed_forms.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::State;
using support::BlockCells;
using support::PrincipalResponse;
using support::SolidModel;

constexpr double kappa = 50.0;

/// A tissue whose axes are those of space, once as the library has it and once from the printed equations.
struct Sample {
  std::string name;
  std::function<mechanics::SolidDescription(const mesh::Mesh&)> describe;
  PrincipalResponse response;
  double activation = 0.0;
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
  return out << sample.name;
}

/// Fung skin with a1, a2, a3 along these coordinate axes.
Sample fung(const std::string& name, const std::array<int, 3>& axis) {
  const material::Parameters parameters = material::find_law("fung_orthotropic")->example;
  Mat3 axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = Vec3::Unit(axis[static_cast<std::size_t>(k)]);
  return {name,
          [axes](const mesh::Mesh& mesh) {
            return support::uniform_solid(mesh, support::example_law("fung_orthotropic", axes),
                                          support::log_volume(kappa));
          },
          support::principal_fung(parameters, axis)};
}

mechanics::SolidDescription mooney_rivlin_solid(const mesh::Mesh& mesh) {
  return support::uniform_solid(mesh, support::example_law("mooney_rivlin"),
                                support::log_volume(kappa));
}

/// Nominal stress of the example fibre (Flynn et al. 2015, Eqs. 6-7) with P1 in kPa [kPa].
double fibre_stress(double lambda_bar, double activation) {
  const double P1 = 0.05;
  const double P2 = 6.6;
  const double star = 1.4;
  double passive = 0.0;
  if (lambda_bar > star) {
    const double P3 = P1 * P2 * std::exp(P2 * (star - 1.0));
    passive = P1 * (std::exp(P2 * (star - 1.0)) - 1.0) + P3 * (lambda_bar - star);
  } else if (lambda_bar > 1.0) {
    passive = P1 * (std::exp(P2 * (lambda_bar - 1.0)) - 1.0);
  }
  return passive + 100.0 * activation;
}

Sample muscle(const std::string& name, int axis, double activation) {
  return {name,
          [axis](const mesh::Mesh& mesh) {
            mechanics::SolidDescription description = mooney_rivlin_solid(mesh);
            description.fibres.push_back(
                support::uniform_fibres(mesh, support::example_fibre("kPa"), 0, Vec3::Unit(axis)));
            return description;
          },
          support::with_fibres(
              support::principal_mooney_rivlin(0.4, 0.15, 1.4), axis,
              [activation](double lambda_bar) { return fibre_stress(lambda_bar, activation); }),
          activation};
}

std::vector<Sample> all_samples() {
  return {fung("fung_along_x", {0, 2, 1}),
          fung("fung_along_y", {1, 2, 0}),
          fung("fung_along_z", {2, 0, 1}),
          {"mooney_rivlin", mooney_rivlin_solid, support::principal_mooney_rivlin(0.4, 0.15, 1.4)},
          muscle("passive_muscle_along_x", 0, 0.0),
          muscle("active_muscle_along_x", 0, 0.01),
          muscle("active_muscle_across_y", 1, 0.02)};
}

/// The third stretch for which the stress along `axis` vanishes.
double free_stretch(const Sample& sample, Vec3 lambda, int axis) {
  return support::bisect(
      [&](double stretch) {
        lambda(axis) = stretch;
        return support::principal_cauchy(sample.response, kappa, lambda)(axis);
      },
      0.4, 1.6);
}

/// Stretches of a sheet pulled to lambda_x, free along y and z: the stretch along z for every one along y, then that.
Vec3 uniaxial(const Sample& sample, double lambda_x) {
  const auto with_free_z = [&](double lambda_y) {
    const Vec3 lambda(lambda_x, lambda_y, 1.0);
    return Vec3(lambda_x, lambda_y, free_stretch(sample, lambda, 2));
  };
  const double lambda_y = support::bisect(
      [&](double stretch) {
        return support::principal_cauchy(sample.response, kappa, with_free_z(stretch)).y();
      },
      0.6, 1.4);
  return with_free_z(lambda_y);
}

class Sheet : public ::testing::TestWithParam<std::tuple<Sample, BlockCells>> {
 protected:
  [[nodiscard]] static const Sample& sample() { return std::get<0>(GetParam()); }

  static SolidModel make() {
    const mesh::Mesh mesh = support::make_block(
        {.size = size_, .n = {4, 3, 2}, .cells = std::get<1>(GetParam()), .shake = 0.2});
    return {mesh, sample().describe(mesh)};
  }

  /// Rollers on the three sides through the origin, and on the far sides of the axes that are pulled.
  [[nodiscard]] mechanics::Prescribed rollers(
      std::initializer_list<std::pair<int, double>> pulled) const {
    support::Supports supports;
    supports.hold(sheet_.mesh.nodes("x_min"), 0);
    supports.hold(sheet_.mesh.nodes("y_min"), 1);
    supports.hold(sheet_.mesh.nodes("z_min"), 2);
    const std::array<const char*, 3> far = {"x_max", "y_max", "z_max"};
    for (const auto& [axis, stretch] : pulled) {
      supports.hold(sheet_.mesh.nodes(far[static_cast<std::size_t>(axis)]), axis,
                    (stretch - 1.0) * size_(axis));
    }
    return supports.prescribed();
  }

  void expect_stretches(const mechanics::Prescribed& supports, const Vec3& lambda) {
    const mechanics::Controls controls = support::activated({sample().activation});
    State state = sheet_.model.initial_state();
    const NewtonReport report = solve_equilibrium(
        sheet_.model, state, controls, supports,
        {.relative_tolerance = 1e-13, .absolute_tolerance = 1e-11, .max_iterations = 100});
    ASSERT_TRUE(report.converged) << report.reason;
    for (std::size_t node = 0; node < state.u.size(); ++node) {
      const Vec3 X = sheet_.mesh.X()[node];
      const Vec3 error = X + state.u[node] - lambda.cwiseProduct(X);
      EXPECT_LE(error.norm(), 1e-8) << "node " << node;
    }
    const Vec3 sigma = support::principal_cauchy(sample().response, kappa, lambda);
    for (const mechanics::ElementMeans& means : sheet_.solid->means(state, controls)) {
      const Vec3 found(means.sigma.xx, means.sigma.yy, means.sigma.zz);
      EXPECT_LE((found - sigma).norm(), 1e-8 * (1.0 + sigma.norm()));
      EXPECT_LE(std::abs(means.sigma.xy) + std::abs(means.sigma.yz) + std::abs(means.sigma.xz),
                1e-8);
    }
  }

  inline static const Vec3 size_{4, 3, 1};
  SolidModel sheet_ = make();
};

TEST_P(Sheet, PulledInOneDirectionFollowsTheOneDimensionalSolution) {
  for (const double stretch : {1.25, 0.85})
    expect_stretches(rollers({{0, stretch}}), uniaxial(sample(), stretch));
}

TEST_P(Sheet, PulledInTwoDirectionsFollowsTheOneDimensionalSolution) {
  for (const double stretch : {1.1, 1.25}) {
    const double thickness = free_stretch(sample(), {stretch, stretch, 1.0}, 2);
    expect_stretches(rollers({{0, stretch}, {1, stretch}}), {stretch, stretch, thickness});
  }
}

TEST_P(Sheet, PulledInOneDirectionAndHeldInTheOtherFollowsTheOneDimensionalSolution) {
  const double stretch = 1.2;
  const double thickness = free_stretch(sample(), {stretch, 1.0, 1.0}, 2);
  expect_stretches(rollers({{0, stretch}, {1, 1.0}}), {stretch, 1.0, thickness});
}

INSTANTIATE_TEST_SUITE_P(Tissues, Sheet,
                         ::testing::Combine(::testing::ValuesIn(all_samples()),
                                            ::testing::Values(BlockCells::hexahedra,
                                                              BlockCells::mixed)),
                         [](const auto& which) {
                           return std::get<0>(which.param).name + "_" +
                                  support::name_of(std::get<1>(which.param));
                         });

}  // namespace
}  // namespace facies::solve
