// SPDX-License-Identifier: Apache-2.0
// Small models from laws of the catalog, and what holds them.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hpp"

#include "facies/material/catalog.hpp"
#include "facies/mechanics/loads.hpp"
#include "facies/mechanics/model.hpp"
#include "facies/mechanics/solid.hpp"

namespace facies::support {

using LawPointer = std::shared_ptr<const material::Law>;
using VolumetricPointer = std::shared_ptr<const material::VolumetricLaw>;
using FibrePointer = std::shared_ptr<const material::FibreLaw>;

/// A matrix law with its example values; `axes` has a1, a2, a3 as columns.
inline LawPointer example_law(const std::string& name, const Mat3& axes = Mat3::Identity()) {
  const material::LawSpec& spec = *material::find_law(name);
  return spec.make(material::with_defaults(spec.parameters, spec.example), axes);
}

/// psi = C10 (I1_bar - 3): shear modulus 2 C10 [kPa].
inline LawPointer neo_hookean(double C10) {
  return material::find_law("mooney_rivlin")
      ->make({{"C10", C10}, {"C01", 0.0}, {"C20", 0.0}}, Mat3::Identity());
}

/// kappa/2 (ln J)^2.
inline VolumetricPointer log_volume(double kappa) {
  return material::find_volumetric_law("volumetric_log")->make({{"kappa", kappa}});
}

/// The muscle fibre with its example values.
inline FibrePointer example_fibre(const std::string& passive) {
  const material::FibreSpec& spec = *material::find_fibre_law("fibre_blemker2005");
  return spec.make(spec.example, passive);
}

/// The same tissue and the same pre-stretch everywhere.
inline mechanics::SolidDescription uniform_solid(const mesh::Mesh& mesh, const LawPointer& law,
                                                 const VolumetricPointer& volumetric,
                                                 const Mat3& F0 = Mat3::Identity()) {
  mechanics::SolidDescription description;
  description.law.assign(mesh.n_elements(), law);
  description.volumetric.assign(mesh.n_elements(), volumetric);
  description.F0.assign(mesh.n_elements(), F0);
  return description;
}

/// A family of fibres along one direction in all elements.
inline mechanics::FibreFamily uniform_fibres(const mesh::Mesh& mesh, const FibrePointer& law,
                                             Index muscle, const Vec3& direction) {
  mechanics::FibreFamily family{law, muscle, {}, {}};
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    family.elements.push_back(to_index(e));
    family.directions.push_back(direction);
  }
  return family;
}

/// A mesh with one solid and nodal forces.
struct SolidModel {
  SolidModel(mesh::Mesh of, mechanics::SolidDescription description, int threads = 1)
      : mesh(std::move(of)), model(mesh.n_nodes()) {
    model.add(std::make_unique<mechanics::NodalForces>());
    solid = &model.add(std::make_unique<mechanics::Solid>(mesh, std::move(description), threads));
  }

  mesh::Mesh mesh;
  mechanics::Model model;
  const mechanics::Solid* solid = nullptr;
};

/// Prescribed displacements, collected node by node; a later value replaces an earlier one.
class Supports {
 public:
  Supports& hold(std::span<const Index> nodes, int axis, double value = 0.0) {
    for (const Index node : nodes)
      values_[mechanics::dof(node, axis)] = value;
    return *this;
  }

  Supports& place(Index node, const Vec3& u) {
    for (int axis = 0; axis < 3; ++axis)
      values_[mechanics::dof(node, axis)] = u(axis);
    return *this;
  }

  /// All three directions of these nodes.
  Supports& clamp(std::span<const Index> nodes) {
    for (const Index node : nodes)
      place(node, Vec3::Zero());
    return *this;
  }

  [[nodiscard]] mechanics::Prescribed prescribed() const {
    mechanics::Prescribed prescribed;
    for (const auto& [dof, value] : values_) {
      prescribed.dofs.push_back(dof);
      prescribed.values.push_back(value);
    }
    return prescribed;
  }

 private:
  std::map<Index, double> values_;
};

/// Muscles as active as this, and no other load.
inline mechanics::Controls activated(std::vector<double> activation) {
  mechanics::Controls controls;
  controls.activation = std::move(activation);
  return controls;
}

/// The state in which every node has gone to A X + b, plus up to `shake` mm at random in each direction.
inline mechanics::State affine_state(const mesh::Mesh& mesh, const Mat3& A,
                                     const Vec3& b = Vec3::Zero(), double shake = 0.0) {
  mechanics::State state;
  Random random(5);
  for (const Vec3& X : mesh.X())
    state.u.emplace_back(A * X + b - X + random.vector(-shake, shake));
  return state;
}

/// `state` moved by `h` times a displacement [n_dofs].
inline mechanics::State moved(mechanics::State state, const Eigen::VectorXd& direction, double h) {
  for (std::size_t node = 0; node < state.u.size(); ++node)
    state.u[node] += h * direction.segment<3>(static_cast<Eigen::Index>(3 * node));
  return state;
}

/// A displacement of all nodes [n_dofs], each component within +-1.
inline Eigen::VectorXd random_direction(std::size_t n_dofs, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd direction(static_cast<Eigen::Index>(n_dofs));
  for (double& component : direction)
    component = random.uniform(-1.0, 1.0);
  return direction;
}

/// Whether two lists of numbers have the same bits.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace facies::support
