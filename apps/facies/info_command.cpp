// SPDX-License-Identifier: Apache-2.0
// facies info: what is in a face.
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/anatomy/sources.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/scenario.hpp"

namespace facies::cli {

namespace {

struct InfoCommand {
  std::string face = scenario::Scenario{}.face;
};

void print_mesh(const mesh::QualityReport& report) {
  std::cout << fmt::format("{} nodes, {} elements: {} hexahedra, {} wedges\n", report.n_nodes,
                           report.n_hex + report.n_wedge, report.n_hex, report.n_wedge);
  const Vec3 size = report.upper - report.lower;
  std::cout << fmt::format("size {:.1f} x {:.1f} x {:.1f} mm, volume {:.1f} cm^3\n", size.x(),
                           size.y(), size.z(), report.volume / 1000.0);
  if (report.worst.empty()) return;
  const auto& worst = report.elements[at(report.worst.front())];
  std::cout << fmt::format(
      "smallest scaled Jacobian {:.3f} (element {}); elements inverted at a node: {}\n",
      worst.scaled_jacobian_gauss, report.worst.front(), report.inverted_corners.size());
}

void print_layers(const mesh::QualityReport& report) {
  std::cout << fmt::format("\n{:<20} {:>9} {:>13} {:>16} {:>22}\n", "layer", "elements",
                           "volume [cm^3]", "thickness [mm]", "5 to 95 % of it [mm]");
  for (const std::string& layer : anatomy::layer_names()) {
    const auto found = report.sets.find(layer);
    if (found == report.sets.end()) continue;
    const mesh::ElementSetQuality& set = found->second;
    const auto mean = set.mean_thickness ? fmt::format("{:.2f}", *set.mean_thickness) : "";
    const auto range = set.thickness
                           ? fmt::format("{:.2f} to {:.2f}", set.thickness->p05, set.thickness->p95)
                           : "";
    std::cout << fmt::format("{:<20} {:>9} {:>13.1f} {:>16} {:>22}\n", layer, set.n_elements,
                             set.volume / 1000.0, mean, range);
  }
}

void print_muscles(const anatomy::FaceAnatomy& face) {
  const double radius = scenario::Scenario{}.muscle.radius;
  const double tsf = scenario::TensionStep{}.tsf;
  std::cout << fmt::format(
      "\nmuscles: elements within {:g} mm of a fibre at the stress-free size (TSF {:g})\n", radius,
      tsf);
  for (const anatomy::Muscle& muscle : anatomy::select_muscles(face, radius, tsf)) {
    std::string meaning;
    for (const anatomy::MusclePaths& paths : face.muscle_paths) {
      if (paths.name == muscle.group) meaning = paths.meaning;
    }
    std::cout << fmt::format("{:<10} {:>6}   {}\n", muscle.name, muscle.elements.size(), meaning);
  }
}

void print_landmarks(const anatomy::FaceAnatomy& face) {
  std::cout << fmt::format("\n{:<10} {:>6} {:>9} {:>9} {:>9}   meaning\n", "landmark", "node",
                           "x [mm]", "y [mm]", "z [mm]");
  for (const anatomy::Landmark& landmark : face.landmarks) {
    const Vec3& X = face.mesh.X()[at(landmark.node)];
    std::cout << fmt::format("{:<10} {:>6} {:>9.2f} {:>9.2f} {:>9.2f}   {}\n", landmark.name,
                             landmark.node, X.x(), X.y(), X.z(), landmark.meaning);
  }
}

void print_sets(const mesh::Mesh& mesh) {
  std::cout << "\nnode sets:";
  for (const auto& [name, nodes] : mesh.node_sets())
    std::cout << fmt::format(" {} {}", name, nodes.size());
  std::cout << '\n';
}

int carry_out(const InfoCommand& command) {
  const anatomy::FaceAnatomy face = anatomy::load_face(command.face, scenario::data_folder());
  const mesh::QualityReport report = mesh::quality(face.mesh, face.mesh.X());
  std::cout << face.source << '\n';
  print_mesh(report);
  for (const std::string& note : face.notes)
    std::cout << "note: " << note << '\n';
  print_layers(report);
  print_sets(face.mesh);
  print_muscles(face);
  print_landmarks(face);
  return exit_status::done;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  auto command = std::make_shared<InfoCommand>();
  CLI::App* sub =
      app.add_subcommand("info",
                         "Print what is in a face: counts, layers, quality, muscles, "
                         "landmarks. Node and element numbers count from 0, as in the results.\n\n"
                         "Examples:\n"
                         "  facies info --face artisynth:DIR\n"
                         "  facies info --face patch\n");
  sub->add_option("--face", command->face, "whose face (facies list faces)")
      ->type_name("SPEC")
      ->capture_default_str();
  sub->callback([command, &action] { action = [command] { return carry_out(*command); }; });
}

}  // namespace facies::cli
