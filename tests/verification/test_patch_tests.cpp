// SPDX-License-Identifier: Apache-2.0
// Patch tests at finite strain: a distorted mesh reproduces a homogeneous deformation exactly, whether its boundary is
// placed or pulled (Irons; e.g. Hughes, The Finite Element Method, 2000, section 4.6).
#include <cmath>

#include "support/blocks.hpp"
#include "support/closed_forms.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include "support/slope.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/surface.hpp"
#include "facies/solve/newton.hpp"

namespace facies::solve {
namespace {

using mechanics::State;
using support::BlockCells;
using support::SolidModel;

constexpr double kappa = 50.0;
const NewtonSettings exact{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-12};

Mat3 homogeneous_deformation() {
  Mat3 A;
  A << 1.15, 0.20, -0.05, 0.10, 0.90, 0.15, -0.08, 0.05, 1.10;
  return A;
}

/// What the tests run on: cells, law and pre-stretch.
struct PatchCase {
  BlockCells cells = BlockCells::hexahedra;
  std::string law;
  bool stretched = false;
};

std::vector<PatchCase> all_cases() {
  std::vector<PatchCase> cases;
  for (const BlockCells cells : {BlockCells::hexahedra, BlockCells::wedges, BlockCells::mixed}) {
    for (const std::string law : {"mooney_rivlin", "fung_orthotropic"}) {
      for (const bool stretched : {false, true})
        cases.push_back({cells, law, stretched});
    }
  }
  return cases;
}

std::string name_of(const PatchCase& which) {
  return support::name_of(which.cells) + "_" + which.law + (which.stretched ? "_stretched" : "");
}

std::ostream& operator<<(std::ostream& out, const PatchCase& which) {
  return out << name_of(which);
}

class Patch : public ::testing::TestWithParam<PatchCase> {
 protected:
  static SolidModel make() {
    const mesh::Mesh mesh = support::make_block(
        {.size = {3, 2, 2}, .n = {4, 3, 3}, .cells = GetParam().cells, .shake = 0.25});
    mechanics::SolidDescription description = support::uniform_solid(
        mesh, support::example_law(GetParam().law, axes()), support::log_volume(kappa), F0());
    description.fibres.push_back(support::uniform_fibres(mesh, support::example_fibre("kPa"), 0,
                                                         Vec3(1, 2, -1).normalized()));
    return {mesh, std::move(description)};
  }

  static Mat3 axes() { return support::Random(21).rotation(); }

  /// Shears as well as stretches: nothing that only works for TSF I will do.
  static Mat3 F0() {
    Mat3 F0 = Mat3::Identity();
    if (GetParam().stretched) F0 << 1.10, 0.05, 0.00, 0.02, 1.08, -0.04, 0.00, 0.03, 1.12;
    return F0;
  }

  /// Largest distance of a node from A X [mm].
  [[nodiscard]] double error(const State& state) const {
    double largest = 0.0;
    for (std::size_t node = 0; node < state.u.size(); ++node) {
      const Vec3 X = patch_.mesh.X()[node];
      largest = std::max(largest, (X + state.u[node] - A_ * X).norm());
    }
    return largest;
  }

  /// The stress of the deformation A F0, from the law alone.
  [[nodiscard]] Mat3 expected_stress() const {
    const Mat3 F_e = A_ * F0();
    const support::LawPointer law = support::example_law(GetParam().law, axes());
    const support::FibrePointer fibre_law = support::example_fibre("kPa");
    const material::Fibre fibre{fibre_law.get(), (F0().inverse() * Vec3(1, 2, -1)).normalized(),
                                controls_.activation[0]};
    const material::Response response =
        material::distortional_response(*law, {&fibre, 1}, right_cauchy_green(F_e));
    const double J = F_e.determinant();
    return to_matrix(push_forward(F_e, from_stress_voigt(response.S))) +
           kappa * std::log(J) / J * Mat3::Identity();
  }

  void expect_homogeneous(const State& state) const {
    EXPECT_LE(error(state), 1e-9);
    const Mat3 expected = expected_stress();
    for (const mechanics::ElementMeans& means : patch_.solid->means(state, controls_)) {
      const Mat3 difference = to_matrix(means.sigma) - expected;
      EXPECT_LE(support::norm_of(difference), 1e-9 * support::norm_of(expected));
      EXPECT_NEAR(means.J, (A_ * F0()).determinant(), 1e-10);
    }
  }

  SolidModel patch_ = make();
  Mat3 A_ = homogeneous_deformation();
  mechanics::Controls controls_ = support::activated({0.3});
};

TEST_P(Patch, FollowsItsBoundary) {
  State state = patch_.model.initial_state();
  support::Supports boundary;
  for (const Index node : patch_.mesh.nodes("boundary")) {
    const Vec3 X = patch_.mesh.X()[at(node)];
    boundary.place(node, A_ * X - X);
  }
  const NewtonReport report =
      solve_equilibrium(patch_.model, state, controls_, boundary.prescribed(), exact);
  ASSERT_TRUE(report.converged) << report.reason;
  expect_homogeneous(state);
}

/// Forces of a dead traction P N on the faces of the boundary, by quadrature over the faces alone [mN].
std::vector<Vec3> boundary_forces(const mesh::Mesh& mesh, const Mat3& P) {
  std::vector<Vec3> force(mesh.n_nodes(), Vec3::Zero());
  for (const mesh::Face face : mesh::boundary_faces(mesh)) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    const auto X = [&](std::size_t i) { return mesh.X()[at(nodes[i % nodes.size()])]; };
    if (nodes.size() == 3) {
      const Vec3 area = 0.5 * (X(1) - X(0)).cross(X(2) - X(0));
      for (const Index node : nodes)
        force[at(node)] += P * area / 3.0;
      continue;
    }
    const double g = 1.0 / std::sqrt(3.0);
    for (const double r : {-g, g}) {
      for (const double s : {-g, g}) {
        const Vec3 dX_dr = 0.25 * ((1 - s) * (X(1) - X(0)) + (1 + s) * (X(2) - X(3)));
        const Vec3 dX_ds = 0.25 * ((1 - r) * (X(3) - X(0)) + (1 + r) * (X(2) - X(1)));
        const Vec3 traction = P * dX_dr.cross(dX_ds);
        force[at(nodes[0])] += 0.25 * (1 - r) * (1 - s) * traction;
        force[at(nodes[1])] += 0.25 * (1 + r) * (1 - s) * traction;
        force[at(nodes[2])] += 0.25 * (1 + r) * (1 + s) * traction;
        force[at(nodes[3])] += 0.25 * (1 - r) * (1 + s) * traction;
      }
    }
  }
  return force;
}

TEST_P(Patch, FollowsTheTractionsOnItsBoundary) {
  // Nothing is held but three corners, so that the body cannot move as a whole. It is in tension (the stiffer skin needs
  // more of it across): under dead loads that press it would turn over.
  const double across = GetParam().law == "mooney_rivlin" ? 0.84 : 0.92;
  Mat3 F_e;
  F_e << 1.12, 0.06, 0.00, 0.06, 1.08, 0.03, 0.00, 0.03, across;
  A_ = F_e * F0().inverse();
  controls_.activation = {0.0};
  const Mat3 P = A_.determinant() * expected_stress() * A_.inverse().transpose();
  controls_.nodal_force = boundary_forces(patch_.mesh, P);
  support::Supports corners;
  for (const Index node : patch_.mesh.nodes("boundary")) {
    const Vec3 X = patch_.mesh.X()[at(node)];
    const Vec3 u = A_ * X - X;
    if (X == Vec3(0, 0, 0)) corners.place(node, u);
    if (X == Vec3(3, 0, 0)) corners.hold({&node, 1}, 1, u.y()).hold({&node, 1}, 2, u.z());
    if (X == Vec3(0, 2, 0)) corners.hold({&node, 1}, 2, u.z());
  }
  ASSERT_EQ(corners.prescribed().dofs.size(), 6U);
  State state = patch_.model.initial_state();
  const NewtonReport report =
      solve_equilibrium(patch_.model, state, controls_, corners.prescribed(), exact);
  ASSERT_TRUE(report.converged) << report.reason;
  expect_homogeneous(state);
}

INSTANTIATE_TEST_SUITE_P(Blocks, Patch, ::testing::ValuesIn(all_cases()),
                         [](const auto& which) { return name_of(which.param); });

}  // namespace
}  // namespace facies::solve
