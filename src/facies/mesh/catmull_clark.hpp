// SPDX-License-Identifier: Apache-2.0
// Smooth surfaces over nets of quadrilaterals (catmull1978). Everything is linear in the control points: what depends on how
// the net hangs together is worked out once and applied to any values on its vertices.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include "facies/base/index.hpp"
#include "facies/math/tensor.hpp"

namespace facies::mesh {

/// How quadrilaterals hang together: vertices 0 to n_vertices - 1, each quadrilateral counter-clockwise seen from outside.
/// Every edge belongs to one quadrilateral (border) or two, which run along it opposite ways.
struct QuadNet {
  Index n_vertices = 0;
  std::vector<std::array<Index, 4>> quads;
};

/// Two vertices that a quadrilateral has next to each other, the smaller number first.
using NetEdge = std::pair<Index, Index>;
[[nodiscard]] NetEdge edge_of(Index a, Index b);

/// The quadrilaterals along each edge, ascending. Vertices need not exist.
[[nodiscard]] std::map<NetEdge, std::vector<Index>> edges_of(const QuadNet& net);

/// What keeps a net from being a surface.
struct NetFault {
  std::string what;             ///< "an edge has more than two quadrilaterals"
  std::vector<Index> vertices;  ///< where
};
/// The first thing for which a net is not what QuadNet says: a vertex that does not exist, one twice in a quadrilateral, one
/// without a quadrilateral or with border edges that are not two (or none), an edge with more than two quadrilaterals or with
/// two that look opposite ways.
[[nodiscard]] std::optional<NetFault> find_fault(const QuadNet& net);

/// Throws BugError for a net with a fault.
void check_net(const QuadNet& net);

/// Two triangles for each quadrilateral, in its order, cut from its first vertex to its third.
[[nodiscard]] std::vector<std::array<Index, 3>> cut_into_triangles(const QuadNet& net);

/// Each row says how the values of many vertices make one: [n_to x n_from]; the entries of a row add up to 1.
using Weights = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The net after every quadrilateral has become four.
struct Refinement {
  QuadNet net;      ///< its first vertices are those of the net before, in their order
  Weights control;  ///< its control points from those of the net before
};
[[nodiscard]] Refinement refine(const QuadNet& net);

/// Where the smooth surface is at the net's vertices, from its control points. Borders are cubic B-splines that depend on
/// border vertices alone; a vertex with one quadrilateral is a corner and stays.
[[nodiscard]] Weights limit_weights(const QuadNet& net);

/// The smooth surface at all vertices of the net refined `levels` times, from the control points of the net itself.
struct LimitMesh {
  QuadNet net;
  Weights limit;  ///< [net.n_vertices x n_vertices before]
};
[[nodiscard]] LimitMesh limit_mesh(const QuadNet& net, int levels);

/// Control points whose smooth surface passes through these points at the vertices [n_vertices] (halstead1993). Throws BugError where there
/// are none: on the surface of a cube every second vertex may go out and every other in without moving the smooth surface.
[[nodiscard]] std::vector<Vec3> control_points_through(const QuadNet& net,
                                                       std::span<const Vec3> points);

/// The weights applied. Throws BugError where sizes differ.
[[nodiscard]] std::vector<Vec3> weighted(const Weights& weights, std::span<const Vec3> values);
[[nodiscard]] std::vector<double> weighted(const Weights& weights, std::span<const double> values);

}  // namespace facies::mesh
