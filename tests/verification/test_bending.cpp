// SPDX-License-Identifier: Apache-2.0
// Nearly incompressible tissue, which elements that are too stiff in volume cannot bend. A block is bent into an arc in plane
// strain; for incompressible neo-Hookean tissue the answer is known at any strain (Rivlin 1949; Ogden, Non-Linear Elastic
// Deformations, 1984, section 5.2.4).
#include <cmath>

#include "support/blocks.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/kinematics.hpp"
#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::State;
using support::BlockCells;

constexpr double mu = 1.0;     // [kPa]
constexpr double kappa = 2e3;  // [kPa]
constexpr double height = 0.5;
constexpr double length = 2.0;
constexpr double width = 0.25;

/// The exact solution: X across, Y along the block; r^2 = 2 X / C + a^2, theta = C Y, z = Z. Volumes do not change, the
/// ends turn by +-0.6 rad, the arc's inner and outer side are free.
struct Arc {
  double C = 0.3 / length;
  double a = std::sqrt(std::hypot(height / C, 1.0 / (C * C)) - height / C);
  double b = std::sqrt(a * a + 2.0 * height / C);
  double K = -0.5 * mu * (C * C * a * a + 1.0 / (C * C * a * a));

  [[nodiscard]] double r(double X) const { return std::sqrt(2.0 * X / C + a * a); }

  [[nodiscard]] Vec3 position(const Vec3& X) const {
    const double theta = C * (X.y() - 0.5 * length);
    return {r(X.x()) * std::cos(theta), r(X.x()) * std::sin(theta), X.z()};
  }

  /// Mean stress at radius r [kPa]: sigma_rr plus a third of what the others exceed it by.
  [[nodiscard]] double pressure(double radius) const {
    const double s = C * C * radius * radius;  // square of the stretch along the arc
    const double sigma_rr = 0.5 * mu * (s + 1.0 / s) + K;
    return sigma_rr + mu * ((s - 1.0 / s) + (1.0 - 1.0 / s)) / 3.0;
  }

  /// Bending moment: the integral of sigma_theta r over an end [mN mm].
  [[nodiscard]] double moment() const {
    const double quartic = std::pow(b, 4) - std::pow(a, 4);
    return width * (mu * (0.375 * C * C * quartic - 0.5 * std::log(b / a) / (C * C)) +
                    0.5 * K * (b * b - a * a));
  }
};

/// What elements without mean dilatation do: the volumetric energy at every quadrature point of its own. It is the textbook's
/// full quadrature, and locks.
class PointwiseVolume final : public mechanics::Term {
 public:
  PointwiseVolume(const mesh::Mesh& mesh, support::VolumetricPointer law)
      : mesh_(mesh), law_(std::move(law)) {}

  [[nodiscard]] std::string_view name() const override { return "pointwise volume"; }

  [[nodiscard]] double energy(const State& state, const mechanics::Controls&) const override {
    double W = 0.0;
    for_each_point(state, [&](Index, const auto&, const Mat3& F, double dV) {
      W += dV * law_->respond(F.determinant()).U;
    });
    return W;
  }

  [[nodiscard]] bool add_residual(const State& state, const mechanics::Controls&,
                                  std::span<double> r, mechanics::Inadmissible*) const override {
    bool admissible = true;
    for_each_point(state, [&](Index e, const auto& G, const Mat3& F, double dV) {
      const double J = F.determinant();
      admissible = admissible && J > 0.0;
      const Mat3 P = law_->respond(J).dU_dJ * J * F.inverse().transpose();
      const std::span<const Index> nodes = mesh_.element(e).connectivity();
      for (std::size_t node = 0; node < nodes.size(); ++node) {
        const Vec3 force = dV * P * G.row(static_cast<Eigen::Index>(node)).transpose();
        for (int axis = 0; axis < 3; ++axis)
          r[at(mechanics::dof(nodes[node], axis))] += force(axis);
      }
    });
    return admissible;
  }

  void list_stencils(const mechanics::State& /*state*/,
                     mechanics::Stencils& stencils) const override {
    for (const mesh::Element& element : mesh_.elements()) {
      std::vector<Index> dofs;
      for (const Index node : element.connectivity()) {
        for (int axis = 0; axis < 3; ++axis)
          dofs.push_back(mechanics::dof(node, axis));
      }
      stencils.push_back(dofs);
    }
  }

  void add_tangent(const State& state, const mechanics::Controls&,
                   mechanics::TangentSink& K) const override {
    // With c_ai = (F^-T G_a)_i: dJ/dx_ai = J c_ai and d2J/dx_ai dx_bj = J (c_ai c_bj - c_aj c_bi).
    for_each_point(state, [&](Index e, const auto& G, const Mat3& F, double dV) {
      const double J = F.determinant();
      const material::VolumetricResponse U = law_->respond(J);
      const Eigen::Index n = 3 * to_index(mesh_.element(e).connectivity().size());
      const Eigen::Matrix<double, 3, 8> c = F.inverse().transpose().lazyProduct(G.transpose());
      Eigen::MatrixXd block(n, n);
      for (Eigen::Index p = 0; p < n; ++p) {
        for (Eigen::Index q = 0; q < n; ++q) {
          const double both = c(p % 3, p / 3) * c(q % 3, q / 3);
          const double crossed = c(q % 3, p / 3) * c(p % 3, q / 3);
          block(p, q) = dV * J * (U.d2U_dJ2 * J * both + U.dU_dJ * (both - crossed));
        }
      }
      K.add(at(e), {block.data(), static_cast<std::size_t>(block.size())});
    });
  }

 private:
  template <class Visit>
  void for_each_point(const State& state, const Visit& visit) const {
    for (Index e = 0; e < to_index(mesh_.n_elements()); ++e) {
      const mesh::Element& element = mesh_.element(e);
      for (const mesh::QuadraturePoint& q : mesh::quadrature(element.type)) {
        const Mat3 dX_dxi = mechanics::isoparametric_jacobian(mesh_, element, q.dN_dxi);
        const mesh::ShapeGradients G = q.dN_dxi * dX_dxi.inverse();
        Mat3 F = Mat3::Identity();
        for (std::size_t a = 0; a < element.connectivity().size(); ++a)
          F += state.u[at(element.nodes[a])] * G.row(static_cast<Eigen::Index>(a));
        visit(e, G, F, q.weight * dX_dxi.determinant());
      }
    }
  }

  const mesh::Mesh& mesh_;
  support::VolumetricPointer law_;
};

/// What came out of a block with n elements across.
struct Bent {
  double moment = 0.0;
  double position_error = 0.0;   ///< largest distance of a node from its exact place [mm]
  std::vector<double> pressure;  ///< mean stress of each element [kPa]
  std::vector<double> exact_pressure;
};

enum class Volume : std::uint8_t { mean, pointwise };

Bent bend(BlockCells cells, int n, Volume volume = Volume::mean) {
  const Arc arc;
  // Built lying down, so that the triangles of wedges lie in the block's plane as they do in skin.
  const mesh::Mesh mesh = support::mapped(
      support::make_block({.size = {length, width, height}, .n = {4 * n, 1, n}, .cells = cells}),
      [](const Vec3& X) { return Vec3(X.z(), X.x(), X.y()); });
  const support::VolumetricPointer stiff = support::log_volume(kappa);
  support::SolidModel block(
      mesh, support::uniform_solid(mesh, support::neo_hookean(0.5 * mu),
                                   volume == Volume::mean ? stiff : support::log_volume(1e-9)));
  if (volume == Volume::pointwise)
    block.model.add(std::make_unique<PointwiseVolume>(block.mesh, stiff));

  support::Supports supports;
  supports.hold(mesh.nodes("y_min"), 2).hold(mesh.nodes("y_max"), 2);  // sides of the width
  for (const char* end : {"x_min", "x_max"}) {
    for (const Index node : mesh.nodes(end))
      supports.place(node, arc.position(mesh.X()[at(node)]) - mesh.X()[at(node)]);
  }
  State state = block.model.initial_state();
  for (std::size_t node = 0; node < state.u.size(); ++node)
    state.u[node] = arc.position(mesh.X()[node]) - mesh.X()[node];
  const mechanics::Prescribed ends = supports.prescribed();
  const NewtonReport report =
      solve_equilibrium(block.model, state, {}, ends, {.relative_tolerance = 1e-8});
  EXPECT_TRUE(report.converged) << report.reason;

  Bent bent;
  std::vector<double> r(block.model.n_dofs());
  EXPECT_TRUE(block.model.residual(state, {}, r));
  for (const Index node : mesh.nodes("x_max")) {
    const Vec3 x = mesh.X()[at(node)] + state.u[at(node)];
    bent.moment += x.x() * r[at(mechanics::dof(node, 1))] - x.y() * r[at(mechanics::dof(node, 0))];
  }
  for (std::size_t node = 0; node < state.u.size(); ++node) {
    const Vec3 X = mesh.X()[node];
    bent.position_error =
        std::max(bent.position_error, (X + state.u[node] - arc.position(X)).norm());
  }
  for (const mechanics::ElementMeans& means : block.solid->means(state, {}))
    bent.pressure.push_back(trace(means.sigma) / 3.0);
  for (Index e = 0; e < to_index(mesh.n_elements()); ++e)
    bent.exact_pressure.push_back(arc.pressure(arc.r(mesh.centroid(e).x())));
  return bent;
}

double moment_error(const Bent& bent) {
  return bent.moment / Arc().moment() - 1.0;
}

TEST(NearlyIncompressibleBending, ConvergesToTheExactMomentAtSecondOrder) {
  const Bent coarse = bend(BlockCells::hexahedra, 2);
  const Bent middle = bend(BlockCells::hexahedra, 4);
  const Bent fine = bend(BlockCells::hexahedra, 8);
  printf("PROBE %g %g %g  pos %g %g %g\n", moment_error(coarse), moment_error(middle),
         moment_error(fine), coarse.position_error, middle.position_error, fine.position_error);
  const Bent wc = bend(BlockCells::wedges, 2);
  const Bent wm = bend(BlockCells::wedges, 4);
  const Bent wf = bend(BlockCells::wedges, 8);
  printf("PROBE wedge %g %g %g\n", moment_error(wc), moment_error(wm), moment_error(wf));
  const Bent pc = bend(BlockCells::hexahedra, 2, Volume::pointwise);
  const Bent pm = bend(BlockCells::hexahedra, 4, Volume::pointwise);
  const Bent pf = bend(BlockCells::hexahedra, 8, Volume::pointwise);
  printf("PROBE pointwise %g %g %g\n", moment_error(pc), moment_error(pm), moment_error(pf));
  double err = 0, mx = 0;
  for (size_t e = 0; e < fine.pressure.size(); ++e) {
    err = std::max(err, std::abs(fine.pressure[e] - fine.exact_pressure[e]));
    mx = std::max(mx, std::abs(fine.exact_pressure[e]));
  }
  printf("PROBE pressure err %g max %g\n", err, mx);
}

}  // namespace
}  // namespace facies::solve
