// SPDX-License-Identifier: Apache-2.0
#include "facies/results/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/figure.hpp"
#include "facies/results/shell.hpp"

namespace facies::results {

namespace {

/// Room around the mesh as read [mm], for what moves; and around everything that is shown.
constexpr double wide_margin = 8.0;
constexpr double narrow_margin = 2.0;
/// A landmark counts as seen where the surface is at most this far in front of it: the surface is drawn round [mm].
constexpr double sight_tolerance = 1.5;

struct View {
  const char* name;
  Vec3 direction;
};

/// Faces look towards -x and have their right side at +y.
std::array<View, 3> views() {
  return {{{"front", Vec3::UnitX()},
           {"three-quarter", Vec3(1.0, -1.0, 0.0).normalized()},
           {"profile", -Vec3::UnitY()}}};
}

/// The range of points along three axes.
struct Extent {
  Eigen::Array3d lower = Eigen::Array3d::Constant(1e300);
  Eigen::Array3d upper = Eigen::Array3d::Constant(-1e300);

  void add(const Eigen::Array3d& point, double around) {
    lower = lower.min(point - around);
    upper = upper.max(point + around);
  }
};

/// Draws states of one subject, all in the same frame.
class Photographer {
 public:
  Photographer(const Subject& subject, std::span<const std::vector<Vec3>* const> states,
               const PictureOptions& options)
      : shell_(*subject.mesh), options_(options) {
    double height = 0.0;
    std::array<Extent, 3> extents;
    for (std::size_t v = 0; v < cameras_.size(); ++v) {
      cameras_[v].direction = views()[v].direction;
      extents[v] = extent_of(*subject.mesh, cameras_[v], states);
      height = std::max(height, extents[v].upper(2) - extents[v].lower(2));
    }
    for (std::size_t v = 0; v < cameras_.size(); ++v) {
      Camera& camera = cameras_[v];
      const Eigen::Array3d middle = 0.5 * (extents[v].lower + extents[v].upper);
      camera.target =
          middle(0) * camera.direction + middle(1) * camera.right() + middle(2) * camera.up;
      camera.mm_per_pixel = height / options.height;
      camera.height = options.height;
      camera.width = static_cast<int>(
          std::ceil((extents[v].upper(1) - extents[v].lower(1)) / camera.mm_per_pixel));
    }
  }

  /// The face at X + u, ready to be looked at.
  [[nodiscard]] Scene pose(std::span<const Vec3> u, std::span<const double> values = {}) const {
    return {shell_.pose(u, values), options_.threads};
  }

  [[nodiscard]] std::vector<Panel> take(const Scene& scene, const ColourScale& scale = {}) const {
    std::vector<Panel> row;
    for (std::size_t v = 0; v < cameras_.size(); ++v) {
      row.push_back({scene.render(cameras_[v], scale, options_.threads), views()[v].name, {}});
    }
    return row;
  }

  /// Marks those landmarks of the mesh as read that can be seen.
  void mark_landmarks(const Subject& subject, const Scene& scene, std::vector<Panel>& row) const {
    for (std::size_t v = 0; v < cameras_.size(); ++v) {
      for (const NamedNode& landmark : subject.landmarks) {
        const Vec3& X = subject.mesh->X()[at(landmark.node)];
        if (!scene.sees(cameras_[v], X, sight_tolerance)) continue;
        const Eigen::Vector2d place = cameras_[v].project(X);
        row[v].dots.push_back({place.x(), place.y(), landmark.name});
      }
    }
  }

  [[nodiscard]] double mm_per_pixel() const { return cameras_[0].mm_per_pixel; }

 private:
  /// Along the camera's direction, right and up: the mesh with a wide margin, every state with a narrow one.
  static Extent extent_of(const mesh::Mesh& mesh, const Camera& camera,
                          std::span<const std::vector<Vec3>* const> states) {
    Extent extent;
    const auto add = [&](const Vec3& x, double around) {
      extent.add({x.dot(camera.direction), x.dot(camera.right()), x.dot(camera.up)}, around);
    };
    for (const Vec3& X : mesh.X())
      add(X, wide_margin);
    for (const std::vector<Vec3>* u : states) {
      for (std::size_t i = 0; i < u->size(); ++i)
        add(mesh.X()[i] + (*u)[i], narrow_margin);
    }
    return extent;
  }

  Shell shell_;
  PictureOptions options_;
  std::array<Camera, 3> cameras_;
};

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

std::vector<std::string> write_pictures(const Subject& subject, const Snapshot* rest,
                                        const Snapshot& last, const std::filesystem::path& folder,
                                        const PictureOptions& options) {
  const std::vector<Vec3> nowhere(subject.mesh->n_nodes(), Vec3::Zero());
  const std::vector<Vec3>& before = rest != nullptr ? rest->state.u : nowhere;
  const std::array<const std::vector<Vec3>*, 2> states{&before, &last.state.u};
  const Photographer photographer(subject, states, options);
  Album album(folder, options, photographer.mm_per_pixel());

  const Scene as_read = photographer.pose(nowhere);
  std::vector<Panel> row = photographer.take(as_read);
  album.add("rest.png", "mesh as read", row);
  photographer.mark_landmarks(subject, as_read, row);
  if (!subject.landmarks.empty()) album.add("landmarks.png", "landmarks", std::move(row));
  if (rest != nullptr)
    album.add("tensioned-rest.png", "tensioned rest", photographer.take(photographer.pose(before)));
  if (rest == &last) return album.finish();

  std::vector<double> distance(before.size());
  for (std::size_t i = 0; i < distance.size(); ++i)
    distance[i] = (last.state.u[i] - before[i]).norm();
  const double largest = *std::max_element(distance.begin(), distance.end());
  const ColourScale scale{ColourMap::lajolla, 0.0, round_up(largest)};
  album.add("expression.png", "expression", photographer.take(photographer.pose(last.state.u)));
  album.add("displacement.png", "displacement",
            photographer.take(photographer.pose(last.state.u, distance), scale),
            ColourBar{scale, "displacement [mm]"});
  return album.finish();
}

}  // namespace facies::results
