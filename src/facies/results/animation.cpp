// SPDX-License-Identifier: Apache-2.0
#include "facies/results/animation.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/anatomy_pictures.hpp"
#include "facies/results/apng.hpp"

namespace facies::results {

namespace {

constexpr int pause = 1000;   ///< at both ends [ms]
constexpr int way = 2000;     ///< everything between [ms]
constexpr int shortest = 40;  ///< that viewers keep up with [ms]

/// How far the step has come, in words that leave the size of the page as it is.
std::string progress(const Snapshot& frame) {
  if (frame.time) return fmt::format("{:.3f} s", *frame.time);
  return fmt::format("{:.0f} % of the load", 100.0 * frame.load);
}

}  // namespace

std::string write_animation(const Subject& subject, std::span<const Snapshot> frames,
                            const std::filesystem::path& folder, const PictureOptions& options) {
  require(!frames.empty(), "write_animation: no frames");
  std::vector<const std::vector<Vec3>*> states;
  for (const Snapshot& frame : frames)
    states.push_back(&frame.state.u);
  const View front = standard_views(*subject.mesh, states, options.height).front();
  const std::vector<View> cut = {section_views(*subject.mesh, states, options.height).front()};
  const Stage stage(subject, options.threads);
  const int between = std::max(shortest, way / static_cast<int>(frames.size()));
  std::vector<AnimationFrame> pages;
  for (const Snapshot& frame : frames) {
    Figure page;
    page.title = fmt::format("{}: {}", options.title, frame.step);
    page.subtitle = options.subject;
    page.mm_per_pixel = front.camera.mm_per_pixel;
    page.legend = section_legend(subject);
    Image light = stage.in_light(frame.state).render(front.camera, {}, options.threads);
    Image section = std::move(stage.cut_open(frame.state, cut).front());
    const std::string caption = fmt::format("{}, {}", front.name, progress(frame));
    page.rows = {{{std::move(light), caption, {}}, {std::move(section), cut[0].name, {}}}};
    const bool is_end = &frame == &frames.front() || &frame == &frames.back();
    pages.push_back({to_png(page), is_end ? pause : between});
  }
  const Snapshot& last = frames.back();
  std::string name = fmt::format("{:02}-{}-animation.png", last.step_number, last.step);
  write_file(folder / name, to_apng(pages));
  return name;
}

}  // namespace facies::results
