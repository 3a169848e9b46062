// SPDX-License-Identifier: Apache-2.0
#include "facies/results/pictures.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/figure.hpp"
#include "facies/results/stage.hpp"

namespace facies::results {

namespace {

/// A landmark counts as seen where the surface is at most this far in front of it: the surface is drawn round [mm].
constexpr double sight_tolerance = 1.5;

/// The same views of every scene.
std::vector<Panel> take(const Scene& scene, std::span<const View> views, int threads,
                        const ColourScale& scale = {}) {
  std::vector<Panel> row;
  for (const View& view : views)
    row.push_back({scene.render(view.camera, scale, threads), view.name, {}});
  return row;
}

/// Collects pages, and a smaller copy of each for the overview.
class Album {
 public:
  Album(std::filesystem::path folder, const PictureOptions& options, double mm_per_pixel)
      : folder_(std::move(folder)), options_(options), mm_per_pixel_(mm_per_pixel) {
    overview_ = {options.title, options.subject, {}, 2.0 * mm_per_pixel, {}};
  }

  void add(const std::string& name, const std::string& what, std::vector<Panel> row,
           std::optional<ColourBar> bar = {}) {
    std::vector<Panel> small;
    small.reserve(row.size());
    for (const Panel& panel : row)
      small.push_back({halved(panel.image), small.empty() ? what : "", {}});
    if (row.front().dots.empty()) overview_.rows.push_back(std::move(small));
    if (bar) overview_.bar = bar;
    write(name, {options_.title + ": " + what,
                 options_.subject,
                 {std::move(row)},
                 mm_per_pixel_,
                 std::move(bar)});
  }

  std::vector<std::string> finish() {
    write("overview.png", overview_);
    return std::move(names_);
  }

 private:
  void write(const std::string& name, const Figure& figure) {
    write_file(folder_ / name, to_png(figure));
    names_.push_back(name);
  }

  std::filesystem::path folder_;
  PictureOptions options_;
  double mm_per_pixel_;
  Figure overview_;
  std::vector<std::string> names_;
};

}  // namespace

std::vector<Dot> landmarks_in(const Subject& subject, const Scene& scene, const Camera& camera) {
  std::vector<Dot> dots;
  for (const NamedNode& landmark : subject.landmarks) {
    const Vec3& X = subject.mesh->X()[at(landmark.node)];
    if (!scene.sees(camera, X, sight_tolerance)) continue;
    const Eigen::Vector2d place = camera.project(X);
    dots.push_back({place.x(), place.y(), landmark.name});
  }
  return dots;
}

std::vector<std::string> write_pictures(const Subject& subject, const Snapshot* rest,
                                        const Snapshot& last, const std::filesystem::path& folder,
                                        const PictureOptions& options) {
  const mechanics::State nowhere{std::vector<Vec3>(subject.mesh->n_nodes(), Vec3::Zero())};
  const mechanics::State& start = rest != nullptr ? rest->state : nowhere;
  const std::vector<Vec3>& before = start.u;
  const std::array<const std::vector<Vec3>*, 2> states{&before, &last.state.u};
  const std::vector<View> views = standard_views(*subject.mesh, states, options.height);
  const Stage stage(subject, options.threads);
  const auto picture = [&](const mechanics::State& state) {
    return take(stage.in_light(state), views, options.threads);
  };
  Album album(folder, options, views.front().camera.mm_per_pixel);

  const Scene as_read = stage.in_light(nowhere);
  std::vector<Panel> row = take(as_read, views, options.threads);
  album.add("rest.png", "mesh as read", row);
  for (std::size_t v = 0; v < views.size(); ++v)
    row[v].dots = landmarks_in(subject, as_read, views[v].camera);
  if (!subject.landmarks.empty()) album.add("landmarks.png", "landmarks", std::move(row));
  if (rest != nullptr) album.add("tensioned-rest.png", "tensioned rest", picture(start));
  if (rest == &last) return album.finish();

  std::vector<double> distance(before.size());
  for (std::size_t i = 0; i < distance.size(); ++i)
    distance[i] = (last.state.u[i] - before[i]).norm();
  const double largest = *std::max_element(distance.begin(), distance.end());
  const ColourScale scale{ColourMap::lajolla, 0.0, round_up(largest)};
  album.add("expression.png", "expression", picture(last.state));
  album.add("displacement.png", "displacement",
            take(stage.in_light(last.state, distance), views, options.threads, scale),
            ColourBar{scale, "displacement [mm]"});
  return album.finish();
}

}  // namespace facies::results
