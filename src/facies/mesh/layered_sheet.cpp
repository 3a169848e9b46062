// SPDX-License-Identifier: Apache-2.0
#include "facies/mesh/layered_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace facies::mesh {
namespace {

constexpr int max_count = 10'000;
constexpr double max_elements = 5e6;
constexpr double max_length = 1e6;  // [mm]

void check_length(const std::string& option, double value, Problems& problems) {
  if (!(value > 0.0 && value <= max_length)) {
    problems.add({"layered sheet: " + option, fmt::format("{} mm", value),
                  fmt::format("a length above 0, at most {} mm", max_length), ""});
  }
}

void check_count(const std::string& option, int value, Problems& problems) {
  if (value < 1 || value > max_count) {
    problems.add({"layered sheet: " + option, fmt::format("{}", value),
                  fmt::format("a number of elements from 1 to {}", max_count), ""});
  }
}

void check_layers(const std::vector<SheetLayer>& layers, Problems& problems) {
  if (layers.empty()) problems.add({"layered sheet: layers", "none", "at least one layer", ""});
  std::set<std::string> names;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string where = fmt::format("layer {} '{}'", i + 1, layers[i].name);
    if (layers[i].name.empty()) {
      problems.add({"layered sheet: " + where, "no name", "the name of its element set", ""});
    } else if (!names.insert(layers[i].name).second) {
      problems.add({"layered sheet: " + where, "a name used before", "one name per layer", ""});
    }
    check_length(where + " thickness", layers[i].thickness, problems);
    check_count(where + " n_elements", layers[i].n_elements, problems);
  }
}

double total_thickness(const SheetOptions& options) {
  double sum = 0.0;
  for (const SheetLayer& layer : options.layers)
    sum += layer.thickness;
  return sum;
}

/// Half the angle that a curved sheet may span: beyond it columns meet or cells degenerate.
double max_half_angle(SheetShape shape) {
  return shape == SheetShape::cylinder ? std::numbers::pi / 2.0 : std::numbers::pi / 3.0;
}

void check_curvature(const SheetOptions& options, Problems& problems) {
  if (options.shape == SheetShape::flat) return;
  check_length("radius", options.radius, problems);
  if (!(options.radius > total_thickness(options))) {
    problems.add(
        {"layered sheet: radius", fmt::format("{} mm", options.radius),
         fmt::format("more than the thickness of all layers, {} mm", total_thickness(options)),
         ""});
  }
  const double largest = 2.0 * options.radius * max_half_angle(options.shape);
  const double size = options.shape == SheetShape::sphere ? std::max(options.size_y, options.size_z)
                                                          : options.size_y;
  if (size > largest) {
    problems.add(
        {"layered sheet: size", fmt::format("{} mm on a radius of {} mm", size, options.radius),
         fmt::format("at most {:.6g} mm", largest), "make the sheet smaller or the radius larger"});
  }
}

void check(const SheetOptions& options) {
  Problems problems;
  check_length("size_y", options.size_y, problems);
  check_length("size_z", options.size_z, problems);
  check_count("n_y", options.n_y, problems);
  check_count("n_z", options.n_z, problems);
  check_layers(options.layers, problems);
  check_curvature(options, problems);
  double n = double(options.n_y) * double(options.n_z);
  double n_depth = 0.0;
  for (const SheetLayer& layer : options.layers)
    n_depth += layer.n_elements;
  n *= 2.0 * n_depth;
  if (problems.empty() && n > max_elements) {
    problems.add({"layered sheet", fmt::format("up to {} elements", n),
                  fmt::format("at most {}", max_elements), "lower n_y, n_z or n_elements"});
  }
  problems.throw_if_any<DataError>();
}

/// Depths of the node layers below the outer surface [mm], from 0 on.
std::vector<double> node_depths(const SheetOptions& options) {
  std::vector<double> depths{0.0};
  for (const SheetLayer& layer : options.layers) {
    const double top = depths.back();
    for (int i = 1; i <= layer.n_elements; ++i) {
      depths.push_back(top + layer.thickness * i / layer.n_elements);
    }
  }
  return depths;
}

/// The point at (y, z) of the outer surface, moved inwards by `depth`.
Vec3 position(const SheetOptions& options, double depth, double y, double z) {
  const double R = options.radius;
  const double r = R - depth;
  switch (options.shape) {
    case SheetShape::cylinder:
      return {R - r * std::cos(y / R), r * std::sin(y / R), z};
    case SheetShape::sphere:
      return Vec3(R, 0.0, 0.0) + r * Vec3(-1.0, std::tan(y / R), std::tan(z / R)).normalized();
    case SheetShape::flat:
      break;
  }
  return {depth, y, z};
}

class SheetBuilder {
 public:
  explicit SheetBuilder(const SheetOptions& options)
      : options_(options), depths_(node_depths(options)) {}

  Mesh build() {
    Mesh mesh(positions(), elements());
    Index next = 0;
    for (const SheetLayer& layer : options_.layers) {
      const Index n = per_layer_ * layer.n_elements;
      mesh.set_elements(layer.name, range(next, n));
      next += n;
    }
    std::vector<Face> outer;
    std::vector<Face> inner;
    for (Index e = 0; e < per_layer_; ++e) {
      outer.push_back({e, 1});
      inner.push_back({next - per_layer_ + e, 0});
    }
    mesh.set_faces("outer", outer);
    mesh.set_faces("inner", inner);
    set_nodes(mesh);
    return mesh;
  }

 private:
  static std::vector<Index> range(Index first, Index count) {
    std::vector<Index> numbers(at(count));
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
  }

  [[nodiscard]] Index node(int depth, int j, int k) const {
    return (depth * (options_.n_y + 1) + j) * (options_.n_z + 1) + k;
  }

  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> X;
    for (const double depth : depths_) {
      for (int j = 0; j <= options_.n_y; ++j) {
        const double y = options_.size_y * (double(j) / options_.n_y - 0.5);
        for (int k = 0; k <= options_.n_z; ++k) {
          const double z = options_.size_z * (double(k) / options_.n_z - 0.5);
          X.push_back(position(options_, depth, y, z));
        }
      }
    }
    return X;
  }

  [[nodiscard]] bool is_cut(int j, int k) const {
    switch (options_.cells) {
      case SheetCells::hexahedra:
        return false;
      case SheetCells::wedges:
        return true;
      case SheetCells::checkerboard:
        return (j + k) % 2 == 1;
      case SheetCells::right_half_wedges:
        return 2 * j + 1 > options_.n_y;
    }
    return false;
  }

  std::vector<Element> elements() {
    std::vector<Element> elements;
    for (int depth = 0; depth + 1 < int(depths_.size()); ++depth) {
      for (int j = 0; j < options_.n_y; ++j) {
        for (int k = 0; k < options_.n_z; ++k)
          add_column_cell(depth, j, k, elements);
      }
      if (depth == 0) per_layer_ = to_index(elements.size());
    }
    return elements;
  }

  void add_column_cell(int depth, int j, int k, std::vector<Element>& elements) const {
    // z before y: counter-clockwise for someone in front of the face, who looks along +x.
    const std::array<std::array<int, 2>, 4> corners{
        {{j, k}, {j, k + 1}, {j + 1, k + 1}, {j + 1, k}}};
    std::array<Index, 4> in{};
    std::array<Index, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) {
      in[i] = node(depth + 1, corners[i][0], corners[i][1]);
      out[i] = node(depth, corners[i][0], corners[i][1]);
    }
    if (!is_cut(j, k)) {
      elements.push_back(
          {CellType::hex8, {in[0], in[1], in[2], in[3], out[0], out[1], out[2], out[3]}});
      return;
    }
    elements.push_back({CellType::wedge6, {in[0], in[1], in[2], out[0], out[1], out[2], -1, -1}});
    elements.push_back({CellType::wedge6, {in[0], in[2], in[3], out[0], out[2], out[3], -1, -1}});
  }

  void set_nodes(Mesh& mesh) const {
    const Index per_surface = (options_.n_y + 1) * (options_.n_z + 1);
    const int last = int(depths_.size()) - 1;
    std::array<std::vector<Index>, 4> sides;
    for (int depth = 0; depth <= last; ++depth) {
      for (int k = 0; k <= options_.n_z; ++k) {
        sides[0].push_back(node(depth, 0, k));
        sides[1].push_back(node(depth, options_.n_y, k));
      }
      for (int j = 0; j <= options_.n_y; ++j) {
        sides[2].push_back(node(depth, j, 0));
        sides[3].push_back(node(depth, j, options_.n_z));
      }
    }
    std::vector<Index> rim;
    for (const std::vector<Index>& side : sides)
      rim.insert(rim.end(), side.begin(), side.end());
    mesh.set_nodes("outer", range(0, per_surface));
    mesh.set_nodes("inner", range(last * per_surface, per_surface));
    mesh.set_nodes("y_min", sides[0]);
    mesh.set_nodes("y_max", sides[1]);
    mesh.set_nodes("z_min", sides[2]);
    mesh.set_nodes("z_max", sides[3]);
    mesh.set_nodes("rim", rim);
  }

  const SheetOptions& options_;
  std::vector<double> depths_;
  Index per_layer_ = 0;
};

}  // namespace

Mesh make_layered_sheet(const SheetOptions& options) {
  check(options);
  return SheetBuilder(options).build();
}

}  // namespace facies::mesh
