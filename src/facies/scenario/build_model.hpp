// SPDX-License-Identifier: Apache-2.0
// From a face and a scenario to a model: the only place where anatomy meets mechanics.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "facies/anatomy/face_anatomy.hpp"
#include "facies/mechanics/inertia.hpp"
#include "facies/mechanics/solid.hpp"
#include "facies/scenario/contact_model.hpp"
#include "facies/scenario/read_scenario.hpp"

namespace facies::scenario {

/// A face ready to be driven. Not movable: the model refers to the mesh, its terms to the model.
struct FaceModel {
  FaceModel(anatomy::FaceAnatomy anatomy, std::optional<SettledJaw> settled)
      : face(std::move(anatomy)),
        jaw(std::move(settled)),
        model(face.mesh.n_nodes(),
              jaw ? std::vector{jaw->body} : std::vector<mechanics::RigidBody>{}) {}

  anatomy::FaceAnatomy face;
  std::optional<SettledJaw> jaw;         ///< body 0 of the model
  std::vector<anatomy::Muscle> muscles;  ///< in the order of Controls::activation
  mechanics::Model model;
  mechanics::State initial;                 ///< where the run begins: nothing overlaps
  const mechanics::Solid* solid = nullptr;  ///< of the model, as all that follow
  JawTerms jaw_terms;
  const mechanics::Attachment* ligaments = nullptr;
  const mechanics::Inertia* inertia = nullptr;  ///< where the scenario has dynamics
  std::vector<const mechanics::Contact*> contacts;
  std::vector<Index> held_in_tension;     ///< unknowns held while the tension is put in, ascending
  std::vector<Index> held_after_release;  ///< unknowns held from the release on, ascending
};

/// Chooses laws, turns muscle paths into fibres, numbers what is held. The tension scaling factor of the scenario's
/// tension step becomes the pre-stretch F0 = TSF I (1 where there is no such step).
/// Throws ScenarioError where the scenario names muscles that the face does not have, DataError where the face cannot
/// carry a model (a muscle without elements, inverted elements).
[[nodiscard]] std::unique_ptr<FaceModel> build_model(anatomy::FaceAnatomy face,
                                                     const Scenario& scenario, int threads);

/// Everything that build_model would throw DataError for but what choose_muscles does: a face that nothing holds, a jaw that
/// cannot stand on its joint, bones that are not where tissue is. Solves for the jaw alone; needs a solve::Session.
[[nodiscard]] std::vector<Problem> check_model(const anatomy::FaceAnatomy& face,
                                               const Scenario& scenario);

/// The muscles of the face as the scenario wants them: fibres left out, elements within its radius. Throws ScenarioError
/// for fibres that the face does not have, DataError for a muscle without elements.
[[nodiscard]] std::vector<anatomy::Muscle> choose_muscles(const anatomy::FaceAnatomy& face,
                                                          const Scenario& scenario);

/// Names that steps may use on this face: of its muscles groups and sides, each once, sorted; of its jaw everything.
[[nodiscard]] NamesOnFace names_on_face(const anatomy::FaceAnatomy& face,
                                        const std::vector<anatomy::Muscle>& muscles);

/// The tension scaling factor of the scenario; 1 where it has no tension step.
[[nodiscard]] double tension_scaling_factor(const Scenario& scenario);

}  // namespace facies::scenario
