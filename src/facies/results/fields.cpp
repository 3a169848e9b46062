// SPDX-License-Identifier: Apache-2.0
#include "facies/results/fields.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
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

std::string bones_vtu(const Subject& subject, const mechanics::State& state, bool moving) {
  std::vector<Vec3> x;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<int> number;
  std::vector<int> teeth;
  for (std::size_t b = 0; b < subject.bones.size(); ++b) {
    const BoneShape& bone = subject.bones[b];
    if ((bone.body >= 0) != moving) continue;
    const Index first = to_index(x.size());
    for (const Vec3& X : bone.surface.X)
      x.push_back(place_of(subject, bone, state, X));
    for (const std::array<Index, 3>& t : bone.surface.triangles) {
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      number.push_back(static_cast<int>(b));
      const bool is_tooth = !bone.is_tooth.empty() &&
                            std::ranges::all_of(t, [&](Index v) { return bone.is_tooth[at(v)]; });
      teeth.push_back(is_tooth ? 1 : 0);
    }
  }
  const std::array<mesh::Field, 2> fields = {mesh::integer_field("bone", number),
                                             mesh::integer_field("teeth", teeth)};
  return mesh::to_vtu(x, triangles, {}, fields);
}

std::filesystem::path FieldWriter::add(const Snapshot& snapshot, const mechanics::State* rest) {
  const std::string name = fmt::format("{:02}-{}", ++n_steps_, snapshot.step);
  write(snapshot, rest, name);
  return entries_.back().file;
}

std::filesystem::path FieldWriter::add_frame(const Snapshot& snapshot, const mechanics::State* rest,
                                             int frame) {
  const std::string name = fmt::format("{:02}-{}-{:03}", n_steps_ + 1, snapshot.step, frame);
  write(snapshot, rest, name);
  return entries_.back().file;
}

void FieldWriter::write(const Snapshot& snapshot, const mechanics::State* rest,
                        const std::string& name) {
  const mesh::Mesh& mesh = *subject_->mesh;
  const mesh::SeriesEntry entry = {
      snapshot.step_number - 1 + snapshot.load, std::filesystem::path("fields") / (name + ".vtu"),
      fmt::format("step {} {}, load {}", snapshot.step_number, snapshot.step, snapshot.load)};
  mesh::write_vtu(folder_ / entry.file, mesh, positions(mesh, snapshot.state),
                  node_fields(*subject_, snapshot, rest), element_fields(*subject_, snapshot));
  entries_.push_back(entry);
  mesh::write_pvd(folder_ / "fields.pvd", entries_);
  if (snapshot.time) {
    frames_.push_back({*snapshot.time, entry.file, entry.remark});
    mesh::write_pvd(folder_ / "motion.pvd", frames_);
  }
  if (!subject_->bones.empty()) write_bones(snapshot, entry, name);
}

void FieldWriter::write_bones(const Snapshot& snapshot, const mesh::SeriesEntry& entry,
                              const std::string& name) {
  for (const bool moving : {false, true}) {
    const auto belongs = [&](const BoneShape& bone) { return (bone.body >= 0) == moving; };
    if (std::ranges::none_of(subject_->bones, belongs)) continue;
    const std::filesystem::path file =
        std::filesystem::path("fields") / (moving ? name + "-bones.vtu" : "bones-fixed.vtu");
    if (moving || bones_.empty())
      write_file(folder_ / file, bones_vtu(*subject_, snapshot.state, moving));
    bones_.push_back({entry.time, file, entry.remark, moving ? 1 : 0});
  }
  mesh::write_pvd(folder_ / "bones.pvd", bones_);
}

}  // namespace facies::results
