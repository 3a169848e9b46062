// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/mesh/even_shell.hpp"

namespace facies::mesh {
namespace {

using support::Random;

constexpr Index n = 4;  // squares a side

QuadNet grid() {
  QuadNet net{(n + 1) * (n + 1), {}};
  const auto number = [](Index i, Index j) { return i * (n + 1) + j; };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j)
      net.quads.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
  }
  return net;
}

/// Squares of 2 mm at this height.
std::vector<Vec3> plane(double z) {
  std::vector<Vec3> points;
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j)
      points.emplace_back(2.0 * i, 2.0 * j, z);
  }
  return points;
}

/// A sheet of two layers whose inner surface its control points make.
struct Sheet {
  LimitMesh fine = limit_mesh(grid(), 1);
  Shell shell;

  Sheet() {
    shell.net = fine.net;
    shell.outer = weighted(fine.limit, plane(0.0));
    for (const double part : {0.0, 0.4, 1.0})
      shell.parts.emplace_back(shell.outer.size(), part);
  }
  [[nodiscard]] std::vector<Vec3> even(const std::vector<Vec3>& control,
                                       const EvenShellOptions& options = {}) const {
    return even_inner_surface(shell, fine.limit, control, options);
  }
  [[nodiscard]] double worst(const std::vector<Vec3>& control) const {
    Shell with = shell;
    with.inner = weighted(fine.limit, control);
    return worst_corner(with).scaled_jacobian;
  }
};

TEST(EvenShell, LeavesWellShapedElementsAlone) {
  const Sheet sheet;
  const std::vector<Vec3> control = plane(-2.0);
  const std::vector<Vec3> evened = sheet.even(control);
  for (std::size_t i = 0; i < control.size(); ++i)
    EXPECT_LT((evened[i] - control[i]).norm(), 1e-9);
}

TEST(EvenShell, TurnsElementsThatBeginInsideOut) {
  const Sheet sheet;
  std::vector<Vec3> control = plane(-2.0);
  control[12] += Vec3(9.0, 8.0, 0.0);  // past its neighbours
  ASSERT_LT(sheet.worst(control), 0.0);
  EvenShellOptions options;
  options.wanted = 0.4;
  EXPECT_GT(sheet.worst(sheet.even(control, options)), 0.3);
}

TEST(EvenShell, MovesLessTheMoreItCosts) {
  const Sheet sheet;
  std::vector<Vec3> control = plane(-2.0);
  control[12] += Vec3(6.0, 5.0, 0.0);
  const auto way = [&](double stiffness) {
    EvenShellOptions options;
    options.stiffness = stiffness;
    const std::vector<Vec3> evened = sheet.even(control, options);
    double sum = 0.0;
    for (std::size_t i = 0; i < control.size(); ++i)
      sum += (evened[i] - control[i]).squaredNorm();
    return std::sqrt(sum);
  };
  EXPECT_GT(way(1e-3), way(1e-1));
  EXPECT_GT(way(1e-1), way(1e1));
  EXPECT_LT(way(1e4), 1e-2);
}

// Where all corners are right already, the way w of the distance d to a plane costs k w^2 + h (d - w)^2: least at
// w = d h / (h + k).
TEST(EvenShell, GoesToTheRightSideOfAPlaneAsFarAsItsHardnessSays) {
  const Sheet sheet;
  EvenShellOptions options;
  options.stiffness = 0.5;
  options.hardness = 2.0;
  // All vertices are 1 mm below the plane z = -1, above which they should be.
  options.sides.assign(sheet.shell.outer.size(), {Vec3(0.0, 0.0, -1.0), Vec3::UnitZ()});
  const std::vector<Vec3> evened = sheet.even(plane(-2.0), options);
  for (const Vec3& x : weighted(sheet.fine.limit, evened))
    EXPECT_NEAR(x.z(), -2.0 + 2.0 / 2.5, 1e-3);
  for (HalfSpace& side : options.sides)
    side.normal = -side.normal;
  for (const Vec3& x : weighted(sheet.fine.limit, sheet.even(plane(-2.0), options)))
    EXPECT_NEAR(x.z(), -2.0, 1e-9) << "already on the right side";
}

TEST(EvenShell, GivesTheSameBitsTwice) {
  const Sheet sheet;
  Random random(4);
  std::vector<Vec3> control = plane(-2.0);
  for (Vec3& x : control)
    x += random.vector(-0.8, 0.8);
  EXPECT_EQ(sheet.even(control), sheet.even(control));
}

TEST(EvenShell, RefusesListsThatDoNotFit) {
  const Sheet sheet;
  std::vector<Vec3> control = plane(-2.0);
  EvenShellOptions options;
  options.sides.resize(3);
  EXPECT_THROW((void)sheet.even(control, options), BugError);
  control.pop_back();
  EXPECT_THROW((void)sheet.even(control), BugError);
  Sheet other;
  other.shell.parts[1].pop_back();
  EXPECT_THROW((void)other.even(plane(-2.0)), BugError);
}

}  // namespace
}  // namespace facies::mesh
