// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/build_model.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/mechanics/loads.hpp"
#include "facies/scenario/motion_model.hpp"

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
    description.fibres.push_back(
        {law, to_index(m), muscles[m].elements, muscles[m].directions, muscles[m].shares});
  }
}

/// All three unknowns of the nodes of these sets, ascending.
std::vector<Index> unknowns_of(const mesh::Mesh& mesh, const std::vector<std::string>& sets) {
  std::set<Index> nodes;
  for (const std::string& set : sets) {
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

/// The node set that is tied to the jaw.
std::string attached_nodes(const anatomy::FaceAnatomy& face) {
  return face.jaw ? face.jaw->attached_nodes : anatomy::Jaw().attached_nodes;
}

/// Node sets that stay in place once the tension is in.
constexpr std::array<const char*, 4> supports = {"rim", "zygomatic", "nose", "orbit"};

/// Whether a run needs the jaw as a body: to move it, or to lean on it where it stands.
bool needs_jaw(const anatomy::FaceAnatomy& face, const Scenario& scenario) {
  return face.jaw && (scenario.jaw == "free" || scenario.contact.bones);
}

/// Throws DataError for a face that nothing holds, with its jaw as a body or without.
void check_supports(const anatomy::FaceAnatomy& face, bool has_body) {
  const auto holds = [&](const std::string& set) { return !face.mesh.nodes(set).empty(); };
  if (std::ranges::any_of(supports, holds) || (!has_body && holds(attached_nodes(face)))) return;
  throw DataError({{face.source, "no node is fixed",
                    fmt::format("at least one of the node sets {}", fmt::join(supports, ", ")),
                    "a face that nothing holds has no equilibrium"}});
}

/// What is held while the tension is put in, and from the release on. A jaw that is no body holds the nodes tied to it.
void choose_supports(FaceModel& built) {
  const mesh::Mesh& mesh = built.face.mesh;
  std::vector<std::string> held(supports.begin(), supports.end());
  if (!built.jaw) held.push_back(attached_nodes(built.face));
  check_supports(built.face, built.jaw.has_value());
  built.held_in_tension = unknowns_of(mesh, {"held_in_tension"});
  built.held_after_release = unknowns_of(mesh, held);
}

/// The jaw with its joint, muscles and ligaments; while the tension is put in, or for good, it is held.
void add_jaw(FaceModel& built, bool held) {
  const anatomy::Jaw& jaw = *built.face.jaw;
  const mesh::Mesh& mesh = built.face.mesh;
  built.jaw_terms = add_jaw_terms(built.model, jaw, *built.jaw);
  std::vector<mechanics::Attachment::Tie> ties;
  for (const Index node : mesh.nodes(jaw.attached_nodes)) {
    const Vec3& X = mesh.X()[at(node)];
    ties.push_back({mechanics::Anchor::on_node(node, X), mechanics::Anchor::on_body(0, X)});
  }
  built.ligaments = &built.model.add(std::make_unique<mechanics::Attachment>(
      built.model, std::move(ties), mechanics::joint_stiffness));
  for (int component = 0; component < static_cast<int>(mechanics::dofs_of_body); ++component) {
    built.held_in_tension.push_back(built.model.body_dof(0, component));
    if (held) built.held_after_release.push_back(built.model.body_dof(0, component));
  }
}

/// Nodes that take no part in contact with bone: held ones, and those tied to the jaw.
std::set<Index> nodes_on_bone(const anatomy::FaceAnatomy& face) {
  std::set<Index> nodes;
  const auto add = [&](const std::string& set) {
    const std::span<const Index> members = face.mesh.nodes(set);
    nodes.insert(members.begin(), members.end());
  };
  std::ranges::for_each(supports, add);
  add(attached_nodes(face));
  return nodes;
}

}  // namespace

double tension_scaling_factor(const Scenario& scenario) {
  for (const Step& step : scenario.steps) {
    if (const auto* tension = std::get_if<TensionStep>(&step)) return tension->tsf;
  }
  return 1.0;
}

std::vector<anatomy::Muscle> choose_muscles(const anatomy::FaceAnatomy& face,
                                            const Scenario& scenario) {
  const double tsf = tension_scaling_factor(scenario);
  const anatomy::MuscleReach reach{scenario.muscle.radius, scenario.muscle.margin};
  if (scenario.muscle.leave_out.empty()) return anatomy::select_muscles(face, reach, tsf);
  std::vector<std::string> fibres;
  for (const std::string_view name : split_blanks(scenario.muscle.leave_out))
    fibres.emplace_back(name);
  anatomy::FaceAnatomy reduced = face;
  const std::vector<std::string> known = anatomy::leave_out_fibres(reduced, fibres);
  Problems problems;
  for (const std::string& fibre : fibres) {
    if (std::ranges::find(known, fibre) == known.end()) {
      problems.add({where_of(scenario, "muscle.leave_out"),
                    fmt::format("this face has no fibre '{}'", fibre), "",
                    did_you_mean(fibre, known)});
    }
  }
  problems.throw_if_any<ScenarioError>();
  return anatomy::select_muscles(reduced, reach, tsf);
}

NamesOnFace names_on_face(const anatomy::FaceAnatomy& face,
                          const std::vector<anatomy::Muscle>& muscles) {
  std::set<std::string> names;
  for (const anatomy::Muscle& muscle : muscles) {
    names.insert(muscle.name);
    names.insert(muscle.group);
  }
  return {{names.begin(), names.end()},
          face.jaw ? excitation_names(*face.jaw) : std::vector<std::string>{}};
}

std::vector<Problem> check_model(const anatomy::FaceAnatomy& face, const Scenario& scenario) {
  try {
    const bool has_body = needs_jaw(face, scenario);
    check_supports(face, has_body);
    std::optional<SettledJaw> settled;
    if (has_body) settled = settle_jaw(*face.jaw, scenario.gravity.vector());
    const std::vector<BoneObstacle> obstacles =
        bone_obstacles(face, settled ? &*settled : nullptr, scenario.contact);
    if (!obstacles.empty()) {
      (void)resolve_overlaps(face, inner_points(face, nodes_on_bone(face)), obstacles,
                             scenario.contact.distance);
    }
  } catch (const DataError& error) {
    return error.problems();
  }
  return {};
}

std::unique_ptr<FaceModel> build_model(anatomy::FaceAnatomy face, const Scenario& scenario,
                                       int threads) {
  const double tsf = tension_scaling_factor(scenario);
  std::optional<SettledJaw> settled;
  if (needs_jaw(face, scenario)) settled = settle_jaw(*face.jaw, scenario.gravity.vector());
  auto built = std::make_unique<FaceModel>(std::move(face), std::move(settled));
  const mesh::Mesh& mesh = built->face.mesh;
  built->muscles = choose_muscles(built->face, scenario);
  const std::vector<Problem> unknown =
      check_against_face(scenario, names_on_face(built->face, built->muscles));
  if (!unknown.empty()) throw ScenarioError(unknown);

  mechanics::SolidDescription description;
  assign_tissues(built->face, scenario, description);
  assign_fibres(built->muscles, scenario.muscle, description);
  description.F0.assign(mesh.n_elements(), tsf * Mat3::Identity());
  const std::vector<double> density(mesh.n_elements(), scenario.density);
  std::vector<double> mass = mechanics::lumped_mass(mesh, density, description.F0);
  built->model.add(std::make_unique<mechanics::Gravity>(mass, built->model.bodies()));
  built->model.add(std::make_unique<mechanics::NodalForces>());
  built->solid =
      &built->model.add(std::make_unique<mechanics::Solid>(mesh, std::move(description), threads));

  choose_supports(*built);
  if (built->jaw) add_jaw(*built, scenario.jaw == "held");
  built->initial = built->model.initial_state();
  ContactTerms contact =
      add_contacts(built->model, built->face, built->jaw ? &*built->jaw : nullptr, scenario.contact,
                   nodes_on_bone(built->face), threads);
  built->contacts = std::move(contact.contacts);
  if (!contact.start.empty()) built->initial.u = std::move(contact.start);
  if (has_dynamics(scenario)) add_dynamics(*built, scenario.dynamics, std::move(mass));
  return built;
}

}  // namespace facies::scenario
