// SPDX-License-Identifier: Apache-2.0
// What leads a rigid body: points that are guided on a path, and points that may not pass a plane.
#pragma once

#include <string>
#include <vector>

#include "facies/math/swept_curve.hpp"
#include "facies/mechanics/anchor.hpp"

namespace facies::mechanics {

/// Stiffness [mN/mm] of what bones do not give way to: 190 N, more than any jaw muscle pulls, move it by 0.019 mm.
inline constexpr double joint_stiffness = 1e7;

/// A point that is kept on a surface, from both sides: a condyle on the slope of the skull.
struct Guide {
  std::string name;
  Anchor anchor;
  SweptCurve curve;
};

/// A point that is kept on the side of a plane that its normal looks to.
struct Stop {
  std::string name;
  Anchor anchor;
  Vec3 point = Vec3::Zero();    ///< of the plane [mm]
  Vec3 normal = Vec3::UnitZ();  ///< unit, towards the admissible side
};

/// Springs. On the distance d of a guided point from its surface: E = stiffness/2 d^2. On a stopped point beyond its plane:
/// nothing for a distance d >= 0, a force of stiffness (-d - w/2) for d <= -w, a parabola between, so that stiffness and
/// energy are continuous to the second derivative (w = 0.01 mm, of which a point may sink in half without much force).
class Joint final : public Term {
 public:
  static constexpr double rounding = 0.01;  ///< w [mm]

  /// The model must outlive the term, which is usually one of its own. `stiffness` [mN/mm].
  Joint(const Model& model, std::vector<Guide> guides, std::vector<Stop> stops,
        double stiffness = joint_stiffness)
      : model_(model),
        guides_(std::move(guides)),
        stops_(std::move(stops)),
        stiffness_(stiffness) {}

  [[nodiscard]] std::string_view name() const override { return "joint"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  /// Guided points follow their surfaces where these curve; stopped points that would pass their planes stop there. So does
  /// what the straight step did not know of: a plane is felt only where a point has reached it.
  void bend(const State& from, std::span<const double> straight,
            std::span<double> increments) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  [[nodiscard]] std::span<const Guide> guides() const { return guides_; }
  [[nodiscard]] std::span<const Stop> stops() const { return stops_; }
  /// What guide g's point sees of its surface: its distance, how far along it is.
  [[nodiscard]] SurfaceView view(const State& state, std::size_t g) const;
  /// Force of the surface on guide g's point [mN].
  [[nodiscard]] Vec3 guide_reaction(const State& state, std::size_t g) const;
  /// Distance of stop k's point from its plane [mm], negative on the wrong side.
  [[nodiscard]] double distance(const State& state, std::size_t k) const;
  /// Force of the plane on stop k's point [mN].
  [[nodiscard]] Vec3 stop_reaction(const State& state, std::size_t k) const;

 private:
  struct Leads;
  void add_lead(const State& to, const Anchor& anchor, const Vec3& direction, double missing,
                Leads& leads) const;

  const Model& model_;
  std::vector<Guide> guides_;
  std::vector<Stop> stops_;
  double stiffness_;
};

}  // namespace facies::mechanics
