// SPDX-License-Identifier: Apache-2.0
#include "facies/mechanics/anchor.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "facies/math/rotation.hpp"

namespace facies::mechanics {

namespace {

/// From the body's centre to the anchor, divided by the body's arm.
Vec3 lever(const Model& model, const State& state, const Anchor& anchor) {
  const RigidBody& body = model.bodies()[at(anchor.index)];
  return state.bodies[at(anchor.index)].R * (anchor.X - body.centre) / body.arm();
}

/// First of the anchor's unknowns; -1 for a place in space.
Index first_dof(const Model& model, const Anchor& anchor) {
  if (anchor.kind == Anchor::Kind::node) return dof(anchor.index, 0);
  return anchor.kind == Anchor::Kind::body ? model.body_dof(anchor.index, 0) : -1;
}

}  // namespace

Vec3 place_of(const Model& model, const State& state, const Anchor& anchor) {
  if (anchor.kind == Anchor::Kind::node) return anchor.X + state.u[at(anchor.index)];
  if (anchor.kind == Anchor::Kind::space) return anchor.X;
  return place_of(model.bodies()[at(anchor.index)], state.bodies[at(anchor.index)], anchor.X);
}

Vec3 way_of(const Model& model, const State& state, const Anchor& anchor,
            std::span<const double> increments) {
  if (anchor.kind == Anchor::Kind::space) return Vec3::Zero();
  const double* first = increments.data() + first_dof(model, anchor);
  Vec3 way = Eigen::Map<const Vec3>(first);
  if (anchor.kind == Anchor::Kind::body)
    way += Eigen::Map<const Vec3>(first + 3).cross(lever(model, state, anchor));
  return way;
}

void add_gradient(const Model& model, const State& state, const Anchor& anchor, const Vec3& dE_dx,
                  std::span<double> r) {
  if (anchor.kind == Anchor::Kind::space) return;
  Eigen::Map<Vec3>(r.data() + first_dof(model, anchor)) += dE_dx;
  if (anchor.kind == Anchor::Kind::body) {
    Eigen::Map<Vec3>(r.data() + first_dof(model, anchor) + 3) +=
        lever(model, state, anchor).cross(dE_dx);
  }
}

std::vector<Index> dofs_of(const Model& model, std::span<const Anchor> anchors) {
  std::vector<Index> dofs;
  for (const Anchor::Kind kind : {Anchor::Kind::node, Anchor::Kind::body}) {
    for (const Anchor& anchor : anchors) {
      if (anchor.kind != kind) continue;
      const Index first = first_dof(model, anchor);
      if (std::find(dofs.begin(), dofs.end(), first) != dofs.end()) continue;
      const Index n = kind == Anchor::Kind::node ? 3 : static_cast<Index>(dofs_of_body);
      for (Index k = 0; k < n; ++k)
        dofs.push_back(first + k);
    }
  }
  return dofs;
}

Eigen::MatrixXd pull_back(const Model& model, const State& state, std::span<const Anchor> anchors,
                          const Eigen::VectorXd& gradient, const Eigen::MatrixXd& hessian) {
  const std::vector<Index> dofs = dofs_of(model, anchors);
  const auto n = static_cast<Eigen::Index>(dofs.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(hessian.rows(), n);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t a = 0; a < anchors.size(); ++a) {
    const Anchor& anchor = anchors[a];
    if (anchor.kind == Anchor::Kind::space) continue;
    const auto row = static_cast<Eigen::Index>(3 * a);
    const auto found = std::find(dofs.begin(), dofs.end(), first_dof(model, anchor));
    const auto column = static_cast<Eigen::Index>(found - dofs.begin());
    J.block<3, 3>(row, column).setIdentity();
    if (anchor.kind != Anchor::Kind::body) continue;
    const Vec3 rho = lever(model, state, anchor);
    const Vec3 g = gradient.segment<3>(row);
    J.block<3, 3>(row, column + 3) = -cross_matrix(rho);
    // Second order of exp([w]) rho in w, against g; one arm is in rho, the other is missing still.
    const double arm = model.bodies()[at(anchor.index)].arm();
    K.block<3, 3>(column + 3, column + 3) +=
        (0.5 * (g * rho.transpose() + rho * g.transpose()) - g.dot(rho) * Mat3::Identity()) / arm;
  }
  K += J.transpose() * hessian * J;
  return K;
}

}  // namespace facies::mechanics
