// SPDX-License-Identifier: Apache-2.0
// A rigid sphere pressed into an elastic half-space, against Hertz (Johnson, Contact Mechanics, 1985, section 4.2).
//
// A quarter of the half-space is cut out, eight contact radii long; on the cut its displacements are those of a point force
// on a half-space (Boussinesq), which is what Hertz's pressure looks like from there. The barrier keeps the surfaces apart
// by d_hat where they are just felt and by less under pressure; the approach is counted from the former.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/blocks.hpp"
#include "support/contact.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::Anchor;

constexpr double mu = 1.0;  // [kPa]
constexpr double nu = 0.3;
constexpr double kappa = 2.0 * mu * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
constexpr double plane_modulus = 2.0 * mu / (1.0 - nu);  // E / (1 - nu^2)

constexpr double radius = 100.0;   // of the sphere [mm]
constexpr double approach = 0.01;  // so that the circle of contact has a radius of 1 mm

constexpr double peak_pressure = 2.0 * plane_modulus / (std::numbers::pi * radius);
constexpr double d_hat = 0.05 * approach;
/// So stiff that the peak pressure brings the surfaces nearer by a thirtieth of d_hat only.
constexpr mechanics::ContactSettings settings{
    .d_hat = d_hat, .stiffness = 320.0 * peak_pressure / d_hat, .reach = 4.0 * d_hat};

/// Hertz's force [mN] at an approach [mm].
double hertz_force(double delta) {
  return 4.0 / 3.0 * plane_modulus * std::sqrt(radius) * std::pow(delta, 1.5);
}

/// Hertz's pressure [kPa] at a distance from the axis [mm], for a circle of contact of 1 mm.
double hertz_pressure(double r) {
  return peak_pressure * std::sqrt(std::max(0.0, 1.0 - r * r));
}

/// Displacement [mm] at x (z <= 0) by a force [mN] downwards at the origin of the half-space: Johnson, Eqs. 3.18, with z
/// turned around.
Vec3 boussinesq(const Vec3& x, double force) {
  const double depth = -x.z();
  const double rho = x.norm();
  const double factor = force / (4.0 * std::numbers::pi * mu);
  const double outwards =
      factor * (depth / std::pow(rho, 3) - (1.0 - 2.0 * nu) / (rho * (rho + depth)));
  const double downwards = factor * (depth * depth / std::pow(rho, 3) + 2.0 * (1.0 - nu) / rho);
  return {outwards * x.x(), outwards * x.y(), -downwards};
}

/// A mesh of the quarter x, y >= 0, z <= 0.
struct Grid {
  int n = 12;  ///< cells along each axis to 8 mm times `scale`; they grow away from the origin
  double scale = 1.0;  ///< of all cells: moves nodes over the edge of the circle of contact
  int cells = n;       ///< along each axis; more than n reach farther, the first n stay as they are

  [[nodiscard]] mesh::Mesh mesh() const {
    const auto graded = [&](double s) {
      constexpr double grading = 3.0;
      return 8.0 * scale * std::sinh(grading * s * cells / n) / std::sinh(grading);
    };
    return support::mapped(support::make_block({.n = {cells, cells, cells}}), [&](const Vec3& s) {
      return Vec3(graded(s.x()), graded(s.y()), -graded(1.0 - s.z()));
    });
  }
};

/// The lower end of a sphere that touches the plane z = `height` in the origin, in triangles of 1/20 mm: no point of it is
/// farther than 1/1600 of the approach inside the true sphere.
mechanics::ContactSurface sphere(double height) {
  mechanics::ContactSurface surface{"sphere", {}, {}};
  constexpr double begin = -0.225;  // beyond the planes of symmetry, and not on nodes
  constexpr double width = 0.05;
  constexpr Index n = 40;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      const double x = begin + width * i;
      const double y = begin + width * j;
      const double z = height + radius - std::sqrt(radius * radius - x * x - y * y);
      surface.vertices.push_back(Anchor::in_space({x, y, z}));
      if (i == n || j == n) continue;
      const Index a = i * (n + 1) + j;
      surface.triangles.push_back({a, a + n + 1, a + n + 2});
      surface.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  return surface;
}

struct Pressed {
  double force = 0.0;   ///< on the whole sphere [mN]
  double radius = 0.0;  ///< of the circle of contact, from the second moment of the pressure [mm]
  double pressure_error = 0.0;  ///< integral of |p - Hertz's| over Hertz's force
  double overlap = 0.0;         ///< how much nearer than d_hat the surfaces come [mm]
  double farthest_felt = 0.0;   ///< distance of a point from the axis [mm]
  double nearest_unfelt = 1e9;
};

Pressed press(const Grid& grid) {
  const mesh::Mesh mesh = grid.mesh();
  support::SolidModel tissue(mesh, support::uniform_solid(mesh, support::neo_hookean(0.5 * mu),
                                                          support::log_volume(kappa)));
  const std::vector<mesh::Face> top = support::faces_between(mesh, mesh.nodes("z_max"));
  const std::vector<mechanics::ContactPoint> points = support::contact_points(mesh, top);
  const auto& contact = tissue.model.add(
      std::make_unique<mechanics::Contact>(tissue.model, points, sphere(d_hat), settings));

  support::Supports supports;
  for (const char* side : {"x_max", "y_max", "z_min"}) {
    for (const Index node : mesh.nodes(side)) {
      supports.place(node,
                     Vec3(0, 0, approach) + boussinesq(mesh.X()[at(node)], hertz_force(approach)));
    }
  }
  supports.hold(mesh.nodes("x_min"), 0).hold(mesh.nodes("y_min"), 1);
  mechanics::State state = tissue.model.initial_state();
  const NewtonReport report = solve_equilibrium(tissue.model, state, {}, supports.prescribed(),
                                                {.relative_tolerance = 1e-7});
  EXPECT_TRUE(report.converged) << report.reason;

  Pressed pressed;
  pressed.overlap = d_hat - contact.report(state).smallest_distance;
  std::vector<double> r(tissue.model.n_dofs());
  EXPECT_TRUE(contact.add_residual(state, {}, r, nullptr));
  double second_moment = 0.0;
  for (const mechanics::ContactPoint& point : points) {
    const double force = r[at(mechanics::dof(point.anchor.index, 2))];
    const double from_axis = point.anchor.X.head<2>().norm();
    pressed.force += 4.0 * force;
    second_moment += 4.0 * force * from_axis * from_axis;
    pressed.pressure_error +=
        4.0 * std::abs(force - point.area * hertz_pressure(from_axis)) / hertz_force(approach);
    if (force > 0.0) {
      pressed.farthest_felt = std::max(pressed.farthest_felt, from_axis);
    } else {
      pressed.nearest_unfelt = std::min(pressed.nearest_unfelt, from_axis);
    }
  }
  pressed.radius = std::sqrt(2.5 * second_moment / pressed.force);
  return pressed;
}

/// Root mean squares over meshes whose nodes lie differently about the edge of the circle of contact, so that no lucky
/// one counts.
struct Errors {
  double force = 0.0;     ///< over Hertz's
  double radius = 0.0;    ///< of the circle of contact, over Hertz's
  double pressure = 0.0;  ///< Pressed::pressure_error
};

Errors errors_of(int n) {
  Errors mean_square;
  for (const double scale : {0.88, 0.96, 1.04, 1.12}) {
    const Pressed pressed = press({.n = n, .scale = scale});
    // The barrier as a layer that yields by 0 to `overlap`: the force is between Hertz's at approaches less by these.
    EXPECT_LT(pressed.overlap, 0.0017 * approach);
    const double force = hertz_force(approach - 0.5 * pressed.overlap);
    mean_square.force += std::pow(pressed.force / force - 1.0, 2) / 4.0;
    mean_square.radius += std::pow(pressed.radius - 1.0, 2) / 4.0;
    mean_square.pressure += std::pow(pressed.pressure_error, 2) / 4.0;
  }
  return {std::sqrt(mean_square.force), std::sqrt(mean_square.radius),
          std::sqrt(mean_square.pressure)};
}

TEST(SphereOnAHalfSpace, IsPressedBackWithHertzsForceAndPressureAsTheMeshIsRefined) {
  const Errors coarse = errors_of(6);
  const Errors fine = errors_of(12);
  EXPECT_LT(fine.force, 0.01);
  EXPECT_LT(fine.force, 0.5 * coarse.force);
  EXPECT_LT(fine.radius, 0.015);
  EXPECT_LT(fine.radius, 0.5 * coarse.radius);
  EXPECT_LT(fine.pressure, 0.12) << "most of it in the nodes about the edge of the circle";
  EXPECT_LT(fine.pressure, 0.5 * coarse.pressure);
}

TEST(SphereOnAHalfSpace, IsFeltInsideHertzsCircleAndNotOutside) {
  const Pressed pressed = press({.n = 12});
  constexpr double part_of_a_cell = 0.2;  // cells are 0.3 mm wide there
  EXPECT_NEAR(pressed.farthest_felt, 1.0, part_of_a_cell);
  EXPECT_NEAR(pressed.nearest_unfelt, 1.0, part_of_a_cell);
}

TEST(SphereOnAHalfSpace, DoesNotFeelWhereTheHalfSpaceIsCut) {
  // The same cells about the sphere, with the cut at 8 and at 16 mm.
  const double near = press({.n = 9}).force;
  const double far = press({.n = 9, .cells = 11}).force;
  EXPECT_NEAR(far / near, 1.0, 0.003);
}

}  // namespace
}  // namespace facies::solve
