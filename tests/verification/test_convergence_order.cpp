// SPDX-License-Identifier: Apache-2.0
// A manufactured solution at finite strain: choose the displacement, find the body force that it needs, and watch the error
// fall with the size of the elements as linear elements should: h^2 in displacement, h in its gradient.
#include <cmath>
#include <numbers>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/kinematics.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::State;
using support::BlockCells;

constexpr double pi = std::numbers::pi;

/// The displacement that is to come out, on the unit cube [mm], and its gradient by X.
Vec3 exact_displacement(const Vec3& X) {
  return {0.10 * std::sin(pi * X.y()) * X.z(), 0.08 * std::sin(pi * X.z()) * X.x(),
          0.06 * std::cos(pi * X.x()) * X.y()};
}

Mat3 exact_gradient(const Vec3& X) {
  Mat3 du_dX;
  du_dX << 0.0, 0.10 * pi * std::cos(pi * X.y()) * X.z(), 0.10 * std::sin(pi * X.y()),
      0.08 * std::sin(pi * X.z()), 0.0, 0.08 * pi * std::cos(pi * X.z()) * X.x(),
      -0.06 * pi * std::sin(pi * X.x()) * X.y(), 0.06 * std::cos(pi * X.x()), 0.0;
  return du_dX;
}

struct Tissue {
  support::LawPointer law =
      support::example_law("fung_orthotropic", support::Random(31).rotation());
  support::VolumetricPointer volumetric = support::log_volume(100.0);

  /// First Piola-Kirchhoff stress of the exact solution at X, from the laws alone [kPa].
  [[nodiscard]] Mat3 P(const Vec3& X) const {
    const Mat3 F = Mat3::Identity() + exact_gradient(X);
    const Sym3<double> C = right_cauchy_green(F);
    const StressVoigt S = material::distortional_stress(*law, {}, C) +
                          material::volumetric_response(*volumetric, C).S;
    return F * to_matrix(from_stress_voigt(S));
  }

  /// -Div P: the force per volume that keeps the exact solution in balance [mN/mm^3]. Central differences of fourth order,
  /// whose error (1e-10) is far below that of the elements.
  [[nodiscard]] Vec3 body_force(const Vec3& X) const {
    const double h = 1e-3;
    Vec3 divergence = Vec3::Zero();
    for (int j = 0; j < 3; ++j) {
      const Vec3 dX = h * Vec3::Unit(j);
      const Mat3 dP_dX =
          (8.0 * (P(X + dX) - P(X - dX)) - (P(X + 2 * dX) - P(X - 2 * dX))) / (12 * h);
      divergence += dP_dX.col(j);
    }
    return -divergence;
  }
};

/// Calls visit(element, point, X, dV) at every quadrature point.
template <class Visit>
void for_each_point(const mesh::Mesh& mesh, const Visit& visit) {
  for (const mesh::Element& element : mesh.elements()) {
    for (const mesh::QuadraturePoint& point : mesh::quadrature(element.type)) {
      Vec3 X = Vec3::Zero();
      for (std::size_t a = 0; a < element.connectivity().size(); ++a)
        X += point.N(static_cast<Eigen::Index>(a)) * mesh.X()[at(element.nodes[a])];
      const Mat3 dX_dxi = mechanics::isoparametric_jacobian(mesh, element, point.dN_dxi);
      visit(element, point, X, dX_dxi, point.weight * dX_dxi.determinant());
    }
  }
}

/// A dead force per volume of the mesh configuration: a term that this test brings along.
class BodyForce final : public mechanics::Term {
 public:
  BodyForce(const mesh::Mesh& mesh, const Tissue& tissue) : force_(mesh.n_nodes(), Vec3::Zero()) {
    for_each_point(mesh, [&](const mesh::Element& element, const mesh::QuadraturePoint& point,
                             const Vec3& X, const Mat3&, double dV) {
      const Vec3 b = tissue.body_force(X);
      for (std::size_t a = 0; a < element.connectivity().size(); ++a)
        force_[at(element.nodes[a])] += point.N(static_cast<Eigen::Index>(a)) * dV * b;
    });
  }

  [[nodiscard]] std::string_view name() const override { return "body force"; }

  [[nodiscard]] double energy(const State& state, const mechanics::Controls&) const override {
    double work = 0.0;
    for (std::size_t node = 0; node < force_.size(); ++node)
      work += force_[node].dot(state.u[node]);
    return -work;
  }

  [[nodiscard]] bool add_residual(const State&, const mechanics::Controls&, std::span<double> r,
                                  mechanics::Inadmissible*) const override {
    for (std::size_t node = 0; node < force_.size(); ++node) {
      for (int axis = 0; axis < 3; ++axis)
        r[at(mechanics::dof(to_index(node), axis))] -= force_[node](axis);
    }
    return true;
  }

 private:
  std::vector<Vec3> force_;
};

struct Errors {
  double displacement = 0.0;  ///< L2 norm of u - u_exact
  double gradient = 0.0;      ///< L2 norm of du/dX - du_exact/dX
};

Errors measure(const mesh::Mesh& mesh, const State& state) {
  double displacement = 0.0;
  double gradient = 0.0;
  for_each_point(mesh, [&](const mesh::Element& element, const mesh::QuadraturePoint& point,
                           const Vec3& X, const Mat3& dX_dxi, double dV) {
    const Eigen::Matrix<double, 8, 3> dN_dX = point.dN_dxi * dX_dxi.inverse();
    Vec3 u = -exact_displacement(X);
    Mat3 du_dX = -exact_gradient(X);
    for (std::size_t a = 0; a < element.connectivity().size(); ++a) {
      const auto row = static_cast<Eigen::Index>(a);
      const Vec3& u_a = state.u[at(element.nodes[a])];
      u += point.N(row) * u_a;
      du_dX += u_a * dN_dX.row(row);
    }
    displacement += dV * u.squaredNorm();
    for (int j = 0; j < 3; ++j)
      gradient += dV * du_dX.col(j).squaredNorm();
  });
  return {std::sqrt(displacement), std::sqrt(gradient)};
}

/// The unit cube, its inside bent so that no element is a box.
mesh::Mesh curved_cube(BlockCells cells, int n) {
  return support::mapped(
      support::make_block({.n = {n, n, n}, .cells = cells}), [](const Vec3& X) -> Vec3 {
        const double bump =
            0.06 * std::sin(pi * X.x()) * std::sin(pi * X.y()) * std::sin(pi * X.z());
        return X + bump * Vec3(1.0, -0.7, 0.5);
      });
}

Errors solve_on(const mesh::Mesh& mesh) {
  const Tissue tissue;
  support::SolidModel model(mesh, support::uniform_solid(mesh, tissue.law, tissue.volumetric));
  model.model.add(std::make_unique<BodyForce>(model.mesh, tissue));
  support::Supports boundary;
  for (const Index node : mesh.nodes("boundary"))
    boundary.place(node, exact_displacement(mesh.X()[at(node)]));
  State state = model.model.initial_state();
  const NewtonReport report = solve_equilibrium(model.model, state, {}, boundary.prescribed(),
                                                {.relative_tolerance = 1e-9});
  EXPECT_TRUE(report.converged) << report.reason;
  return measure(mesh, state);
}

class ConvergenceOrder : public ::testing::TestWithParam<BlockCells> {};

TEST_P(ConvergenceOrder, IsThatOfLinearElements) {
  Errors coarse = solve_on(curved_cube(GetParam(), 3));
  for (const int n : {6, 12}) {
    const Errors fine = solve_on(curved_cube(GetParam(), n));
    const double displacement = std::log2(coarse.displacement / fine.displacement);
    const double gradient = std::log2(coarse.gradient / fine.gradient);
    EXPECT_GE(displacement, n == 12 ? 1.9 : 1.7) << fine.displacement;
    EXPECT_GE(gradient, 0.9) << fine.gradient;
    RecordProperty("displacement_order_" + std::to_string(n), std::to_string(displacement));
    RecordProperty("gradient_order_" + std::to_string(n), std::to_string(gradient));
    coarse = fine;
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, ConvergenceOrder,
                         ::testing::Values(BlockCells::hexahedra, BlockCells::wedges,
                                           BlockCells::mixed),
                         [](const auto& which) { return support::name_of(which.param); });

}  // namespace
}  // namespace facies::solve
