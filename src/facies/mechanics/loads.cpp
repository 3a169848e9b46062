// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/loads.hpp"

#include "facies/mechanics/kinematics.hpp"

namespace facies::mechanics {

namespace {

void subtract_force(std::span<double> r, std::size_t node, const Vec3& force) {
  for (int axis = 0; axis < 3; ++axis)
    r[at(dof(to_index(node), axis))] -= force(axis);
}

}  // namespace

std::vector<double> lumped_mass(const mesh::Mesh& mesh, std::span<const double> density,
                                std::span<const Mat3> F0) {
  std::vector<double> mass(mesh.n_nodes(), 0.0);
  for (Index e = 0; e < to_index(mesh.n_elements()); ++e) {
    const mesh::Element& element = mesh.element(e);
    for (const mesh::QuadraturePoint& point : mesh::quadrature(element.type)) {
      const double dV =
          point.weight * isoparametric_jacobian(mesh, element, point.dN_dxi).determinant();
      const double dV0 = F0.empty() ? dV : dV / F0[at(e)].determinant();
      for (std::size_t a = 0; a < element.connectivity().size(); ++a) {
        mass[at(element.nodes[a])] += density[at(e)] * point.N(static_cast<Eigen::Index>(a)) * dV0;
      }
    }
  }
  return mass;
}

double Gravity::energy(const State& state, const Controls& controls) const {
  double work = 0.0;
  for (std::size_t node = 0; node < mass_.size(); ++node) {
    work += mass_[node] * controls.gravity.dot(state.u[node]);
  }
  return -work;
}

bool Gravity::add_residual(const State& /*state*/, const Controls& controls, std::span<double> r,
                           Inadmissible* /*why*/) const {
  for (std::size_t node = 0; node < mass_.size(); ++node)
    subtract_force(r, node, mass_[node] * controls.gravity);
  return true;
}

double NodalForces::energy(const State& state, const Controls& controls) const {
  double work = 0.0;
  for (std::size_t node = 0; node < controls.nodal_force.size(); ++node) {
    work += controls.nodal_force[node].dot(state.u[node]);
  }
  return -work;
}

bool NodalForces::add_residual(const State& /*state*/, const Controls& controls,
                               std::span<double> r, Inadmissible* /*why*/) const {
  for (std::size_t node = 0; node < controls.nodal_force.size(); ++node) {
    subtract_force(r, node, controls.nodal_force[node]);
  }
  return true;
}

}  // namespace facies::mechanics
