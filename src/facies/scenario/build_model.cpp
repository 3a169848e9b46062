// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/build_model.hpp"

#include <algorithm>
#include <set>

#include "facies/mechanics/loads.hpp"
#include "facies/scenario/read_scenario.hpp"

namespace facies::scenario {

namespace {

using LawPointer = std::shared_ptr<const material::Law>;
using VolumetricPointer = std::shared_ptr<const material::VolumetricLaw>;

VolumetricPointer make_volumetric(const TissueChoice& tissue) {
  return material::find_volumetric_law(tissue.volumetric)->make(tissue.volumetric_values);
}

/// One law for all elements where it has no axes, one per element where it has.
void assign_tissue(const TissueChoice& tissue, std::span<const Index> elements,
                   const std::vector<Mat3>& axes, mechanics::SolidDescription& description) {
  const material::LawSpec& spec = *material::find_law(tissue.law);
  const VolumetricPointer volumetric = make_volumetric(tissue);
  const LawPointer shared =
      spec.has_axes ? nullptr : LawPointer(spec.make(tissue.values, Mat3::Identity()));
  for (const Index e : elements) {
    description.law[at(e)] = shared ? shared : LawPointer(spec.make(tissue.values, axes[at(e)]));
    description.volumetric[at(e)] = volumetric;
  }
}

void assign_tissues(const anatomy::FaceAnatomy& face, const Scenario& scenario,
                    mechanics::SolidDescription& description) {
  description.law.resize(face.mesh.n_elements());
  description.volumetric.resize(face.mesh.n_elements());
  for (const std::string& layer : anatomy::layer_names()) {
    const TissueChoice& tissue = layer == "skin" ? scenario.skin : scenario.hypodermis;
    assign_tissue(tissue, face.mesh.elements(layer), face.axes, description);
  }
  const bool complete =
      std::all_of(description.law.begin(), description.law.end(), [](const auto& p) { return p; });
  require(complete, "every element of a face belongs to a layer");
}

void assign_fibres(const std::vector<anatomy::Muscle>& muscles, const MuscleChoice& choice,
                   mechanics::SolidDescription& description) {
  const std::shared_ptr<const material::FibreLaw> law =
      material::find_fibre_law(choice.law)->make(choice.values, choice.passive);
  for (std::size_t m = 0; m < muscles.size(); ++m) {
    description.fibres.push_back({law, to_index(m), muscles[m].elements, muscles[m].directions});
  }
}

/// All three unknowns of the nodes of these sets, ascending.
std::vector<Index> unknowns_of(const mesh::Mesh& mesh, std::initializer_list<const char*> sets) {
  std::set<Index> nodes;
  for (const char* set : sets) {
    const std::span<const Index> members = mesh.nodes(set);
    nodes.insert(members.begin(), members.end());
  }
  std::vector<Index> dofs;
  dofs.reserve(3 * nodes.size());
  for (const Index node : nodes) {
    for (int axis = 0; axis < 3; ++axis)
      dofs.push_back(mechanics::dof(node, axis));
  }
  return dofs;
}

void check_supports(const FaceModel& model) {
  if (!model.held_after_release.empty()) return;
  throw DataError({{model.face.source, "no node is fixed",
                    "at least one of the node sets rim, zygomatic, nose, orbit",
                    "a face that nothing holds has no equilibrium"}});
}

}  // namespace

double tension_scaling_factor(const Scenario& scenario) {
  for (const Step& step : scenario.steps) {
    if (const auto* tension = std::get_if<TensionStep>(&step)) return tension->tsf;
  }
  return 1.0;
}

std::vector<std::string> activation_names(const std::vector<anatomy::Muscle>& muscles) {
  std::set<std::string> names;
  for (const anatomy::Muscle& muscle : muscles) {
    names.insert(muscle.name);
    names.insert(muscle.group);
  }
  return {names.begin(), names.end()};
}

std::unique_ptr<FaceModel> build_model(anatomy::FaceAnatomy face, const Scenario& scenario,
                                       int threads) {
  const double tsf = tension_scaling_factor(scenario);
  auto built = std::make_unique<FaceModel>(std::move(face));
  const mesh::Mesh& mesh = built->face.mesh;
  built->muscles = anatomy::select_muscles(built->face, scenario.muscle.radius, tsf);
  const std::vector<Problem> unknown =
      check_against_face(scenario, activation_names(built->muscles));
  if (!unknown.empty()) throw ScenarioError(unknown);

  mechanics::SolidDescription description;
  assign_tissues(built->face, scenario, description);
  assign_fibres(built->muscles, scenario.muscle, description);
  description.F0.assign(mesh.n_elements(), tsf * Mat3::Identity());
  const std::vector<double> density(mesh.n_elements(), scenario.density);
  built->model.add(
      std::make_unique<mechanics::Gravity>(mechanics::lumped_mass(mesh, density, description.F0)));
  built->model.add(std::make_unique<mechanics::NodalForces>());
  built->solid =
      &built->model.add(std::make_unique<mechanics::Solid>(mesh, std::move(description), threads));

  built->held_in_tension = unknowns_of(mesh, {"held_in_tension"});
  built->held_after_release =
      unknowns_of(mesh, {"rim", "zygomatic", "nose", "orbit", "mandibular"});
  check_supports(*built);
  return built;
}

}  // namespace facies::scenario
