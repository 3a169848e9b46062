// SPDX-License-Identifier: Apache-2.0
// Tangents as dense matrices: the plain truth beside which sparse assembly is put.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "facies/mechanics/model.hpp"

namespace facies::support {

/// Adds the blocks of one term to a dense matrix over all unknowns, from the lower triangles alone.
class DenseSink final : public mechanics::TangentSink {
 public:
  DenseSink(const mechanics::Term& term, const mechanics::State& state, Eigen::MatrixXd& K)
      : K_(K) {
    term.list_stencils(state, stencils_);
  }

  void add(std::size_t stencil, std::span<const double> block) override {
    const std::span<const Index> dofs = stencils_[stencil];
    for (std::size_t j = 0; j < dofs.size(); ++j) {
      for (std::size_t i = j; i < dofs.size(); ++i) {
        const double k = block[j * dofs.size() + i];
        K_(dofs[i], dofs[j]) += k;
        if (i != j) K_(dofs[j], dofs[i]) += k;
      }
    }
  }

 private:
  mechanics::Stencils stencils_;
  Eigen::MatrixXd& K_;
};

/// K of all terms [n_dofs, n_dofs] [mN/mm].
inline Eigen::MatrixXd dense_tangent(const mechanics::Model& model, const mechanics::State& state,
                                     const mechanics::Controls& controls) {
  const auto n = static_cast<Eigen::Index>(model.n_dofs());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (const auto& term : model.terms()) {
    DenseSink sink(*term, state, K);
    term->add_tangent(state, controls, sink);
  }
  return K;
}

/// r of all terms [n_dofs] [mN]; NaN for an inadmissible state.
inline Eigen::VectorXd residual(const mechanics::Model& model, const mechanics::State& state,
                                const mechanics::Controls& controls) {
  std::vector<double> r(model.n_dofs());
  const auto n = static_cast<Eigen::Index>(r.size());
  if (!model.residual(state, controls, r))
    return Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
  return Eigen::Map<const Eigen::VectorXd>(r.data(), n);
}

/// Eigenvalues of a symmetric matrix in ascending order, by Jacobi's rotations: slow, simple and independent.
inline std::vector<double> symmetric_eigenvalues(Eigen::MatrixXd A) {
  const Eigen::Index n = A.rows();
  const auto rotate = [&](Eigen::Index p, Eigen::Index q) {
    if (A(p, q) == 0.0) return;
    const double angle = 0.5 * std::atan2(2.0 * A(p, q), A(q, q) - A(p, p));
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (Eigen::Index k = 0; k < n; ++k) {
      const double a = A(k, p);
      A(k, p) = c * a - s * A(k, q);
      A(k, q) = s * a + c * A(k, q);
    }
    for (Eigen::Index k = 0; k < n; ++k) {
      const double a = A(p, k);
      A(p, k) = c * a - s * A(q, k);
      A(q, k) = s * a + c * A(q, k);
    }
  };
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q)
        rotate(p, q);
    }
  }
  std::vector<double> values;
  for (Eigen::Index i = 0; i < n; ++i)
    values.push_back(A(i, i));
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace facies::support
