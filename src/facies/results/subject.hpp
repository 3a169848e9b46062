// SPDX-License-Identifier: Apache-2.0
// What a result is about, as far as results need to know it: the mesh, its layers, landmarks, muscles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facies/mechanics/state.hpp"
#include "facies/mesh/mesh.hpp"
#include "facies/mesh/triangle_surface.hpp"
#include "facies/results/mechanism.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {

struct NamedNode {
  std::string name, meaning;
  Index node = -1;
};

struct NamedPair {
  std::string a, b;  ///< names of NamedNodes
};

struct NamedMuscle {
  std::string name;  ///< "ZYG_L"
  std::vector<Index> elements;
  std::string group = {};    ///< "ZYG": what both sides have in common
  std::string meaning = {};  ///< "zygomaticus"
};

/// The surface of a bone, teeth included.
struct BoneShape {
  std::string name;               ///< "maxilla"
  std::string meaning = {};       ///< "upper jaw"
  bool is_solid = true;           ///< false: an open sheet, without an inside that a cut could show
  Index body = -1;                ///< rigid body that it moves with (State::bodies); -1: fixed
  mesh::TriangleSurface surface;  ///< where it is while its body has not moved
  std::vector<bool> is_tooth;     ///< of each vertex; empty: none is
  Colour colour = palette::bone;  ///< but of its teeth
};

/// An eyeball behind its lids; it stays where it is.
struct EyeShape {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;  ///< [mm]
};

/// Plain data about the face of a run; outlives everything that refers to it.
struct Subject {
  const mesh::Mesh* mesh = nullptr;
  std::vector<std::string> layers;    ///< names, outermost first
  std::vector<int> layer_of_element;  ///< [n_elements] position in `layers`
  std::vector<Vec3> skin_lines =
      {};  ///< [n_elements] unit axis of the skin lines, zero outside the skin; or empty
  std::vector<NamedNode> landmarks;
  std::vector<NamedPair> pairs;
  std::vector<NamedMuscle> muscles;  ///< in the order of Controls::activation
  std::vector<BoneShape> bones;
  std::vector<EyeShape> eyes;
  std::vector<mechanics::RigidBody> bodies;  ///< as State::bodies
};

/// Where the point X [mm] of a bone is in a state; a state without bodies is one in which none has moved.
[[nodiscard]] inline Vec3 place_of(const Subject& subject, const BoneShape& bone,
                                   const mechanics::State& state, const Vec3& X) {
  if (bone.body < 0 || at(bone.body) >= state.bodies.size()) return X;
  return mechanics::place_of(subject.bodies.at(at(bone.body)), state.bodies[at(bone.body)], X);
}

/// A converged state at the end of a step or increment, with what is derived from it.
struct Snapshot {
  std::string step;     ///< "tension", "release", "express"
  int step_number = 0;  ///< counted from 1
  double load = 1.0;    ///< part of the step done, 0..1
  std::optional<double> time =
      {};  ///< of a state in a move step: seconds since the first move began
  mechanics::State state;
  mechanics::Controls controls;
  std::vector<Sym3<double>> sigma;  ///< [n_elements] Cauchy stress averaged over the element [kPa]
  std::vector<double> J;            ///< [n_elements] mean dilatation against the stress-free state
  std::optional<JawMeasure> jaw;    ///< where the model has one
  std::vector<ContactMeasure> contacts;
};

}  // namespace facies::results
