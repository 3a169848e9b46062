// SPDX-License-Identifier: Apache-2.0
// facies info: what is in a face.
#include <algorithm>
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "facies/anatomy/sources.hpp"
#include "facies/base/parallel.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/results/atlas.hpp"
#include "facies/results/folder.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/scenario.hpp"
#include "facies/scenario/subject.hpp"

namespace facies::cli {

namespace {

struct InfoCommand {
  std::string face = scenario::Scenario{}.face;
  std::string out;
  bool force = false;
};

/// The muscles as a scenario that says nothing about them has them.
std::vector<anatomy::Muscle> muscles_of(const anatomy::FaceAnatomy& face) {
  const scenario::MuscleChoice choice;
  return anatomy::select_muscles(face, {choice.radius, choice.margin}, scenario::TensionStep{}.tsf);
}

void print_mesh(const mesh::QualityReport& report) {
  std::cout << fmt::format("{} nodes, {} elements: {} hexahedra, {} wedges\n", report.n_nodes,
                           report.n_hex + report.n_wedge, report.n_hex, report.n_wedge);
  const Vec3 size = report.upper - report.lower;
  std::cout << fmt::format("size {:.1f} x {:.1f} x {:.1f} mm, volume {:.1f} cm^3\n", size.x(),
                           size.y(), size.z(), report.volume / 1000.0);
  if (report.worst.empty()) return;
  const auto& worst = report.elements[at(report.worst.front())];
  const auto corner =
      std::ranges::min_element(report.elements, {}, &mesh::ElementQuality::scaled_jacobian_corner);
  std::cout << fmt::format(
      "smallest scaled Jacobian {:.3f} (element {}), at a node {:.3f} (element {}); elements "
      "inverted at a node: {}\n",
      worst.scaled_jacobian_gauss, report.worst.front(), corner->scaled_jacobian_corner,
      corner - report.elements.begin(), report.inverted_corners.size());
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

void print_muscles(const anatomy::FaceAnatomy& face, std::span<const anatomy::Muscle> muscles) {
  const scenario::MuscleChoice choice;
  if (std::ranges::all_of(face.muscle_paths, &anatomy::MusclePaths::is_band)) {
    std::cout << fmt::format(
        "\nmuscles: elements in bands along their fibres, width x thickness [mm] and {:g} mm "
        "around\n",
        choice.margin);
  } else {
    std::cout << fmt::format(
        "\nmuscles: elements within {:g} mm of a fibre at the stress-free size (TSF {:g})\n",
        choice.radius, scenario::TensionStep{}.tsf);
  }
  for (const anatomy::Muscle& muscle : muscles) {
    const auto paths =
        std::ranges::find(face.muscle_paths, muscle.group, &anatomy::MusclePaths::name);
    const std::string band =
        paths->is_band() ? fmt::format("{:>5g} x {:<4g}", paths->width, paths->thickness) : "";
    std::cout << fmt::format("{:<10} {:>6} {}  {}\n", muscle.name, muscle.elements.size(), band,
                             paths->meaning);
  }
}

/// Lengths that the face was made to have, for those who know how to change them.
void print_lengths(const anatomy::FaceAnatomy& face) {
  if (face.lengths.empty()) return;
  std::cout << fmt::format("\n{:<28} {:>10} {:>9} {:>15}   meaning\n", "length", "asked [mm]",
                           "face [mm]", "range [mm]");
  for (const anatomy::FaceLength& length : face.lengths) {
    std::cout << fmt::format(
        "{:<28} {:>10} {:>9.2f} {:>15}   {}\n", length.key,
        length.wanted ? fmt::format("{:.2f}", *length.wanted) : "", length.found,
        fmt::format("{:g} to {:g}", length.smallest, length.largest), length.meaning);
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

void draw(const anatomy::FaceAnatomy& face, std::span<const anatomy::Muscle> muscles,
          const std::string& out) {
  const results::PictureOptions options{
      .title = "", .subject = face.source, .threads = available_threads()};
  const auto names = write_atlas(scenario::subject_of(face, muscles, nullptr), out, options);
  std::cout << fmt::format("\npictures in {}: {}\n", out, fmt::join(names, " "));
}

int carry_out(const InfoCommand& command) {
  const anatomy::FaceAnatomy face = anatomy::load_face(command.face, scenario::data_folder());
  const std::vector<anatomy::Muscle> muscles = muscles_of(face);
  if (!command.out.empty()) results::prepare_picture_folder(command.out, command.force);
  const mesh::QualityReport report = mesh::quality(face.mesh, face.mesh.X());
  std::cout << face.source << '\n';
  print_mesh(report);
  for (const std::string& note : face.notes)
    std::cout << "note: " << note << '\n';
  print_layers(report);
  print_sets(face.mesh);
  print_muscles(face, muscles);
  print_lengths(face);
  print_landmarks(face);
  if (!command.out.empty()) draw(face, muscles, command.out);
  return exit_status::done;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  auto command = std::make_shared<InfoCommand>();
  CLI::App* sub = app.add_subcommand(
      "info",
      "Print what is in a face: counts, layers, quality, muscles, "
      "landmarks; draw its anatomy. Node and element numbers count from 0, as in "
      "the results.\n\n"
      "Examples:\n"
      "  facies info --face builtin --out out/face\n"
      "  facies info --face 'builtin:size=coarse,mouth_width=56 mm'\n"
      "  facies info --face artisynth:DIR\n");
  sub->add_option("--face", command->face, "whose face: facies list faces, facies list measures")
      ->type_name("SPEC")
      ->capture_default_str();
  CLI::Option* out = sub->add_option("--out", command->out, "folder for pictures of the anatomy")
                         ->type_name("DIR");
  sub->add_flag("--force", command->force, "replace the pictures that are there")->needs(out);
  sub->callback([command, &action] { action = [command] { return carry_out(*command); }; });
}

}  // namespace facies::cli
