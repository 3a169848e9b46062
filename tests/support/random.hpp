// SPDX-License-Identifier: Apache-2.0
// Random tensors for tests, the same on every machine.
#pragma once

#include <cstdint>
#include <random>

#include <Eigen/Geometry>

#include "facies/math/tensor.hpp"

namespace facies::support {

/// A seeded source of numbers and tensors.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high). Not std::uniform_real_distribution, whose numbers each library chooses.
  double uniform(double low, double high) {
    constexpr double to_unit = 1.0 / 9007199254740992.0;  // 2^-53
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * to_unit;
  }

  Vec3 vector(double low, double high) {
    const double x = uniform(low, high);
    const double y = uniform(low, high);
    return {x, y, uniform(low, high)};
  }

  Vec3 unit_vector() {
    while (true) {
      const Vec3 v = vector(-1.0, 1.0);
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }

  Mat3 rotation() {
    return Eigen::AngleAxisd(uniform(0.0, 3.14), unit_vector()).toRotationMatrix();
  }

  /// Rotation times stretch, each principal log stretch within +-`strain`.
  Mat3 deformation_gradient(double strain) {
    const Mat3 R = rotation();
    const Mat3 axes = rotation();
    const Vec3 log_stretch = vector(-strain, strain);
    return R * axes * log_stretch.array().exp().matrix().asDiagonal() * axes.transpose();
  }

  /// A right Cauchy-Green tensor, each principal log stretch within +-`strain`.
  Sym3<double> right_cauchy_green(double strain) {
    return facies::right_cauchy_green(deformation_gradient(strain));
  }

  /// A symmetric tensor of norm 1.
  Sym3<double> direction() {
    const Vec3 d = vector(-1.0, 1.0);
    const Vec3 s = vector(-1.0, 1.0);
    const Sym3<double> A{d.x(), d.y(), d.z(), s.x(), s.y(), s.z()};
    return scaled(A, 1.0 / std::sqrt(double_dot(A, A)));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace facies::support
