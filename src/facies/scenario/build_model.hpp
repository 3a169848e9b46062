// SPDX-License-Identifier: Apache-2.0
// From a face and a scenario to a model: the only place where anatomy meets mechanics.
#pragma once

#include <memory>
#include <vector>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mechanics/model.hpp"
#include "facies/mechanics/solid.hpp"
#include "facies/scenario/scenario.hpp"

namespace facies::scenario {

/// A face ready to be driven. Not movable: the model refers to the mesh.
struct FaceModel {
  explicit FaceModel(anatomy::FaceAnatomy anatomy)
      : face(std::move(anatomy)), model(face.mesh.n_nodes()) {}

  anatomy::FaceAnatomy face;
  std::vector<anatomy::Muscle> muscles;  ///< in the order of Controls::activation
  mechanics::Model model;
  const mechanics::Solid* solid = nullptr;  ///< of the model
  std::vector<Index> held_in_tension;     ///< unknowns held while the tension is put in, ascending
  std::vector<Index> held_after_release;  ///< unknowns held from the release on, ascending
};

/// Chooses laws, turns muscle paths into fibres, numbers what is held. The tension scaling factor of the scenario's
/// tension step becomes the pre-stretch F0 = TSF I (1 where there is no such step).
/// Throws ScenarioError where the scenario names muscles that the face does not have, DataError where the face cannot
/// carry a model (a muscle without elements, inverted elements).
[[nodiscard]] std::unique_ptr<FaceModel> build_model(anatomy::FaceAnatomy face,
                                                     const Scenario& scenario, int threads);

/// Names that an express step may use for these muscles: groups and sides, each once, sorted.
[[nodiscard]] std::vector<std::string> activation_names(
    const std::vector<anatomy::Muscle>& muscles);

/// The tension scaling factor of the scenario; 1 where it has no tension step.
[[nodiscard]] double tension_scaling_factor(const Scenario& scenario);

}  // namespace facies::scenario
