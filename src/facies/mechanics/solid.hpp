// SPDX-License-Identifier: Apache-2.0
// Soft tissue: a matrix law, muscle fibres and a volumetric law on linear hexahedra and wedges, with a pre-stretch field.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "facies/mechanics/element_kernel.hpp"
#include "facies/mechanics/term.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::mechanics {

/// A muscle's fibres in the solid: which elements, in which direction, driven by which activation.
struct FibreFamily {
  std::shared_ptr<const material::FibreLaw> law;
  Index muscle = -1;  ///< position in Controls::activation
  std::vector<Index> elements;
  std::vector<Vec3> directions;     ///< unit, one per element, in the mesh configuration
  std::vector<double> shares = {};  ///< of each element's volume that is fibre; empty: all of it
};

/// What a solid is made of. Laws are shared by the elements that use them.
struct SolidDescription {
  std::vector<std::shared_ptr<const material::Law>> law;                   ///< [n_elements]
  std::vector<std::shared_ptr<const material::VolumetricLaw>> volumetric;  ///< [n_elements]
  std::vector<FibreFamily> fibres;
  /// Pre-stretch [n_elements]: maps the stress-free state to the mesh configuration; the elastic deformation is
  /// F_e = F F0. Empty: none. The paper's tension scaling factor is F0 = TSF I everywhere.
  std::vector<Mat3> F0;
};

/// Total Lagrangian elements with full quadrature and mean dilatation: one volume change per element (Nagtegaal, Parks
/// and Rice 1974; Simo, Taylor and Pister 1985). The element itself is in element_kernel.hpp.
class Solid final : public Term {
 public:
  /// The most fibre families that one element may carry.
  static constexpr std::size_t max_families = 16;

  /// The mesh must outlive the solid. Throws DataError where an element is inverted or flat at a quadrature point, or
  /// carries more than max_families fibre families.
  Solid(const mesh::Mesh& mesh, SolidDescription description, int threads);

  [[nodiscard]] std::string_view name() const override { return "solid"; }
  [[nodiscard]] double energy(const State& state, const Controls& controls) const override;
  [[nodiscard]] bool add_residual(const State& state, const Controls& controls, std::span<double> r,
                                  Inadmissible* why) const override;
  [[nodiscard]] Inadmissible overgrown(const State& state) const override;
  void list_stencils(const State& state, Stencils& stencils) const override;
  void add_tangent(const State& state, const Controls& controls, TangentSink& K) const override;

  /// Mean Cauchy stress and dilatation of every element [n_elements] of an admissible state.
  [[nodiscard]] std::vector<ElementMeans> means(const State& state, const Controls& controls) const;

  /// Stress-free volume of each element [n_elements] [mm^3].
  [[nodiscard]] std::span<const double> volume0() const { return V0_; }

 private:
  using FibreBuffer = std::array<material::Fibre, max_families>;
  struct FibreOfElement {
    const material::FibreLaw* law = nullptr;
    Vec3 a0;
    Index muscle = -1;
    double share = 1.0;
  };

  void measure_points();
  void sort_fibres();
  void check_controls(const Controls& controls) const;
  [[nodiscard]] ElementView view(Index e, const Controls& controls, FibreBuffer& buffer) const;
  [[nodiscard]] NodeColumns positions(Index e, const State& state) const;
  template <class Work>
  void for_each_element(const Work& work) const;
  template <class Work>
  void for_each_element_by_colour(const Work& work) const;

  const mesh::Mesh& mesh_;
  SolidDescription description_;
  int threads_;
  std::vector<std::vector<Index>> colours_;
  std::vector<ElementPoint> points_;      // of all elements, one after the other
  std::vector<std::size_t> point_begin_;  // [n_elements + 1]
  std::vector<double> V0_;
  std::vector<FibreOfElement> fibres_;    // of all elements, one after the other
  std::vector<std::size_t> fibre_begin_;  // [n_elements + 1]
  std::size_t n_muscles_ = 0;             // activations that the controls must have
};

}  // namespace facies::mechanics
