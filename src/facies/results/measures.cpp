// SPDX-License-Identifier: Apache-2.0
#include "facies/results/measures.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Eigenvalues>

#include "facies/base/error.hpp"
#include "facies/mesh/quality.hpp"

namespace facies::results {

namespace {

Vec3 position(const Subject& subject, Index node, const mechanics::State* state) {
  const Vec3& X = subject.mesh->X()[at(node)];
  return state == nullptr ? X : Vec3(X + state->u[at(node)]);
}

Index find_landmark(const Subject& subject, const std::string& name) {
  const auto found = std::find_if(subject.landmarks.begin(), subject.landmarks.end(),
                                  [&](const NamedNode& landmark) { return landmark.name == name; });
  require(found != subject.landmarks.end(), "measure_pairs: a pair names an unknown landmark");
  return found->node;
}

/// Nodes on edges that belong to one face of the set only.
std::set<Index> border_nodes(const mesh::Mesh& mesh, std::span<const mesh::Face> faces) {
  std::map<std::pair<Index, Index>, int> uses;
  for (const mesh::Face& face : faces) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      ++uses[std::minmax(nodes[i], nodes[(i + 1) % nodes.size()])];
    }
  }
  std::set<Index> border;
  for (const auto& [edge, count] : uses) {
    if (count == 1) border.insert({edge.first, edge.second});
  }
  return border;
}

}  // namespace

std::vector<Vec3> positions(const mesh::Mesh& mesh, const mechanics::State& state) {
  require(state.u.size() == mesh.n_nodes(), "positions: one displacement per node");
  std::vector<Vec3> x(mesh.X().begin(), mesh.X().end());
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += state.u[i];
  return x;
}

std::vector<LandmarkMeasure> measure_landmarks(const Subject& subject,
                                               const mechanics::State& state,
                                               const mechanics::State* rest) {
  std::vector<LandmarkMeasure> list;
  for (const NamedNode& landmark : subject.landmarks) {
    const Vec3 x = position(subject, landmark.node, &state);
    const Vec3 u = x - position(subject, landmark.node, rest);
    list.push_back({landmark.name, x, u, u.norm()});
  }
  return list;
}

std::vector<PairMeasure> measure_pairs(const Subject& subject, const mechanics::State& state,
                                       const mechanics::State* rest) {
  std::vector<PairMeasure> list;
  for (const NamedPair& pair : subject.pairs) {
    const Index a = find_landmark(subject, pair.a);
    const Index b = find_landmark(subject, pair.b);
    const double before = (position(subject, a, rest) - position(subject, b, rest)).norm();
    const double length = (position(subject, a, &state) - position(subject, b, &state)).norm();
    list.push_back({pair.a, pair.b, before, length, 100.0 * (length - before) / before});
  }
  return list;
}

PrincipalTension principal_tension(const Sym3<double>& sigma) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.compute(
      to_matrix(sigma));  // iterative: the closed form loses digits where two values are near
  Vec3 direction = solver.eigenvectors().col(2);
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction(largest) < 0.0) direction = -direction;
  return {solver.eigenvalues()(2), direction};
}

DilatationExtremes measure_dilatation(const Snapshot& snapshot) {
  if (snapshot.J.empty()) return {};
  const auto [smallest, largest] =
      std::pair{std::min_element(snapshot.J.begin(), snapshot.J.end()),
                std::max_element(snapshot.J.begin(), snapshot.J.end())};
  return {to_index(static_cast<std::size_t>(smallest - snapshot.J.begin())),
          to_index(static_cast<std::size_t>(largest - snapshot.J.begin())), *smallest, *largest};
}

Volumes measure_volumes(const Subject& subject, const Snapshot& snapshot) {
  const mesh::Mesh& mesh = *subject.mesh;
  require(snapshot.J.size() == mesh.n_elements(), "measure_volumes: one J per element");
  const std::vector<Vec3> x = positions(mesh, snapshot.state);
  Volumes volumes;
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    const double deformed = mesh::element_volume(mesh, to_index(e), x);
    volumes.mesh += mesh::element_volume(mesh, to_index(e), mesh.X());
    volumes.deformed += deformed;
    volumes.stress_free += deformed / snapshot.J[e];
  }
  return volumes;
}

TensionShare measure_tension_share(const Subject& subject, const Snapshot& snapshot) {
  const mesh::Mesh& mesh = *subject.mesh;
  require(snapshot.sigma.size() == mesh.n_elements() &&
              subject.layer_of_element.size() == mesh.n_elements(),
          "measure_tension_share: one stress and one layer per element");
  const std::vector<Vec3> x = positions(mesh, snapshot.state);
  const std::set<Index> border = border_nodes(mesh, mesh.faces("outer"));
  double all = 0.0;
  double all_tense = 0.0;
  double away = 0.0;
  double away_tense = 0.0;
  for (std::size_t e = 0; e < mesh.n_elements(); ++e) {
    if (subject.layer_of_element[e] != 0) continue;
    const double volume = mesh::element_volume(mesh, to_index(e), x);
    const double tense = principal_tension(snapshot.sigma[e]).value > 0.0 ? volume : 0.0;
    const std::span<const Index> nodes = mesh.element(to_index(e)).connectivity();
    all += volume;
    all_tense += tense;
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index node) { return border.contains(node); }))
      continue;
    away += volume;
    away_tense += tense;
  }
  TensionShare share;
  if (all > 0.0) share.all = all_tense / all;
  if (away > 0.0) share.away_from_borders = away_tense / away;
  return share;
}

}  // namespace facies::results
