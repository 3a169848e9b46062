// SPDX-License-Identifier: Apache-2.0
// Frictionless contact of points with a triangle surface: a barrier that keeps every point on its side.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "facies/math/barrier.hpp"
#include "facies/math/point_triangle.hpp"
#include "facies/mechanics/anchor.hpp"
#include "facies/mesh/nearest.hpp"

namespace facies::mechanics {

/// A point that must not pass a surface, and the area that it stands for [mm^2].
struct ContactPoint {
  Anchor anchor;
  double area = 0.0;
};

/// A surface that points must not pass from either side: a bone (all vertices in space or on one body) or tissue (all
/// vertices on nodes).
struct ContactSurface {
  std::string name;
  std::vector<Anchor> vertices;
  std::vector<std::array<Index, 3>> triangles;
};

struct ContactSettings {
  double d_hat = 0.5;  ///< distance from which on a surface is felt [mm]
  double stiffness =
      100.0;  ///< of the barrier [kPa/mm]; the pressure at d_hat/2 is 1.19 d_hat times this
  double reach = 2.0;  ///< couplings are kept for what is nearer than this [mm]
  int threads = 1;     ///< has no influence on any answer
};

/// What a surface feels.
struct ContactReport {
  int n_points = 0;                ///< points nearer than d_hat
  double smallest_distance = 0.0;  ///< [mm]; infinity where nothing is near
  double largest_pressure = 0.0;   ///< [kPa]
  Vec3 force = Vec3::Zero();       ///< on the surface [mN]
};

/// E = sum over points and parts of the surface of area * stiffness * (+-b(d; d_hat)), with the unsigned distance d of the
/// point to the part and the barrier b of Incremental Potential Contact (Li et al. 2020, Eq. 6). Parts are the triangles
/// (+), the edges that two of them share (-) and the vertices inside the surface (+): so a plane is felt once however it
/// is cut into triangles, the energy has continuous first derivatives everywhere, and the sides of a crease are both felt
/// (li2023). E is infinite where a point touches, so none ever passes: longest_step() ends a step before (additive
/// continuous collision detection, Li et al. 2021).
///
/// A point that is a vertex of the surface does not feel its surroundings there: triangles with a vertex that is the point
/// or shares a triangle with it, and edges and vertices of such triangles, so that what is left is a surface with a
/// border. They are near without being in its way, and the elements below keep them apart.
class Contact final : public Term {
 public:
  /// The model must outlive the term. Throws BugError for a surface that is neither bone nor tissue.
  Contact(const Model& model, std::vector<ContactPoint> points, ContactSurface surface,
          const ContactSettings& settings);

  [[nodiscard]] std::string_view name() const override { return surface_.name; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  [[nodiscard]] double longest_step(const State& from, const State& to) const override;
  /// Nodes on their way into a bone stop before it, or go along with it where it comes towards them; those on their way
  /// into tissue stop halfway, as that does.
  void bend(const State& from, std::span<const double> straight,
            std::span<double> increments) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  [[nodiscard]] bool couplings_change() const override { return true; }
  void likely_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  /// What the surface feels at a state that has an energy.
  [[nodiscard]] ContactReport report(const State& state) const;

 private:
  /// A triangle, or an edge or vertex as a triangle with equal corners.
  struct Part {
    std::array<Index, 3> corners{};
    double sign = 1.0;
  };
  struct Pair {
    std::size_t point = 0;
    Index part = -1;
  };
  /// A pair that is near, with what the barrier says of it.
  struct Touch {
    std::array<Anchor, 4> anchors;
    DistanceResponse distance;
    BarrierResponse barrier;
  };
  /// What one point feels: its pairs hang on the same few unknowns.
  struct Group {
    std::size_t n_pairs = 0;
    std::vector<Index> vertices;  // ascending
    std::vector<Anchor> anchors;  // the point, then the vertices
  };
  struct Nearest {
    double distance = 0.0;
    Vec3 offset = Vec3::Zero();  // from the surface to the point
  };
  struct Geometry;
  struct Scene;
  struct Ways;
  /// The last two scenes that were asked for. Residual, energy and tangent ask for the same one after the other, and a step
  /// begins where the last one ended.
  struct Recent {
    std::mutex mutex;
    std::array<std::shared_ptr<const Scene>, 2> scenes;
  };

  void list_parts();
  void list_own_parts();
  [[nodiscard]] bool is_rigid() const;
  [[nodiscard]] Geometry places(const State& state) const;
  [[nodiscard]] std::optional<Geometry> geometry(const State& state) const;
  [[nodiscard]] std::shared_ptr<const Scene> scene(const State& state) const;
  [[nodiscard]] std::shared_ptr<const Scene> known(const State& state) const;
  [[nodiscard]] static Ways ways(const Geometry& from, const Geometry& to);
  template <class Work>
  void for_each_point(const Work& work) const;
  [[nodiscard]] bool is_own(std::size_t point, Index part) const;
  [[nodiscard]] ClosestOnTriangle closest(const Geometry& geometry, std::size_t point,
                                          Index part) const;
  [[nodiscard]] std::vector<Index> parts_near(const Geometry& geometry, std::size_t point,
                                              double distance) const;
  [[nodiscard]] std::vector<Pair> pairs(const Geometry& geometry, double distance) const;
  [[nodiscard]] std::array<Anchor, 4> anchors_of(const Pair& pair) const;
  [[nodiscard]] std::optional<Touch> touch(const State& state, const Pair& pair) const;
  [[nodiscard]] double weight(const Pair& pair) const;
  [[nodiscard]] Group group_of(std::span<const Pair> pairs) const;
  void push_groups(std::span<const Pair> pairs, Stencils& stencils) const;
  [[nodiscard]] Eigen::MatrixXd group_tangent(const State& state, const Group& group,
                                              std::span<const Pair> pairs) const;
  [[nodiscard]] static double relative_way(const Ways& ways, std::size_t point);
  [[nodiscard]] double safe_part(const Geometry& from, const Ways& ways, std::size_t point) const;
  [[nodiscard]] std::optional<Nearest> nearest_within(const Geometry& geometry, std::size_t point,
                                                      double reach) const;
  [[nodiscard]] double kept_gap(const Geometry& from, std::size_t point) const;
  [[nodiscard]] double share() const;
  [[nodiscard]] Vec3 way_around(const Geometry& from, const Ways& straight, std::size_t point,
                                double gap) const;
  [[nodiscard]] Vec3 lift(const Geometry& to, std::size_t point, double gap) const;

  const Model& model_;
  std::vector<ContactPoint> points_;
  ContactSurface surface_;
  ContactSettings settings_;
  std::vector<Part> parts_;               // the triangles, in their order; then edges and vertices
  std::vector<std::vector<Index>> rims_;  // [n_triangles] parts that are edges and vertices of it
  std::vector<std::vector<Index>> own_;  // [n_points] parts that the point does not feel, ascending
  std::shared_ptr<const mesh::NearestTriangles>
      rigid_;  // where the surface is a bone: in the bone's own frame
  mutable Recent recent_;
};

}  // namespace facies::mechanics
