// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/even_shell.hpp"

#include <algorithm>
#include <span>

#include <lbfgs.h>

#include "facies/mesh/shell_corners.hpp"

namespace facies::mesh {
namespace {

/// The cost of an inner surface and how it changes with its control points. With s = a x b . c / (|a| |b| |c|), the scaled
/// Jacobian of a corner with edges a, b, c: ds/da = b x c / (|a| |b| |c|) - s a / |a|^2, and so on in turn.
class Cost {
 public:
  Cost(const Shell& shell, const Weights& limit, std::span<const Vec3> control,
       const EvenShellOptions& options)
      : shell_(shell),
        limit_(limit),
        limit_transposed_(limit.transpose()),
        before_(weighted(limit, control)),
        options_(options) {}

  /// `x` and `slope` are coordinates of control points, one after the other.
  double operator()(const double* x, double* slope, std::size_t n_control) {
    std::vector<Vec3> control(n_control);
    for (std::size_t i = 0; i < n_control; ++i)
      control[i] = Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    shell_.inner = weighted(limit_, control);
    slopes_.assign(shell_.inner.size(), Vec3::Zero());
    double cost = 0.0;
    for_each_corner(shell_, [&](const ShellCorner& corner) { cost += add(corner); });
    for (std::size_t v = 0; v < before_.size(); ++v) {
      const Vec3 way = shell_.inner[v] - before_[v];
      cost += options_.stiffness * way.squaredNorm();
      slopes_[v] += 2.0 * options_.stiffness * way;
    }
    for (std::size_t v = 0; v < options_.sides.size(); ++v) {
      const auto& [point, normal] = options_.sides[v];
      const double deep = normal.dot(point - shell_.inner[v]);
      if (deep <= 0.0) continue;
      cost += options_.hardness * deep * deep;
      slopes_[v] -= 2.0 * options_.hardness * deep * normal;
    }
    const std::vector<Vec3> by_control = weighted(limit_transposed_, slopes_);
    for (std::size_t i = 0; i < n_control; ++i)
      Eigen::Map<Vec3>(slope + 3 * i) = by_control[i];
    return cost;
  }

 private:
  double add(const ShellCorner& corner) {
    const double s = scaled_jacobian(corner);
    const double missing = options_.wanted - s;
    if (missing <= 0.0) return 0.0;
    const Vec3& a = corner.to_next;
    const Vec3& b = corner.to_previous;
    const Vec3& c = corner.outwards;
    const double lengths = std::max(a.norm() * b.norm() * c.norm(), 1e-30);
    const double d = -2.0 * missing;
    const Vec3 by_a = d * (b.cross(c) / lengths - s * a / std::max(a.squaredNorm(), 1e-30));
    const Vec3 by_b = d * (c.cross(a) / lengths - s * b / std::max(b.squaredNorm(), 1e-30));
    const Vec3 by_c = d * (a.cross(b) / lengths - s * c / std::max(c.squaredNorm(), 1e-30));
    add_to(corner.next, corner.depth, by_a);
    add_to(corner.previous, corner.depth, by_b);
    add_to(corner.vertex, corner.depth, -by_a - by_b);
    add_to(corner.vertex, corner.layer, by_c);
    add_to(corner.vertex, corner.layer + 1, -by_c);
    return missing * missing;
  }

  /// A node moves with the inner vertex of its column as far as its part of the way says.
  void add_to(Index v, int depth, const Vec3& slope) {
    slopes_[at(v)] += shell_.parts[static_cast<std::size_t>(depth)][at(v)] * slope;
  }

  Shell shell_;
  const Weights& limit_;
  Weights limit_transposed_;
  std::vector<Vec3> before_;
  std::vector<Vec3> slopes_;
  EvenShellOptions options_;
};

lbfgsfloatval_t evaluate(void* cost, const lbfgsfloatval_t* x, lbfgsfloatval_t* slope, int n,
                         lbfgsfloatval_t /*step*/) {
  return (*static_cast<Cost*>(cost))(x, slope, static_cast<std::size_t>(n) / 3);
}

}  // namespace

std::vector<Vec3> even_inner_surface(const Shell& shell, const Weights& limit,
                                     std::vector<Vec3> control, const EvenShellOptions& options) {
  require(limit.rows() == shell.net.n_vertices && limit.cols() == to_index(control.size()),
          "weights for another number of vertices or control points");
  const std::size_t n = at(shell.net.n_vertices);
  require(shell.outer.size() == n, "a shell's outer surface needs a point for every vertex");
  for (const std::vector<double>& parts : shell.parts)
    require(parts.size() == n, "a shell's node layer needs a part for every vertex");
  require(options.sides.empty() || to_index(options.sides.size()) == shell.net.n_vertices,
          "sides for another number of vertices");
  Cost cost(shell, limit, control, options);
  std::vector<double> x;
  for (const Vec3& point : control)
    x.insert(x.end(), point.begin(), point.end());
  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  parameters.m = 12;
  parameters.max_iterations = options.most_iterations;
  parameters.past = 3;
  parameters.delta = 1e-6;
  const int status =
      lbfgs(static_cast<int>(x.size()), x.data(), nullptr, evaluate, nullptr, &cost, &parameters);
  // Once it has begun, x is the best that was found, whatever ended it: a line search that cannot go on included. Statuses
  // below this one mean that it did not begin.
  require(status >= LBFGSERR_OUTOFINTERVAL, "liblbfgs refuses the shell's control points");
  for (std::size_t i = 0; i < control.size(); ++i)
    control[i] = Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
  return control;
}

}  // namespace facies::mesh
