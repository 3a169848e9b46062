// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/catmull_clark.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/SparseLU>

#include "facies/base/error.hpp"

namespace facies::mesh {
namespace {

using Quad = std::array<Index, 4>;
using Triplet = Eigen::Triplet<double>;

/// What is around the vertices of a net.
struct Surroundings {
  std::map<NetEdge, std::vector<Index>> edges;
  std::vector<std::vector<Index>> neighbours;  ///< [n_vertices] along edges, ascending
  std::vector<std::vector<Index>> on_border;   ///< [n_vertices] along border edges, ascending
  std::vector<std::vector<Index>> quads;       ///< [n_vertices]
  std::vector<std::vector<Index>> opposite;    ///< [n_vertices] across each of its quadrilaterals

  explicit Surroundings(const QuadNet& net);
};

Surroundings::Surroundings(const QuadNet& net)
    : edges(edges_of(net)),
      neighbours(at(net.n_vertices)),
      on_border(at(net.n_vertices)),
      quads(at(net.n_vertices)),
      opposite(at(net.n_vertices)) {
  for (std::size_t q = 0; q < net.quads.size(); ++q) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Index v = net.quads[q][k];
      quads[at(v)].push_back(to_index(q));
      opposite[at(v)].push_back(net.quads[q][(k + 2) % 4]);
    }
  }
  for (const auto& [edge, around] : edges) {
    for (const auto& [v, w] : {edge, NetEdge(edge.second, edge.first)}) {
      neighbours[at(v)].push_back(w);
      if (around.size() == 1) on_border[at(v)].push_back(w);
    }
  }
}

/// A row of weights as a sum of terms.
class Rows {
 public:
  Rows(Index n_to, Index n_from) : n_to_(n_to), n_from_(n_from) {}

  void add(Index to, Index from, double weight) { terms_.emplace_back(to, from, weight); }
  template <class List>
  void add_each(Index to, const List& from, double weight) {
    for (const Index f : from)
      add(to, f, weight);
  }
  [[nodiscard]] Weights made() const {
    Weights weights(n_to_, n_from_);
    weights.setFromTriplets(terms_.begin(), terms_.end());
    return weights;
  }

 private:
  Index n_to_, n_from_;
  std::vector<Triplet> terms_;
};

bool is_corner(const Surroundings& around, Index v) {
  return around.quads[at(v)].size() == 1;
}

/// The new control point of an old vertex: (F + 2 E + (n - 3) V) / n with the means F of the n quadrilaterals' centres and
/// E of the edges' middles.
void add_vertex_rule(const QuadNet& net, const Surroundings& around, Index v, Rows& rows) {
  if (is_corner(around, v)) {
    rows.add(v, v, 1.0);
  } else if (!around.on_border[at(v)].empty()) {
    rows.add(v, v, 0.75);
    rows.add_each(v, around.on_border[at(v)], 0.125);
  } else {
    const auto n = static_cast<double>(around.quads[at(v)].size());
    for (const Index q : around.quads[at(v)])
      rows.add_each(v, net.quads[at(q)], 0.25 / (n * n));
    rows.add(v, v, (n - 3.0) / n + 1.0 / n);
    rows.add_each(v, around.neighbours[at(v)], 1.0 / (n * n));
  }
}

template <class Value>
std::vector<Value> applied(const Weights& weights, std::span<const Value> values, Value zero) {
  require(to_index(values.size()) == weights.cols(), "weights for another number of vertices");
  std::vector<Value> result(static_cast<std::size_t>(weights.rows()), zero);
  for (Index row = 0; row < static_cast<Index>(weights.outerSize()); ++row) {
    for (Weights::InnerIterator entry(weights, row); entry; ++entry)
      result[at(row)] += entry.value() * values[static_cast<std::size_t>(entry.col())];
  }
  return result;
}

}  // namespace

NetEdge edge_of(Index a, Index b) {
  return std::minmax({a, b});
}

std::map<NetEdge, std::vector<Index>> edges_of(const QuadNet& net) {
  std::map<NetEdge, std::vector<Index>> edges;
  for (std::size_t q = 0; q < net.quads.size(); ++q) {
    for (std::size_t k = 0; k < 4; ++k)
      edges[edge_of(net.quads[q][k], net.quads[q][(k + 1) % 4])].push_back(to_index(q));
  }
  return edges;
}

std::optional<NetFault> find_fault(const QuadNet& net) {
  std::map<NetEdge, int> forward;
  for (const Quad& quad : net.quads) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Index from = quad[k];
      const Index to = quad[(k + 1) % 4];
      if (from < 0 || from >= net.n_vertices) return NetFault{"a vertex does not exist", {from}};
      if (std::ranges::count(quad, from) > 1)
        return NetFault{"a quadrilateral has a vertex twice", {from}};
      if (from < to) ++forward[{from, to}];
    }
  }
  const Surroundings around(net);
  for (const auto& [edge, quads] : around.edges) {
    if (quads.size() > 2)
      return NetFault{"an edge has more than two quadrilaterals", {edge.first, edge.second}};
    if (quads.size() == 2 && forward[edge] != 1)
      return NetFault{"neighbours look opposite ways", {edge.first, edge.second}};
  }
  for (Index v = 0; v < net.n_vertices; ++v) {
    if (around.quads[at(v)].empty()) return NetFault{"a vertex has no quadrilateral", {v}};
    const std::size_t n_border = around.on_border[at(v)].size();
    if (n_border != 0 && n_border != 2)
      return NetFault{"the border crosses itself at a vertex", {v}};
  }
  return std::nullopt;
}

void check_net(const QuadNet& net) {
  if (const auto fault = find_fault(net)) throw BugError("a net is no surface: " + fault->what);
}

std::vector<std::array<Index, 3>> cut_into_triangles(const QuadNet& net) {
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(2 * net.quads.size());
  for (const auto& [a, b, c, d] : net.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return triangles;
}

Refinement refine(const QuadNet& net) {
  const Surroundings around(net);
  std::map<NetEdge, Index> middle;
  Index next = net.n_vertices;
  for (const auto& [edge, quads] : around.edges)
    middle[edge] = next++;
  const Index first_centre = next;
  Refinement finer;
  finer.net.n_vertices = first_centre + to_index(net.quads.size());
  Rows rows(finer.net.n_vertices, net.n_vertices);
  for (Index v = 0; v < net.n_vertices; ++v)
    add_vertex_rule(net, around, v, rows);
  for (const auto& [edge, quads] : around.edges) {
    const Index m = middle[edge];
    const double own = quads.size() == 1 ? 0.5 : 0.25;
    rows.add(m, edge.first, own);
    rows.add(m, edge.second, own);
    if (quads.size() == 1) continue;
    for (const Index q : quads)
      rows.add_each(m, net.quads[at(q)], 0.0625);
  }
  for (std::size_t q = 0; q < net.quads.size(); ++q) {
    const Index centre = first_centre + to_index(q);
    const Quad& quad = net.quads[q];
    rows.add_each(centre, quad, 0.25);
    for (std::size_t k = 0; k < 4; ++k) {
      finer.net.quads.push_back({quad[k], middle[edge_of(quad[k], quad[(k + 1) % 4])], centre,
                                 middle[edge_of(quad[k], quad[(k + 3) % 4])]});
    }
  }
  finer.control = rows.made();
  return finer;
}

Weights limit_weights(const QuadNet& net) {
  const Surroundings around(net);
  Rows rows(net.n_vertices, net.n_vertices);
  for (Index v = 0; v < net.n_vertices; ++v) {
    if (is_corner(around, v)) {
      rows.add(v, v, 1.0);
    } else if (!around.on_border[at(v)].empty()) {
      rows.add(v, v, 4.0 / 6.0);
      rows.add_each(v, around.on_border[at(v)], 1.0 / 6.0);
    } else {
      const auto n = static_cast<double>(around.quads[at(v)].size());
      const double all = n * (n + 5.0);
      rows.add(v, v, n * n / all);
      rows.add_each(v, around.neighbours[at(v)], 4.0 / all);
      rows.add_each(v, around.opposite[at(v)], 1.0 / all);
    }
  }
  return rows.made();
}

LimitMesh limit_mesh(const QuadNet& net, int levels) {
  QuadNet fine = net;
  Weights control(net.n_vertices, net.n_vertices);
  control.setIdentity();
  for (int level = 0; level < levels; ++level) {
    Refinement finer = refine(fine);
    control = finer.control * control;
    fine = std::move(finer.net);
  }
  Weights limit = limit_weights(fine) * control;
  return {std::move(fine), std::move(limit)};
}

std::vector<Vec3> control_points_through(const QuadNet& net, std::span<const Vec3> points) {
  require(to_index(points.size()) == net.n_vertices, "points for another number of vertices");
  const Eigen::SparseMatrix<double> limit = limit_weights(net);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(limit);
  Eigen::MatrixXd target(net.n_vertices, 3);
  for (Index v = 0; v < net.n_vertices; ++v)
    target.row(v) = points[at(v)].transpose();
  const Eigen::MatrixXd solved = factor.solve(target);
  const bool found =
      factor.info() == Eigen::Success &&
      (limit * solved - target).cwiseAbs().maxCoeff() < 1e-9 * (1.0 + target.cwiseAbs().maxCoeff());
  require(found, "no control points give a surface through the points");
  std::vector<Vec3> control;
  for (Index v = 0; v < net.n_vertices; ++v)
    control.emplace_back(solved.row(v).transpose());
  return control;
}

std::vector<Vec3> weighted(const Weights& weights, std::span<const Vec3> values) {
  return applied<Vec3>(weights, values, Vec3::Zero());
}

std::vector<double> weighted(const Weights& weights, std::span<const double> values) {
  return applied<double>(weights, values, 0.0);
}

}  // namespace facies::mesh
