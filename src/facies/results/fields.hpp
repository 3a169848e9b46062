// SPDX-License-Identifier: Apache-2.0
// fields/<nn>-<step>.vtu, fields.pvd and motion.pvd: everything known on nodes and elements, for ParaView and meshio; the
// bones beside it.
#pragma once

#include <filesystem>

#include "facies/mesh/vtu.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// Writes snapshots as they come. After each one the folder is complete and readable.
class FieldWriter {
 public:
  /// `folder`: the result folder, which holds fields/ already.
  FieldWriter(const Subject& subject, std::filesystem::path folder)
      : subject_(&subject), folder_(std::move(folder)) {}

  /// Adds one file and lists it in fields.pvd, at time (number of finished steps + part of this one); one with a time in motion.pvd as well, at that time [s]. `rest`: the state
  /// that displacement_from_rest_mm counts from; nullptr: the mesh as read. Returns the file's name within the folder.
  /// Bones that move get a file for each state, the others one for all; bones.pvd lists both.
  /// Throws UsageError where it cannot be written.
  std::filesystem::path add(const Snapshot& snapshot, const mechanics::State* rest);

  /// The same for a state on the way through a step, number `frame` of those (from 1).
  std::filesystem::path add_frame(const Snapshot& snapshot, const mechanics::State* rest,
                                  int frame);

 private:
  void write(const Snapshot& snapshot, const mechanics::State* rest, const std::string& name);
  void write_bones(const Snapshot& snapshot, const mesh::SeriesEntry& entry,
                   const std::string& name);

  const Subject* subject_;
  std::filesystem::path folder_;
  int n_steps_ = 0;  ///< files of ends of steps so far
  std::vector<mesh::SeriesEntry> entries_, bones_, frames_;
};

/// What a file holds on nodes: displacement_mm (from the mesh as read), displacement_from_rest_mm.
[[nodiscard]] std::vector<mesh::Field> node_fields(const Subject& subject, const Snapshot& snapshot,
                                                   const mechanics::State* rest);

/// What a file holds on elements: layer (0 outermost), J, cauchy_stress_kPa, principal_tension_kPa,
/// principal_tension_direction, activation (sum over the muscles that the element belongs to), n_muscles.
[[nodiscard]] std::vector<mesh::Field> element_fields(const Subject& subject,
                                                      const Snapshot& snapshot);

/// The file of the bones that move with a body, or of those that do not: points where they are in `state`, and for each
/// triangle `bone` (its position in Subject::bones) and `teeth` (1 where all corners are).
[[nodiscard]] std::string bones_vtu(const Subject& subject, const mechanics::State& state,
                                    bool moving);

}  // namespace facies::results
