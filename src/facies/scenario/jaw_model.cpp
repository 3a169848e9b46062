// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/jaw_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "facies/mechanics/loads.hpp"
#include "facies/solve/newton.hpp"

namespace facies::scenario {

namespace {

mechanics::RigidBody body_in_file(const anatomy::Jaw& jaw) {
  const anatomy::Bone& bone = jaw.bones[at(jaw.mandible)];
  return {bone.name, bone.centre, bone.mass, bone.inertia};
}

/// Farthest that a guided point is off its path, and the smallest distance from a stop [mm].
std::pair<double, double> joint_distances(const JawTerms& terms, const mechanics::State& state) {
  double off = 0.0;
  for (std::size_t g = 0; g < terms.joint->guides().size(); ++g)
    off = std::max(off, std::abs(terms.joint->view(state, g).distance));
  double deepest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < terms.joint->stops().size(); ++k)
    deepest = std::min(deepest, terms.joint->distance(state, k));
  return {off, deepest};
}

/// A point may be this far off its path or beyond its stop where the jaw is at rest [mm]; with joint_stiffness that
/// is a force of 1000 N.
constexpr double most_off_joint = 0.1;

/// What lies between the starting pose and the place of rest may be this much [mm]: more than any play of a joint.
constexpr double most_settling = 25.0;

/// Guides and stops that are farther from being satisfied than `most` [mm]. `pose` is where the jaw is, in words.
void check_joint(const anatomy::Jaw& jaw, const JawTerms& terms, const mechanics::State& state,
                 double most, const std::string& pose, const std::string& hint,
                 Problems& problems) {
  const auto add = [&](const std::string& where, Index point, double off, const std::string& from) {
    if (off <= most) return;
    problems.add({where,
                  fmt::format("{} {} is {:.3g} mm {}", pose, jaw.points[at(point)].name, off, from),
                  fmt::format("at most {:g} mm", most), hint});
  };
  for (std::size_t g = 0; g < jaw.guides.size(); ++g) {
    const anatomy::JawGuide& guide = jaw.guides[g];
    add(guide.where, guide.point, std::abs(terms.joint->view(state, g).distance),
        "off the path " + guide.name);
  }
  std::size_t k = 0;
  for (const anatomy::JawStop& stop : jaw.stops) {
    if (!stop.enabled) continue;
    add(stop.where, stop.point, -terms.joint->distance(state, k), "beyond the stop " + stop.name);
    ++k;
  }
}

/// The jaw comes to rest near where it began.
void check_settling(const anatomy::Jaw& jaw, const mechanics::Pose& rest, Problems& problems) {
  const mechanics::RigidBody body = body_in_file(jaw);
  double farthest = 0.0;
  std::string name;
  for (const anatomy::JawPoint& point : jaw.points) {
    if (point.at.bone != jaw.mandible) continue;
    const Vec3 before = anatomy::place_of(jaw, jaw.start, point.at);
    const double moved = (mechanics::place_of(body, rest, point.at.X) - before).norm();
    if (moved <= farthest) continue;
    farthest = moved;
    name = point.name;
  }
  if (farthest <= most_settling) return;
  problems.add({body.name,
                fmt::format("it comes to rest with {} {:.3g} mm away from its place in the "
                            "starting pose",
                            name, farthest),
                fmt::format("at most {:g} mm", most_settling),
                "look at the tables of the joint: do guides and stops lead the points meant?"});
}

}  // namespace

mechanics::Anchor anchor_of(const anatomy::Jaw& jaw, const SettledJaw& settled,
                            const anatomy::BonePoint& point) {
  if (point.bone != jaw.mandible) return mechanics::Anchor::in_space(point.X);
  return mechanics::Anchor::on_body(
      0, mechanics::place_of(body_in_file(jaw), settled.from_files, point.X));
}

JawTerms add_jaw_terms(mechanics::Model& model, const anatomy::Jaw& jaw,
                       const SettledJaw& settled) {
  std::vector<mechanics::Guide> guides;
  for (const anatomy::JawGuide& guide : jaw.guides) {
    guides.push_back(
        {guide.name, anchor_of(jaw, settled, jaw.points[at(guide.point)].at), guide.curve});
  }
  std::vector<mechanics::Stop> stops;
  for (const anatomy::JawStop& stop : jaw.stops) {
    if (!stop.enabled) continue;
    stops.push_back({stop.name, anchor_of(jaw, settled, jaw.points[at(stop.point)].at), stop.plane,
                     stop.normal});
  }
  std::vector<mechanics::HillMuscle> muscles;
  for (const anatomy::JawMuscle& muscle : jaw.muscles) {
    muscles.push_back({muscle.name,
                       anchor_of(jaw, settled, muscle.origin),
                       anchor_of(jaw, settled, muscle.insertion),
                       {muscle.max_force, muscle.optimal_length, muscle.max_length,
                        muscle.tendon_ratio, muscle.passive_fraction, muscle.damping}});
  }
  JawTerms terms;
  terms.joint =
      &model.add(std::make_unique<mechanics::Joint>(model, std::move(guides), std::move(stops)));
  terms.muscles = &model.add(std::make_unique<mechanics::HillMuscles>(model, std::move(muscles)));
  return terms;
}

SettledJaw settle_jaw(const anatomy::Jaw& jaw, const Vec3& gravity) {
  SettledJaw in_file;
  in_file.body = body_in_file(jaw);
  mechanics::Model model(0, {in_file.body});
  model.add(std::make_unique<mechanics::Gravity>(std::vector<double>{}, model.bodies()));
  const JawTerms terms = add_jaw_terms(model, jaw, in_file);
  mechanics::State state = model.initial_state();
  state.bodies[0] = {jaw.start.u, jaw.start.R};
  SettledJaw settled;
  settled.guide_before = joint_distances(terms, state).first;
  Problems problems;
  check_joint(jaw, terms, state, most_settling, "in the starting pose",
              "look at the units of jaw-poses.csv and jaw-points.csv", problems);
  problems.throw_if_any<DataError>();
  mechanics::Controls weight;
  weight.body_gravity = gravity;
  const solve::NewtonReport report =
      solve::solve_equilibrium(model, state, weight, {}, {.max_iterations = 500});
  check_joint(jaw, terms, state, most_off_joint, "the jaw cannot satisfy its joint: at rest",
              "no pose near the starting pose satisfies all guides and stops: look at their tables",
              problems);
  if (!report.converged) {
    problems.add({in_file.body.name, "it finds no place of rest on its joint: " + report.reason,
                  "guides and stops that a pose near the starting pose satisfies",
                  "look at the joint's tables of this face"});
  }
  const mechanics::Pose& pose = state.bodies[0];
  check_settling(jaw, pose, problems);
  problems.throw_if_any<DataError>();
  settled.from_files = pose;
  settled.body = in_file.body;
  settled.body.centre += pose.u;
  settled.body.inertia = pose.R * in_file.body.inertia * pose.R.transpose();
  std::tie(settled.guide_after, settled.deepest_stop) = joint_distances(terms, state);
  return settled;
}

std::vector<std::string> excitation_names(const anatomy::Jaw& jaw) {
  std::vector<std::string> names;
  for (const anatomy::Exciter& exciter : jaw.exciters)
    names.push_back(exciter.name);
  for (const anatomy::JawMuscle& muscle : jaw.muscles)
    names.push_back(muscle.name);
  return names;
}

std::vector<double> excite(const anatomy::Jaw& jaw,
                           const std::map<std::string, double>& excitations,
                           std::vector<double> before) {
  std::vector<double> after = std::move(before);
  after.resize(jaw.muscles.size(), 0.0);
  std::map<Index, double> by_group;
  for (const anatomy::Exciter& exciter : jaw.exciters) {
    const auto found = excitations.find(exciter.name);
    if (found == excitations.end()) continue;
    for (const Index muscle : exciter.muscles) {
      double& value = by_group.try_emplace(muscle, 0.0).first->second;
      value = std::max(value, found->second);
    }
  }
  for (const auto& [muscle, value] : by_group)
    after[at(muscle)] = value;
  for (std::size_t m = 0; m < jaw.muscles.size(); ++m) {
    const auto own = excitations.find(jaw.muscles[m].name);
    if (own != excitations.end()) after[m] = own->second;
  }
  return after;
}

}  // namespace facies::scenario
