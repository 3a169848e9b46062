// SPDX-License-Identifier: Apache-2.0
#include "facies/math/radial_warp.hpp"

#include <cmath>

#include <Eigen/LU>

#include "facies/base/error.hpp"
#include "facies/base/index.hpp"

namespace facies {

RadialWarp::RadialWarp(std::span<const Vec3> from, std::span<const Vec3> to, double rounding)
    : centres_(from.begin(), from.end()), weights_(from.size()), rounding_(rounding) {
  require(from.size() == to.size(), "RadialWarp: every point needs one place");
  const auto n = static_cast<Eigen::Index>(from.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(n + 4, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec3& x = from[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < i; ++k) {
      const double distance = (x - from[static_cast<std::size_t>(k)]).norm();
      require(distance > 1e-6, "RadialWarp: two points are in the same place");
      system(i, k) = system(k, i) = std::hypot(distance, rounding);
    }
    system(i, i) = rounding;
    system.block<1, 3>(i, n) = x.transpose();
    system(i, n + 3) = 1.0;
    places.row(i) = to[static_cast<std::size_t>(i)].transpose();
  }
  system.bottomLeftCorner(4, n) = system.topRightCorner(n, 4).transpose();
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(system);
  require(factor.isInvertible(), "RadialWarp: all points lie in a plane");
  const Eigen::MatrixXd solved = factor.solve(places);
  for (Eigen::Index i = 0; i < n; ++i)
    weights_[static_cast<std::size_t>(i)] = solved.row(i).transpose();
  A_ = solved.block<3, 3>(n, 0).transpose();
  b_ = solved.row(n + 3).transpose();
}

Vec3 RadialWarp::operator()(const Vec3& x) const {
  Vec3 place = A_ * x + b_;
  for (std::size_t i = 0; i < centres_.size(); ++i)
    place += std::hypot((x - centres_[i]).norm(), rounding_) * weights_[i];
  return place;
}

}  // namespace facies
