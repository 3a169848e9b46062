// SPDX-License-Identifier: Apache-2.0
// The contact patch test (Taylor and Papadopoulos 1991): two blocks whose meshes do not match, one pressed on the other.
//
// What points with areas can do and cannot: the force is exact, and so is a uniform pressure where node meets node. Where the
// meshes do not match, the nodes of the surface get what the points over their triangles hand on, which is not what a
// uniform pressure would give them. That error is local: it stays in the elements at the interface. Points on one side
// alone must be those of the finer mesh: between coarser ones the surface bulges (points of 2 cells across over a surface
// of 3 or 5: stresses that are wrong by 0.8 or 1.2 of the pressure).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "support/blocks.hpp"
#include "support/contact.hpp"
#include "support/models.hpp"
#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/solve/step.hpp"

namespace facies::solve {
namespace {

using mechanics::Contact;

constexpr mechanics::ContactSettings settings{.d_hat = 0.02, .stiffness = 500.0, .reach = 0.2};

/// Both blocks are 2 x 2 x 1 mm; the surfaces are apart, and feel each other, before they are pressed.
constexpr double area = 4.0;
constexpr double gap = 0.5 * settings.d_hat;
constexpr double pressure = 0.2;  // [kPa], on the block above

constexpr double C10 = 0.5;    // [kPa]
constexpr double kappa = 2.0;  // [kPa]

/// Cells of a block across its width, in both directions, and along its height.
struct Cells {
  int across = 2;
  int high = 2;
};

/// Which of the blocks has the points, the other having the surface.
enum class Points : std::uint8_t { above, below, both };

/// Two blocks in one mesh, with the node sets of both by their names and "above/" or "below/" before them.
mesh::Mesh two_blocks(const Cells& below, const Cells& above) {
  std::vector<Vec3> X;
  std::vector<mesh::Element> elements;
  std::map<std::string, std::vector<Index>> sets;
  const auto add = [&](const std::string& name, const Cells& cells, double height) {
    const mesh::Mesh block =
        support::make_block({.size = {2, 2, 1}, .n = {cells.across, cells.across, cells.high}});
    const Index first = to_index(X.size());
    for (const Vec3& place : block.X())
      X.emplace_back(place + Vec3(0, 0, height));
    for (mesh::Element element : block.elements()) {
      for (Index& node : element.nodes)
        node += first;
      elements.push_back(element);
    }
    for (auto [set, nodes] : block.node_sets()) {
      for (Index& node : nodes)
        node += first;
      sets[name + set] = std::move(nodes);
    }
  };
  add("below/", below, 0.0);
  add("above/", above, 1.0 + gap);
  mesh::Mesh mesh(std::move(X), std::move(elements));
  for (auto& [name, nodes] : sets)
    mesh.set_nodes(name, std::move(nodes));
  return mesh;
}

/// How far the stresses across the interface are from uniform, as parts of the pressure.
struct Unevenness {
  double largest = 0.0;       ///< of all elements
  double root_mean = 0.0;     ///< square, over the volume
  double away_from_it = 0.0;  ///< largest of the elements in the far half of each block
};

class TwoBlocks {
 public:
  TwoBlocks(const Cells& below, const Cells& above, Points points)
      : mesh_(two_blocks(below, above)),
        blocks_(mesh_, support::uniform_solid(mesh_, support::neo_hookean(C10),
                                              support::log_volume(kappa))) {
    const double share = points == Points::both ? 0.5 : 1.0;
    if (points != Points::below) add_contact("above/z_min", "below/z_max", share);
    if (points != Points::above) add_contact("below/z_max", "above/z_min", share);
    press();
  }

  /// What a block's nodes feel from all contact, and its moment about the origin.
  [[nodiscard]] std::pair<Vec3, Vec3> felt_by(const std::string& block) const {
    std::vector<double> r(blocks_.model.n_dofs());
    for (const Contact* contact : contacts_)
      EXPECT_TRUE(contact->add_residual(state_, {}, r, nullptr));
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    for (const char* side : {"z_min", "z_max"}) {
      for (const Index node : mesh_.nodes(block + side)) {
        const Vec3 f = -Eigen::Map<const Vec3>(r.data() + mechanics::dof(node, 0));
        force += f;
        moment += (mesh_.X()[at(node)] + state_.u[at(node)]).cross(f);
      }
    }
    return {force, moment};
  }

  /// Force that holds the lower side [mN].
  [[nodiscard]] double reaction_below() const {
    std::vector<double> r(blocks_.model.n_dofs());
    EXPECT_TRUE(blocks_.model.residual(state_, {}, r));
    double force = 0.0;
    for (const Index node : mesh_.nodes("below/z_min"))
      force += r[at(mechanics::dof(node, 2))];
    return force;
  }

  [[nodiscard]] Unevenness unevenness() const {
    Unevenness uneven;
    double volume = 0.0;
    const std::vector<mechanics::ElementMeans> means = blocks_.solid->means(state_, {});
    for (std::size_t e = 0; e < means.size(); ++e) {
      const double error = std::abs(means[e].sigma.zz / pressure + 1.0);
      const double V = blocks_.solid->volume0()[e];
      uneven.largest = std::max(uneven.largest, error);
      uneven.root_mean += V * error * error;
      volume += V;
      const double height = mesh_.centroid(to_index(e)).z();
      if (std::abs(height - 1.0) > 0.5) uneven.away_from_it = std::max(uneven.away_from_it, error);
    }
    uneven.root_mean = std::sqrt(uneven.root_mean / volume);
    return uneven;
  }

 private:
  [[nodiscard]] std::vector<mesh::Face> side(const std::string& name) const {
    return support::faces_between(mesh_, mesh_.nodes(name));
  }

  void add_contact(const std::string& points, const std::string& surface, double share) {
    contacts_.push_back(&blocks_.model.add(std::make_unique<Contact>(
        blocks_.model, support::contact_points(mesh_, side(points), share),
        support::contact_surface(surface, mesh_, side(surface)), settings)));
  }

  void press() {
    support::Supports supports;
    for (const std::string block : {"below/", "above/"}) {
      supports.hold(mesh_.nodes(block + "x_min"), 0).hold(mesh_.nodes(block + "x_max"), 0);
      supports.hold(mesh_.nodes(block + "y_min"), 1).hold(mesh_.nodes(block + "y_max"), 1);
    }
    supports.hold(mesh_.nodes("below/z_min"), 2);
    mechanics::Controls pressed;
    pressed.nodal_force.assign(mesh_.n_nodes(), Vec3::Zero());
    for (const mechanics::ContactPoint& point : support::contact_points(mesh_, side("above/z_max")))
      pressed.nodal_force[at(point.anchor.index)].z() = -pressure * point.area;
    const NewtonReport report =
        solve_equilibrium(blocks_.model, state_, pressed, supports.prescribed(),
                          {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-9});
    EXPECT_TRUE(report.converged) << report.reason;
  }

  mesh::Mesh mesh_;
  support::SolidModel blocks_;
  std::vector<const Contact*> contacts_;
  mechanics::State state_ = blocks_.model.initial_state();
};

TEST(TwoBlocks, CarryAUniformPressureWhereNodeMeetsNode) {
  for (const Points points : {Points::above, Points::below, Points::both}) {
    const TwoBlocks blocks({3, 2}, {3, 2}, points);
    EXPECT_LT(blocks.unevenness().largest, 1e-6);
  }
}

TEST(TwoBlocks, FeelEachOtherAlikeWhereMeshesDoNotMatch) {
  for (const Points points : {Points::below, Points::both}) {
    const TwoBlocks blocks({5, 2}, {2, 2}, points);
    const auto [force, moment] = blocks.felt_by("above/");
    const auto [back, moment_back] = blocks.felt_by("below/");
    EXPECT_LT((force + back).norm(), 1e-14 * area);
    EXPECT_LT((moment + moment_back).norm(), 1e-14 * area);
    EXPECT_NEAR(force.z(), pressure * area, 1e-7);
    EXPECT_NEAR(blocks.reaction_below(), pressure * area, 1e-7);
  }
}

/// Halving all cells must halve the error over the volume and more: it is that of elements at the interface, a layer that
/// becomes thinner, and would fall by the root of two if these stayed as uneven everywhere.
void expect_local(const Unevenness& coarse, const Unevenness& fine) {
  EXPECT_LT(fine.root_mean, 0.45 * coarse.root_mean);
  EXPECT_LT(fine.away_from_it, 0.5 * coarse.away_from_it);
}

TEST(TwoBlocks, CarryAPressureThatBecomesUniformWithRefinementWhereBothHavePoints) {
  const Unevenness coarse = TwoBlocks({3, 2}, {2, 2}, Points::both).unevenness();
  const Unevenness fine = TwoBlocks({6, 4}, {4, 4}, Points::both).unevenness();
  expect_local(coarse, fine);
  EXPECT_LT(coarse.largest, 0.1);
  EXPECT_LT(fine.root_mean, 0.015);
}

TEST(TwoBlocks, CarryAPressureThatBecomesUniformWithRefinementWhereTheFinerHasPoints) {
  // The largest error stays, in the elements at the corners of the coarser block: a corner gets a sixth or a third of its
  // square, as the cut into triangles has it, where a quarter would be even.
  const Unevenness coarse = TwoBlocks({5, 2}, {2, 2}, Points::below).unevenness();
  const Unevenness fine = TwoBlocks({10, 4}, {4, 4}, Points::below).unevenness();
  expect_local(coarse, fine);
  EXPECT_LT(fine.root_mean, 0.04);
}

}  // namespace
}  // namespace facies::solve
