// SPDX-License-Identifier: Apache-2.0
// Everything physical is a Term: it stores energy or exerts force.
//
// Sign: r(u) = internal - external, K = dr/du; Newton solves K du = -r.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "facies/mechanics/state.hpp"

namespace facies::mechanics {

/// The groups of unknowns that a term's tangent couples, one after the other: the sparsity pattern.
struct Stencils {
  std::vector<std::size_t> begin{0};  ///< group g holds dofs[begin[g]] .. dofs[begin[g+1]]
  std::vector<Index> dofs;

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const Index> operator[](std::size_t g) const {
    return {dofs.data() + begin[g], begin[g + 1] - begin[g]};
  }
  void push_back(std::span<const Index> group) {
    dofs.insert(dofs.end(), group.begin(), group.end());
    begin.push_back(dofs.size());
  }
};

/// Where tangents go. A term never learns what kind of matrix stands behind it.
class TangentSink {
 public:
  TangentSink() = default;
  TangentSink(const TangentSink&) = delete;
  TangentSink& operator=(const TangentSink&) = delete;
  TangentSink(TangentSink&&) = delete;
  TangentSink& operator=(TangentSink&&) = delete;
  virtual ~TangentSink() = default;

  /// Adds a symmetric block [n, n] for group `stencil` of the term that is being assembled; only its lower triangle
  /// (row >= column, column-major storage) is read. Calls for groups that share no unknown may come from several threads.
  virtual void add(std::size_t stencil, std::span<const double> block) = 0;
};

/// Where a state is no state of this body: an element is inside out, or it has grown beyond what its volumetric law can
/// hold (material::VolumetricLaw::tearing_J).
struct Inadmissible {
  Index element = -1;
  double J =
      0.0;  ///< not positive: the determinant found inside out; positive: the volume it has grown to
};

/// "element 12 is inside out (det F = -0.3)", "element 12 has grown to 38.8 times its stress-free volume ...".
[[nodiscard]] std::string describe(const Inadmissible& inadmissible);

class Term {
 public:
  Term() = default;
  Term(const Term&) = delete;
  Term& operator=(const Term&) = delete;
  Term(Term&&) = delete;
  Term& operator=(Term&&) = delete;
  virtual ~Term() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Stored energy minus the work of constant external forces [mN mm = uJ]; +infinity for an inadmissible state.
  [[nodiscard]] virtual double energy(const State& state, const Controls& controls) const = 0;

  /// Adds to r [n_dofs] [mN]. False where the state is inadmissible (det F <= 0); r is then worthless and `why`,
  /// if given, says where.
  [[nodiscard]] virtual bool add_residual(const State& state, const Controls& controls,
                                          std::span<double> r, Inadmissible* why) const = 0;

  /// Where an admissible state lies beyond what the laws hold for, the worst of it; element -1: nowhere. Such states can
  /// be evaluated, and iterations may pass through them, but an equilibrium there means nothing.
  [[nodiscard]] virtual Inadmissible overgrown(const State& /*state*/) const { return {}; }

  /// How much of the straight way of every point between two states can be gone without passing through something, 0..1.
  /// Only 1 is a promise about `to`: a part of the increments that led there may leave the way where a body turns, and has to
  /// be asked about again.
  [[nodiscard]] virtual double longest_step(const State& /*from*/, const State& /*to*/) const {
    return 1.0;
  }

  /// Bends a step that is about to be tried: changes increments [n_dofs] [mm] in second order only, or so that what would
  /// run into something stops before it. Newton's steps are straight, what stiff parts allow is not. `straight` is the step
  /// as it was before any term bent it.
  virtual void bend(const State& /*from*/, std::span<const double> /*straight*/,
                    std::span<double> /*increments*/) const {}

  /// The groups that add_tangent fills, in its numbering. Fixed for the life of the term, unless couplings_change().
  virtual void list_stencils(const State& /*state*/, Stencils& /*stencils*/) const {}

  /// True for a term whose groups depend on the state (contact): add_tangent then fills those of list_stencils at the
  /// same state, and likely_stencils tells what else may come nearby.
  [[nodiscard]] virtual bool couplings_change() const { return false; }
  virtual void likely_stencils(const State& /*state*/, Stencils& /*stencils*/) const {}

  /// Adds K [mN/mm] group by group. Only called for admissible states.
  virtual void add_tangent(const State& /*state*/, const Controls& /*controls*/,
                           TangentSink& /*K*/) const {}

  /// Whether its forces take energy out of a motion and are no other kind of force.
  [[nodiscard]] virtual bool dissipates() const { return false; }

  /// Puts into TimeStep::kept what it has to keep from the state and the controls at the beginning of a step.
  virtual void begin(const Controls& /*controls*/, TimeStep& /*step*/) const {}
};

}  // namespace facies::mechanics
