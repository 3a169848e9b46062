// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/loads.hpp"

#include "facies/mechanics/kinematics.hpp"
#include "facies/mechanics/model.hpp"

namespace facies::mechanics {

namespace {

void subtract_force(std::span<double> r, std::size_t first_dof, const Vec3& force) {
  Eigen::Map<Vec3>(r.data() + first_dof) -= force;
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

Gravity::Gravity(std::vector<double> mass, std::span<const RigidBody> bodies)
    : mass_(std::move(mass)) {
  for (const RigidBody& body : bodies)
    body_mass_.push_back(body.mass);
}

double Gravity::energy(const State& state, const Controls& controls) const {
  double work = 0.0;
  for (std::size_t node = 0; node < mass_.size(); ++node) {
    work += mass_[node] * controls.gravity.dot(state.u[node]);
  }
  for (std::size_t body = 0; body < body_mass_.size(); ++body) {
    work += body_mass_[body] * controls.body_gravity.dot(state.bodies[body].u);
  }
  return -work;
}

bool Gravity::add_residual(const State& /*state*/, const Controls& controls, std::span<double> r,
                           Inadmissible* /*why*/) const {
  for (std::size_t node = 0; node < mass_.size(); ++node)
    subtract_force(r, 3 * node, mass_[node] * controls.gravity);
  for (std::size_t body = 0; body < body_mass_.size(); ++body) {
    subtract_force(r, 3 * mass_.size() + dofs_of_body * body,
                   body_mass_[body] * controls.body_gravity);
  }
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
    subtract_force(r, 3 * node, controls.nodal_force[node]);
  }
  return true;
}

}  // namespace facies::mechanics
