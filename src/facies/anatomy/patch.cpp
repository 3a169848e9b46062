// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "facies/anatomy/skin_axes.hpp"
#include "facies/base/text.hpp"
#include "facies/base/text_file.hpp"
#include "facies/mesh/layered_sheet.hpp"

namespace facies::anatomy {
namespace {

using mesh::SheetCells;
using mesh::SheetOptions;
using mesh::SheetShape;

struct PatchOptions {
  double width = 40.0;          // [mm]
  double height = 40.0;         // [mm]
  double skin = 1.5;            // thickness [mm]
  double fat = 10.0;            // thickness [mm]
  double radius = 80.0;         // of the outer surface of a curved patch [mm]
  double skin_direction = 0.0;  // of a1, from horizontal towards up [degrees]
  int ny = 8;
  int nz = 8;
  int skin_layers = 1;
  int fat_layers = 1;  // elements over each half of the fat
  SheetShape shape = SheetShape::flat;
  SheetCells wedges = SheetCells::hexahedra;
};

template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

const Choices<SheetShape>& shapes() {
  static const Choices<SheetShape> choices{{"flat", SheetShape::flat},
                                           {"cylinder", SheetShape::cylinder},
                                           {"sphere", SheetShape::sphere}};
  return choices;
}

const Choices<SheetCells>& wedge_patterns() {
  static const Choices<SheetCells> choices{{"none", SheetCells::hexahedra},
                                           {"all", SheetCells::wedges},
                                           {"checkerboard", SheetCells::checkerboard},
                                           {"right", SheetCells::right_half_wedges}};
  return choices;
}

template <class T>
std::vector<std::string> words(const Choices<T>& choices) {
  std::vector<std::string> result;
  for (const auto& [word, value] : choices)
    result.push_back(word);
  return result;
}

template <class T>
std::string word_of(const Choices<T>& choices, T value) {
  return std::ranges::find(choices, value, &std::pair<std::string, T>::second)->first;
}

struct RealOption {
  const char* key;
  double PatchOptions::*member;
  double lowest, highest;
};

struct CountOption {
  const char* key;
  int PatchOptions::*member;
  int lowest, highest;
};

constexpr std::array<RealOption, 6> reals{
    {{"width", &PatchOptions::width, 1.0, 1000.0},
     {"height", &PatchOptions::height, 1.0, 1000.0},
     {"skin", &PatchOptions::skin, 0.01, 100.0},
     {"fat", &PatchOptions::fat, 0.01, 100.0},
     {"radius", &PatchOptions::radius, 1.0, 1e5},
     {"skin_direction", &PatchOptions::skin_direction, -360.0, 360.0}}};
/// A quarter of the columns lies on either side of the muscles: four are the fewest.
constexpr std::array<CountOption, 4> counts{{{"ny", &PatchOptions::ny, 4, 400},
                                             {"nz", &PatchOptions::nz, 4, 400},
                                             {"skin_layers", &PatchOptions::skin_layers, 1, 20},
                                             {"fat_layers", &PatchOptions::fat_layers, 1, 20}}};

std::vector<std::string> keys() {
  std::vector<std::string> result{"shape", "wedges"};
  std::ranges::transform(reals, std::back_inserter(result), &RealOption::key);
  std::ranges::transform(counts, std::back_inserter(result), &CountOption::key);
  return result;
}

template <class T>
void set_choice(const std::string& where, std::string_view text, const Choices<T>& choices,
                T& value, Problems& problems) {
  for (const auto& [word, choice] : choices) {
    if (word != text) continue;
    value = choice;
    return;
  }
  problems.add({where, excerpt(text), "", did_you_mean(text, words(choices))});
}

/// Sets the option of numbers that `key` names.
void set_number(PatchOptions& options, std::string_view key, const std::string& where,
                std::string_view text, Problems& problems) {
  for (const RealOption& option : reals) {
    if (key != option.key) continue;
    const std::optional<double> value = parse_number(text);
    if (value && *value >= option.lowest && *value <= option.highest) {
      options.*option.member = *value;
    } else {
      problems.add({where, excerpt(text),
                    fmt::format("a number from {} to {}", option.lowest, option.highest), ""});
    }
    return;
  }
  for (const CountOption& option : counts) {
    if (key != option.key) continue;
    const std::optional<long> value = parse_integer(text);
    if (value && *value >= option.lowest && *value <= option.highest) {
      options.*option.member = static_cast<int>(*value);
    } else {
      problems.add({where, excerpt(text),
                    fmt::format("a whole number from {} to {}", option.lowest, option.highest),
                    ""});
    }
    return;
  }
}

PatchOptions parse(const std::string& text) {
  PatchOptions options;
  Problems problems;
  std::vector<std::string> seen;
  for (const std::string_view item :
       text.empty() ? std::vector<std::string_view>{} : split(text, ',')) {
    const std::size_t equals = item.find('=');
    const std::string key(trim(item.substr(0, equals)));
    const std::string where = "patch:" + key;
    if (std::ranges::find(seen, key) != seen.end()) {
      problems.add({where, "given twice", "each option once", ""});
    }
    seen.push_back(key);
    const std::vector<std::string> known = keys();
    if (std::ranges::find(known, key) == known.end()) {
      problems.add({where, "unknown option", "", did_you_mean(key, known)});
      continue;
    }
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view{} : trim(item.substr(equals + 1));
    if (key == "shape") {
      set_choice(where, value, shapes(), options.shape, problems);
    } else if (key == "wedges") {
      set_choice(where, value, wedge_patterns(), options.wedges, problems);
    } else {
      set_number(options, key, where, value, problems);
    }
  }
  problems.throw_if_any<UsageError>();
  return options;
}

mesh::Mesh make_mesh(const PatchOptions& options) {
  SheetOptions sheet;
  sheet.size_y = options.width;
  sheet.size_z = options.height;
  sheet.n_y = options.ny;
  sheet.n_z = options.nz;
  sheet.layers = {{layer_names()[0], options.skin, options.skin_layers},
                  {layer_names()[1], 0.5 * options.fat, options.fat_layers},
                  {layer_names()[2], 0.5 * options.fat, options.fat_layers}};
  sheet.shape = options.shape;
  sheet.radius = options.radius;
  sheet.cells = options.wedges;
  try {
    return mesh::make_layered_sheet(sheet);
  } catch (const DataError& error) {
    throw UsageError(error.problems());
  }
}

/// Node `j` along y and `k` along z of node layer `depth` (numbering of mesh::make_layered_sheet).
Index node(const PatchOptions& options, int depth, int j, int k) {
  return (depth * (options.ny + 1) + j) * (options.nz + 1) + k;
}

MusclePaths make_strip(const PatchOptions& options, const mesh::Mesh& mesh) {
  const int depth = options.skin_layers + options.fat_layers;
  const int margin = options.nz / 8;
  FibrePath left{Side::left, false, {}};
  FibrePath right{Side::right, false, {}};
  for (int k = margin; k <= options.nz - margin; ++k) {
    const int j = options.ny / 4;
    left.points.push_back(mesh.X()[at(node(options, depth, j, k))]);
    right.points.push_back(mesh.X()[at(node(options, depth, options.ny - j, k))]);
  }
  return {"STRIP", "strip across the patch", {std::move(left), std::move(right)}};
}

}  // namespace

std::string patch_usage() {
  const PatchOptions defaults;
  std::string usage = "patch:";
  for (const RealOption& option : reals)
    usage += fmt::format("{}={},", option.key, defaults.*option.member);
  for (const CountOption& option : counts)
    usage += fmt::format("{}={},", option.key, defaults.*option.member);
  return usage + fmt::format("shape={},wedges={}", word_of(shapes(), defaults.shape),
                             word_of(wedge_patterns(), defaults.wedges));
}

FaceAnatomy make_patch(const std::string& text) {
  const PatchOptions options = parse(text);
  FaceAnatomy face;
  face.source = text.empty() ? "patch" : "patch:" + text;
  face.mesh = make_mesh(options);

  std::vector<Index> held(face.mesh.nodes("inner").begin(), face.mesh.nodes("inner").end());
  held.insert(held.end(), face.mesh.nodes("rim").begin(), face.mesh.nodes("rim").end());
  face.mesh.set_nodes("held_in_tension", std::move(held));

  const double angle = options.skin_direction * std::numbers::pi / 180.0;
  const std::vector<Vec3> directions(face.mesh.n_elements(),
                                     Vec3(0.0, std::cos(angle), std::sin(angle)));
  const std::size_t n_guessed = set_skin_axes(face, directions);
  if (n_guessed > 0) {
    face.notes.push_back(fmt::format(
        "{} skin elements stand across the skin direction: horizontal instead", n_guessed));
  }
  face.muscle_paths.push_back(make_strip(options, face.mesh));
  const int middle = options.nz / 2;
  const int quarter = options.ny / 4;
  face.landmarks = {
      {"CENTER", "middle of the patch", node(options, 0, options.ny / 2, middle), false},
      {"LEFT", "in front of the left muscle", node(options, 0, quarter, middle), false},
      {"RIGHT", "in front of the right muscle", node(options, 0, options.ny - quarter, middle),
       false}};
  face.pairs = {{"LEFT", "RIGHT"}, {"CENTER", "RIGHT"}};
  return face;
}

}  // namespace facies::anatomy
