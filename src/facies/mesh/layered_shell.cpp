// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/layered_shell.hpp"

#include <algorithm>
#include <numeric>

#include "facies/mesh/shell_corners.hpp"

namespace facies::mesh {
namespace {

/// Local numbers of a hexahedron's faces (cells.hpp).
constexpr std::uint8_t inward_face = 0;
constexpr std::uint8_t outward_face = 1;

void check(const Shell& shell, const std::vector<ShellLayer>& layers) {
  check_net(shell.net);
  const std::size_t n = at(shell.net.n_vertices);
  require(shell.outer.size() == n && shell.inner.size() == n, "a shell needs two points a vertex");
  int n_deep = 0;
  for (const ShellLayer& layer : layers) {
    require(layer.n_elements > 0, "a shell's layer needs elements");
    n_deep += layer.n_elements;
  }
  require(shell.parts.size() == static_cast<std::size_t>(n_deep) + 1,
          "a shell needs one node layer more than element layers");
  for (const std::vector<double>& parts : shell.parts)
    require(parts.size() == n, "a shell's node layer needs a part for every vertex");
}

std::vector<Index> numbers(Index first, std::size_t n) {
  std::vector<Index> all(n);
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// The face of element `e` that has both nodes and is neither its outward nor its inward one.
Face side_face(const Mesh& mesh, Index e, Index a, Index b) {
  for (std::uint8_t local = outward_face + 1; local < 6; ++local) {
    const std::vector<Index> nodes = mesh.face_nodes({e, local});
    const auto has = [&](Index node) { return std::ranges::find(nodes, node) != nodes.end(); };
    if (has(a) && has(b)) return {e, local};
  }
  throw BugError("a hexahedron has no side with these nodes");
}

std::vector<Face> border_faces(const Mesh& mesh, const QuadNet& net, int n_deep) {
  std::vector<Face> faces;
  for (const auto& [edge, quads] : edges_of(net)) {
    if (quads.size() != 1) continue;
    for (int depth = 0; depth < n_deep; ++depth) {
      const Index e = depth * to_index(net.quads.size()) + quads.front();
      faces.push_back(side_face(mesh, e, shell_node(net, edge.first, depth),
                                shell_node(net, edge.second, depth)));
    }
  }
  return faces;
}

}  // namespace

Mesh make_layered_shell(const Shell& shell, const std::vector<ShellLayer>& layers) {
  check(shell, layers);
  const QuadNet& net = shell.net;
  const int n_deep = static_cast<int>(shell.parts.size()) - 1;
  std::vector<Vec3> X;
  for (const std::vector<double>& parts : shell.parts) {
    for (std::size_t v = 0; v < parts.size(); ++v)
      X.emplace_back(shell.outer[v] + parts[v] * (shell.inner[v] - shell.outer[v]));
  }
  std::vector<Element> elements;
  for (int depth = 0; depth < n_deep; ++depth) {
    for (const auto& quad : net.quads) {
      Element& element = elements.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        element.nodes.at(k) = shell_node(net, quad.at(k), depth + 1);
        element.nodes.at(4 + k) = shell_node(net, quad.at(k), depth);
      }
    }
  }
  Mesh mesh(std::move(X), std::move(elements));
  const std::size_t n_quads = net.quads.size();
  Index next = 0;
  for (const ShellLayer& layer : layers) {
    const std::size_t n = n_quads * static_cast<std::size_t>(layer.n_elements);
    mesh.set_elements(layer.name, numbers(next, n));
    next += to_index(n);
  }
  std::vector<Face> outer;
  std::vector<Face> inner;
  for (std::size_t q = 0; q < n_quads; ++q) {
    outer.push_back({to_index(q), outward_face});
    inner.push_back({(n_deep - 1) * to_index(n_quads) + to_index(q), inward_face});
  }
  std::vector<Face> border = border_faces(mesh, net, n_deep);
  std::vector<Index> on_border;
  for (const Face& face : border) {
    for (const Index node : mesh.face_nodes(face))
      on_border.push_back(node);
  }
  mesh.set_faces("outer", std::move(outer));
  mesh.set_faces("inner", std::move(inner));
  mesh.set_faces("border", std::move(border));
  mesh.set_nodes("outer", numbers(0, at(net.n_vertices)));
  mesh.set_nodes("inner", numbers(shell_node(net, 0, n_deep), at(net.n_vertices)));
  mesh.set_nodes("border", std::move(on_border));
  return mesh;
}

WorstCorner worst_corner(const Shell& shell) {
  WorstCorner worst;
  for_each_corner(shell, [&](const ShellCorner& corner) {
    const double found = scaled_jacobian(corner);
    if (found >= worst.scaled_jacobian) return;
    worst = {found, corner.quad, corner.layer};
  });
  return worst;
}

}  // namespace facies::mesh
