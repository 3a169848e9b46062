// SPDX-License-Identifier: Apache-2.0
#include "facies/results/anatomy_pictures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/files.hpp"
#include "facies/results/palette.hpp"

namespace facies::results {

namespace {

/// One row of views; each with its own scale bar where they differ in scale.
std::vector<Panel> panels_of(std::vector<Image> images, std::span<const View> views,
                             bool scales_differ) {
  std::vector<Panel> row;
  for (std::size_t v = 0; v < views.size(); ++v)
    row.push_back({std::move(images[v]),
                   views[v].name,
                   {},
                   scales_differ ? views[v].camera.mm_per_pixel : 0.0});
  return row;
}

}  // namespace

std::vector<LegendEntry> section_legend(const Subject& subject) {
  std::vector<LegendEntry> legend;
  for (std::size_t layer = 0; layer < subject.layers.size(); ++layer) {
    std::string name = subject.layers[layer];
    std::ranges::replace(name, '_', ' ');
    legend.push_back({layer_colour(layer), std::move(name)});
  }
  if (!subject.bones.empty()) legend.push_back({palette::cut_bone, "bone and teeth"});
  return legend;
}

std::vector<std::string> write_anatomy_pictures(const Subject& subject,
                                                std::span<const Snapshot> snapshots,
                                                const std::filesystem::path& folder,
                                                const PictureOptions& options) {
  std::vector<const std::vector<Vec3>*> states;
  for (const Snapshot& snapshot : snapshots)
    states.push_back(&snapshot.state.u);
  const std::vector<View> views = standard_views(*subject.mesh, states, options.height);
  const std::vector<View> cuts = section_views(*subject.mesh, states, options.height);
  const Stage stage(subject, options.threads);
  std::vector<std::string> names;
  const auto write = [&](const Snapshot& snapshot, const char* what, Figure figure) {
    figure.title = fmt::format("{}: {}, {}", options.title, snapshot.step, what);
    figure.subtitle = options.subject;
    names.push_back(fmt::format("{:02}-{}-{}.png", snapshot.step_number, snapshot.step, what));
    write_file(folder / names.back(), to_png(figure));
  };
  for (const Snapshot& snapshot : snapshots) {
    if (!subject.bones.empty()) {
      Figure bones;
      bones.rows = {panels_of(stage.through_skin(snapshot.state, views), views, false)};
      bones.mm_per_pixel = views.front().camera.mm_per_pixel;
      write(snapshot, "bones", std::move(bones));
    }
    Figure section;
    section.rows = {panels_of(stage.cut_open(snapshot.state, cuts), cuts, true)};
    section.legend = section_legend(subject);
    write(snapshot, "section", std::move(section));
  }
  return names;
}

}  // namespace facies::results
