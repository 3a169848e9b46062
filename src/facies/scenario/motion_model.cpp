// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/motion_model.hpp"

#include <algorithm>

#include "facies/mechanics/damping.hpp"

namespace facies::scenario {

void add_dynamics(FaceModel& built, const DynamicsChoice& choice, std::vector<double> mass) {
  mechanics::Model& model = built.model;
  model.add(std::make_unique<mechanics::RayleighDamping>(*built.solid, mass, choice.rayleigh_alpha,
                                                         choice.rayleigh_beta));
  if (built.jaw) {
    const anatomy::Bone& bone = built.face.jaw->bones[at(built.face.jaw->mandible)];
    model.add(std::make_unique<mechanics::BodyDamping>(
        model, std::vector<mechanics::BodyFriction>{
                   {bone.translational_damping, bone.rotational_damping}}));
    model.add(std::make_unique<mechanics::MuscleDamping>(model, *built.jaw_terms.muscles));
  }
  const std::span<const Vec3> X = built.face.mesh.X();
  built.inertia = &model.add(std::make_unique<mechanics::Inertia>(
      model, std::vector<Vec3>(X.begin(), X.end()), std::move(mass)));
}

bool has_dynamics(const Scenario& scenario) {
  return std::any_of(scenario.steps.begin(), scenario.steps.end(), [](const Step& step) {
    const auto* move = std::get_if<MoveStep>(&step);
    return move != nullptr && move->method == "dynamic";
  });
}

solve::TimeSettings time_settings(const Scenario& scenario) {
  solve::TimeSettings settings;
  settings.newton.relative_tolerance = scenario.solver.relative_tolerance;
  settings.newton.max_iterations = scenario.solver.max_iterations;
  settings.rho_inf = scenario.dynamics.rho_inf;
  settings.first_step = scenario.dynamics.first_step;
  settings.smallest_step = scenario.dynamics.smallest_step;
  settings.tolerance = scenario.dynamics.tolerance;
  return settings;
}

mechanics::Controls controls_in_move(const FaceModel& model, const MoveStep& step,
                                     const Vec3& gravity, const mechanics::Controls& before,
                                     double time) {
  require(before.activation.size() == model.muscles.size(),
          "controls have one activation per muscle");
  std::map<std::string, double> now;
  for (const auto& [name, curve] : step.levels)
    now[name] = curve.at(time);
  mechanics::Controls to = before;
  to.gravity = gravity;
  for (std::size_t m = 0; m < model.muscles.size(); ++m) {
    const auto of_group = now.find(model.muscles[m].group);
    const auto own = now.find(model.muscles[m].name);
    if (of_group != now.end()) to.activation[m] = of_group->second;
    if (own != now.end()) to.activation[m] = own->second;
  }
  if (model.face.jaw) to.excitation = excite(*model.face.jaw, now, before.excitation);
  return mechanics::interpolate(before, to, std::min(1.0, time / (onset * step.duration)));
}

}  // namespace facies::scenario
