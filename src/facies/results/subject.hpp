// SPDX-License-Identifier: Apache-2.0
// What a result is about, as far as results need to know it: the mesh, its layers, landmarks, muscles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facies/mechanics/state.hpp"
#include "facies/mesh/mesh.hpp"

namespace facies::results {

struct NamedNode {
  std::string name, meaning;
  Index node = -1;
};

struct NamedPair {
  std::string a, b;  ///< names of NamedNodes
};

struct NamedMuscle {
  std::string name;
  std::vector<Index> elements;
};

/// Plain data about the face of a run; outlives everything that refers to it.
struct Subject {
  const mesh::Mesh* mesh = nullptr;
  std::vector<std::string> layers;    ///< names, outermost first
  std::vector<int> layer_of_element;  ///< [n_elements] position in `layers`
  std::vector<NamedNode> landmarks;
  std::vector<NamedPair> pairs;
  std::vector<NamedMuscle> muscles;  ///< in the order of Controls::activation
};

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
};

}  // namespace facies::results
