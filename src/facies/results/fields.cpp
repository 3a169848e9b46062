// SPDX-License-Identifier: Apache-2.0
#include "facies/results/fields.hpp"

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/results/measures.hpp"

namespace facies::results {

std::vector<mesh::Field> node_fields(const Subject& subject, const Snapshot& snapshot,
                                     const mechanics::State* rest) {
  require(snapshot.state.u.size() == subject.mesh->n_nodes(),
          "node_fields: one displacement per node");
  std::vector<Vec3> from_rest = snapshot.state.u;
  if (rest != nullptr) {
    for (std::size_t i = 0; i < from_rest.size(); ++i)
      from_rest[i] -= rest->u[i];
  }
  return {mesh::vector_field("displacement_mm", snapshot.state.u),
          mesh::vector_field("displacement_from_rest_mm", from_rest)};
}

std::vector<mesh::Field> element_fields(const Subject& subject, const Snapshot& snapshot) {
  const std::size_t n = subject.mesh->n_elements();
  require(
      snapshot.J.size() == n && snapshot.sigma.size() == n && subject.layer_of_element.size() == n,
      "element_fields: one J, stress and layer per element");
  std::vector<double> tension;
  std::vector<Vec3> direction;
  for (const Sym3<double>& sigma : snapshot.sigma) {
    const PrincipalTension principal = principal_tension(sigma);
    tension.push_back(principal.value);
    direction.push_back(principal.direction);
  }
  std::vector<double> activation(n, 0.0);
  std::vector<int> n_muscles(n, 0);
  for (std::size_t m = 0; m < subject.muscles.size(); ++m) {
    const double alpha =
        m < snapshot.controls.activation.size() ? snapshot.controls.activation[m] : 0.0;
    for (const Index element : subject.muscles[m].elements) {
      activation[at(element)] += alpha;
      ++n_muscles[at(element)];
    }
  }
  return {mesh::integer_field("layer", subject.layer_of_element),
          mesh::scalar_field("J", snapshot.J),
          mesh::tensor_field("cauchy_stress_kPa", snapshot.sigma),
          mesh::scalar_field("principal_tension_kPa", tension),
          mesh::vector_field("principal_tension_direction", direction),
          mesh::scalar_field("activation", activation),
          mesh::integer_field("n_muscles", n_muscles)};
}

std::filesystem::path FieldWriter::add(const Snapshot& snapshot, const mechanics::State* rest) {
  const mesh::Mesh& mesh = *subject_->mesh;
  std::filesystem::path name = std::filesystem::path("fields") /
                               fmt::format("{:02}-{}.vtu", entries_.size() + 1, snapshot.step);
  mesh::write_vtu(folder_ / name, mesh, positions(mesh, snapshot.state),
                  node_fields(*subject_, snapshot, rest), element_fields(*subject_, snapshot));
  entries_.push_back(
      {snapshot.step_number - 1 + snapshot.load, name,
       fmt::format("step {} {}, load {}", snapshot.step_number, snapshot.step, snapshot.load)});
  mesh::write_pvd(folder_ / "fields.pvd", entries_);
  if (snapshot.time) {
    frames_.push_back({*snapshot.time, name, entries_.back().remark});
    mesh::write_pvd(folder_ / "motion.pvd", frames_);
  }
  return name;
}

}  // namespace facies::results
