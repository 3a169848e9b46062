// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/build_model.hpp"

#include <algorithm>
#include <set>

#include "facies/mechanics/loads.hpp"
#include "facies/mesh/surface.hpp"
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

/// The jaw with its joint, muscles and ligaments; while the tension is put in, or for good, it is held.
void add_jaw(FaceModel& built, const Scenario& scenario) {
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
    if (scenario.jaw == "held")
      built.held_after_release.push_back(built.model.body_dof(0, component));
  }
}

/// The surface around the mouth, as points and as triangles.
void add_lip_contact(FaceModel& built, const mechanics::ContactSettings& settings) {
  const mesh::Mesh& mesh = built.face.mesh;
  if (!mesh.face_sets().contains("mouth")) return;
  const std::span<const mesh::Face> faces = mesh.faces("mouth");
  const std::vector<Index> nodes = mesh::face_set_nodes(mesh, faces);
  std::map<Index, double> area;
  for (const mesh::Face& face : faces) {
    const std::array<mesh::Face, 1> alone = {face};
    const std::vector<Index> corners = mesh::face_set_nodes(mesh, alone);
    for (const Index node : corners)
      area[node] += mesh::face_area(mesh, face, mesh.X()) / static_cast<double>(corners.size());
  }
  std::vector<mechanics::ContactPoint> points;
  mechanics::ContactSurface surface{"lips", {}, {}};
  for (const Index node : nodes) {
    const mechanics::Anchor anchor = mechanics::Anchor::on_node(node, mesh.X()[at(node)]);
    points.push_back({anchor, area.at(node)});
    surface.vertices.push_back(anchor);
  }
  for (const std::array<Index, 3>& triangle : mesh::triangulate(mesh, faces).triangles) {
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), triangle[k]);
      corners[k] = static_cast<Index>(found - nodes.begin());
    }
    surface.triangles.push_back(corners);
  }
  built.contacts.push_back(&built.model.add(std::make_unique<mechanics::Contact>(
      built.model, std::move(points), std::move(surface), settings)));
}

/// Contact of everything that the scenario asks for, and an initial state without overlaps.
void add_contacts(FaceModel& built, const ContactChoice& choice) {
  const mechanics::ContactSettings settings{.d_hat = choice.distance,
                                            .stiffness = choice.stiffness};
  if (choice.bones || choice.skull != "none") {
    std::set<Index> left_out;
    for (const Index dof : built.held_after_release)
      left_out.insert(dof / 3);
    const std::span<const Index> tied = built.face.mesh.nodes("mandibular");
    left_out.insert(tied.begin(), tied.end());
    const std::vector<mechanics::ContactPoint> points = inner_points(built.face, left_out);
    std::vector<BoneObstacle> obstacles =
        bone_obstacles(built.face, built.jaw ? &*built.jaw : nullptr, choice);
    built.initial.u = resolve_overlaps(built.face, points, obstacles, choice.distance);
    for (BoneObstacle& obstacle : obstacles) {
      built.contacts.push_back(&built.model.add(std::make_unique<mechanics::Contact>(
          built.model, points, std::move(obstacle.surface), settings)));
    }
  }
  if (choice.lips) add_lip_contact(built, settings);
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

std::unique_ptr<FaceModel> build_model(anatomy::FaceAnatomy face, const Scenario& scenario,
                                       int threads) {
  const double tsf = tension_scaling_factor(scenario);
  std::optional<SettledJaw> settled;
  if (face.jaw) settled = settle_jaw(*face.jaw, scenario.gravity.vector());
  auto built = std::make_unique<FaceModel>(std::move(face), std::move(settled));
  const mesh::Mesh& mesh = built->face.mesh;
  built->muscles = anatomy::select_muscles(built->face, scenario.muscle.radius, tsf);
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

  built->held_in_tension = unknowns_of(mesh, {"held_in_tension"});
  built->held_after_release = unknowns_of(mesh, {"rim", "zygomatic", "nose", "orbit"});
  if (built->jaw) {
    add_jaw(*built, scenario);
  } else {
    built->held_after_release =
        unknowns_of(mesh, {"rim", "zygomatic", "nose", "orbit", "mandibular"});
  }
  check_supports(*built);
  built->initial = built->model.initial_state();
  add_contacts(*built, scenario.contact);
  if (has_dynamics(scenario)) add_dynamics(*built, scenario.dynamics, std::move(mass));
  return built;
}

}  // namespace facies::scenario
