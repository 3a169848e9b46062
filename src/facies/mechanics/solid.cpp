// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/solid.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "facies/base/parallel.hpp"
#include "facies/mechanics/colouring.hpp"
#include "facies/mechanics/kinematics.hpp"
#include "facies/mesh/quality.hpp"

namespace facies::mechanics {

namespace {

std::string element_name(Index e) {
  return "element " + std::to_string(e) + " (counted from 0)";
}

void check_description(const mesh::Mesh& mesh, const SolidDescription& description) {
  require(description.law.size() == mesh.n_elements(), "a solid needs one law per element");
  require(description.volumetric.size() == mesh.n_elements(),
          "a solid needs one volumetric law per element");
  require(description.F0.empty() || description.F0.size() == mesh.n_elements(),
          "a pre-stretch field has one value per element");
  for (const Mat3& F0 : description.F0)
    require(F0.determinant() > 0.0, "a pre-stretch has a positive determinant");
  for (const FibreFamily& family : description.fibres) {
    require(family.directions.size() == family.elements.size(),
            "a fibre family has one direction per element");
    require(family.shares.empty() || family.shares.size() == family.elements.size(),
            "a fibre family has one share per element or none");
    require(family.muscle >= 0, "a fibre family belongs to a muscle");
    for (const Index e : family.elements) {
      require(e >= 0 && at(e) < mesh.n_elements(), "a fibre family names an element that exists");
    }
  }
}

}  // namespace

Solid::Solid(const mesh::Mesh& mesh, SolidDescription description, int threads)
    : mesh_(mesh),
      description_(std::move(description)),
      threads_(threads),
      colours_(colour_elements(mesh)) {
  check_description(mesh_, description_);
  measure_points();
  sort_fibres();
}

void Solid::measure_points() {
  Problems problems;
  point_begin_.push_back(0);
  for (Index e = 0; e < to_index(mesh_.n_elements()); ++e) {
    const mesh::Element& element = mesh_.element(e);
    const Mat3 F0 = description_.F0.empty() ? Mat3(Mat3::Identity()) : description_.F0[at(e)];
    double V0 = 0.0;
    for (const mesh::QuadraturePoint& q : mesh::quadrature(element.type)) {
      const Mat3 dX_dxi = isoparametric_jacobian(mesh_, element, q.dN_dxi);
      const double dV = q.weight * dX_dxi.determinant();
      if (!(dV > 0.0)) {
        problems.add({element_name(e), "it is inverted or flat at a quadrature point",
                      "a positive volume", ""});
        break;
      }
      ElementPoint& point = points_.emplace_back();
      point.G = q.dN_dxi * dX_dxi.inverse() * F0;
      point.dV0 = dV / F0.determinant();
      V0 += point.dV0;
    }
    V0_.push_back(V0);
    point_begin_.push_back(points_.size());
  }
  problems.throw_if_any<DataError>();
}

void Solid::sort_fibres() {
  std::vector<std::vector<FibreOfElement>> of_element(mesh_.n_elements());
  for (const FibreFamily& family : description_.fibres) {
    n_muscles_ = std::max(n_muscles_, at(family.muscle) + 1);
    for (std::size_t k = 0; k < family.elements.size(); ++k) {
      const auto e = at(family.elements[k]);
      Vec3 a0 = family.directions[k];
      if (!description_.F0.empty()) a0 = (description_.F0[e].inverse() * a0).normalized();
      const double share = family.shares.empty() ? 1.0 : family.shares[k];
      of_element[e].push_back({family.law.get(), a0, family.muscle, share});
    }
  }
  Problems problems;
  fibre_begin_.push_back(0);
  for (std::size_t e = 0; e < of_element.size(); ++e) {
    if (of_element[e].size() > max_families) {
      problems.add({element_name(to_index(e)),
                    "it belongs to " + std::to_string(of_element[e].size()) + " muscles",
                    "at most " + std::to_string(max_families),
                    "select muscles with a smaller radius"});
    }
    fibres_.insert(fibres_.end(), of_element[e].begin(), of_element[e].end());
    fibre_begin_.push_back(fibres_.size());
  }
  problems.throw_if_any<DataError>();
}

ElementView Solid::view(Index e, const Controls& controls, FibreBuffer& buffer) const {
  const std::size_t n_fibres = fibre_begin_[at(e) + 1] - fibre_begin_[at(e)];
  for (std::size_t k = 0; k < n_fibres; ++k) {
    const FibreOfElement& fibre = fibres_[fibre_begin_[at(e)] + k];
    buffer[k] = {fibre.law, fibre.a0, controls.activation[at(fibre.muscle)], fibre.share};
  }
  const std::size_t begin = point_begin_[at(e)];
  return {{points_.data() + begin, point_begin_[at(e) + 1] - begin},
          V0_[at(e)],
          description_.law[at(e)].get(),
          description_.volumetric[at(e)].get(),
          {buffer.data(), n_fibres}};
}

NodeColumns Solid::positions(Index e, const State& state) const {
  NodeColumns x = NodeColumns::Zero();
  const std::span<const Index> nodes = mesh_.element(e).connectivity();
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    x.col(static_cast<Eigen::Index>(a)) = mesh_.X()[at(nodes[a])] + state.u[at(nodes[a])];
  }
  return x;
}

template <class Work>
void Solid::for_each_element(const Work& work) const {
  parallel_for(mesh_.n_elements(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      work(to_index(e));
  });
}

template <class Work>
void Solid::for_each_element_by_colour(const Work& work) const {
  for (const std::vector<Index>& colour : colours_) {
    parallel_for(colour.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        work(colour[k]);
    });
  }
}

void Solid::check_controls(const Controls& controls) const {
  require(controls.activation.size() >= n_muscles_, "controls need one activation per muscle");
}

double Solid::energy(const State& state, const Controls& controls) const {
  check_controls(controls);
  std::vector<double> W(mesh_.n_elements());
  for_each_element([&](Index e) {
    FibreBuffer buffer;
    W[at(e)] = element_energy(view(e, controls, buffer), positions(e, state));
  });
  return std::accumulate(W.begin(), W.end(), 0.0);
}

bool Solid::add_residual(const State& state, const Controls& controls, std::span<double> r,
                         Inadmissible* why) const {
  check_controls(controls);
  std::vector<double> J(mesh_.n_elements());
  for_each_element_by_colour([&](Index e) {
    FibreBuffer buffer;
    const ElementView element = view(e, controls, buffer);
    const NodeColumns x = positions(e, state);
    J[at(e)] = smallest_jacobian(element, x);
    if (!(J[at(e)] > 0.0)) return;
    const NodeColumns forces = element_residual(element, x);
    const std::span<const Index> nodes = mesh_.element(e).connectivity();
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (int axis = 0; axis < 3; ++axis)
        r[at(dof(nodes[a], axis))] += forces(axis, static_cast<Eigen::Index>(a));
    }
  });
  for (std::size_t e = 0; e < J.size(); ++e) {
    if (J[e] > 0.0) continue;
    if (why != nullptr) *why = {to_index(e), J[e]};
    return false;
  }
  return true;
}

Inadmissible Solid::overgrown(const State& state) const {
  std::vector<Vec3> x(mesh_.X().begin(), mesh_.X().end());
  for (std::size_t node = 0; node < x.size(); ++node)
    x[node] += state.u[node];
  Inadmissible worst;
  for (std::size_t e = 0; e < V0_.size(); ++e) {
    const double J = mesh::element_volume(mesh_, to_index(e), x) / V0_[e];
    if (J > description_.volumetric[e]->tearing_J() && J > worst.J) worst = {to_index(e), J};
  }
  return worst;
}

void Solid::list_stencils(const State& /*state*/, Stencils& stencils) const {
  std::vector<Index> group;
  for (const mesh::Element& element : mesh_.elements()) {
    group.clear();
    for (const Index node : element.connectivity()) {
      for (int axis = 0; axis < 3; ++axis)
        group.push_back(dof(node, axis));
    }
    stencils.push_back(group);
  }
}

void Solid::add_tangent(const State& state, const Controls& controls, TangentSink& K) const {
  check_controls(controls);
  for_each_element_by_colour([&](Index e) {
    FibreBuffer buffer;
    ElementMatrix block;
    element_tangent(view(e, controls, buffer), positions(e, state), block);
    if (mesh_.element(e).type == mesh::CellType::hex8) {
      K.add(at(e), {block.data(), static_cast<std::size_t>(block.size())});
    } else {
      const Eigen::Matrix<double, 18, 18> wedge = block.topLeftCorner<18, 18>();
      K.add(at(e), {wedge.data(), static_cast<std::size_t>(wedge.size())});
    }
  });
}

std::vector<ElementMeans> Solid::means(const State& state, const Controls& controls) const {
  check_controls(controls);
  std::vector<ElementMeans> result(mesh_.n_elements());
  for_each_element([&](Index e) {
    FibreBuffer buffer;
    result[at(e)] = element_means(view(e, controls, buffer), positions(e, state));
  });
  return result;
}

}  // namespace facies::mechanics
