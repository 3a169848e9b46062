// SPDX-License-Identifier: Apache-2.0
#include "facies/results/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>

#include "facies/mesh/nearest.hpp"

namespace facies::results {

namespace {

/// Nearer than this part of the spacing no line comes to another one.
constexpr double nearest_part = 0.5;
/// A line that turns more than this in one step has come to a place without a direction.
const double sharpest_cosine = std::cos(0.6);
/// The largest eigenvalue has to stand out from the next by this part of it.
constexpr double clearest = 0.15;
constexpr std::size_t most_steps = 4000;

/// Which points are near a place.
class PointGrid {
 public:
  explicit PointGrid(double cell) : cell_(cell) {}

  void add(const Vec3& point) { cells_[cell_of(point)].push_back(point); }

  /// Whether a point lies within `radius`, which is at most the size of a cell.
  [[nodiscard]] bool has_near(const Vec3& place, double radius) const {
    const auto [i, j, k] = cell_of(place);
    for (int a = i - 1; a <= i + 1; ++a) {
      for (int b = j - 1; b <= j + 1; ++b) {
        for (int c = k - 1; c <= k + 1; ++c) {
          const auto found = cells_.find({a, b, c});
          if (found != cells_.end() && std::ranges::any_of(found->second, [&](const Vec3& x) {
                return (x - place).norm() < radius;
              }))
            return true;
        }
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& x) const {
    return {static_cast<int>(std::floor(x.x() / cell_)),
            static_cast<int>(std::floor(x.y() / cell_)),
            static_cast<int>(std::floor(x.z() / cell_))};
  }

  double cell_;
  std::map<std::array<int, 3>, std::vector<Vec3>> cells_;
};

/// Where a line is, and which way it can go on.
struct Place {
  Vec3 x = Vec3::Zero();
  Vec3 along = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// The field as a smooth one: axes as tensors, of vertices, those in between as parts of them.
class SmoothField {
 public:
  explicit SmoothField(const AxisField& field)
      : field_(&field), tree_(field.X, field.triangles), tensors_(field.X.size(), Mat3::Zero()) {
    for (std::size_t t = 0; t < field.triangles.size(); ++t) {
      for (const Index vertex : field.triangles[t])
        tensors_[at(vertex)] += field.axes[t] * field.axes[t].transpose();
    }
    for (Mat3& tensor : tensors_)
      tensor /= std::max(tensor.trace(), 1e-30);
  }

  /// The place of the surface near x; nothing beside it, and where it has no one direction.
  [[nodiscard]] std::optional<Place> find(const Vec3& x, double reach) const {
    const mesh::NearestPoint near = tree_.nearest(x);
    if (near.distance > reach) return {};
    const auto& [i, j, k] = field_->triangles[at(near.triangle)];
    const Vec3& a = field_->X[at(i)];
    const Vec3& b = field_->X[at(j)];
    const Vec3& c = field_->X[at(k)];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double part_a = (b - near.point).cross(c - near.point).norm();
    const double part_b = (c - near.point).cross(a - near.point).norm();
    const double part_c = (a - near.point).cross(b - near.point).norm();
    const Mat3 tensor =
        part_a * tensors_[at(i)] + part_b * tensors_[at(j)] + part_c * tensors_[at(k)];
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor);
    const Vec3 values = solver.eigenvalues();
    if (values(2) - values(1) < clearest * values(2)) return {};
    const Vec3 axis = solver.eigenvectors().col(2);
    const Vec3 along = axis - axis.dot(normal) * normal;
    if (along.norm() < 0.1) return {};
    return Place{near.point, along.normalized(), normal};
  }

 private:
  const AxisField* field_;
  mesh::NearestTriangles tree_;
  std::vector<Mat3> tensors_;
};

/// Draws line after line.
class Drawing {
 public:
  Drawing(const AxisField& field, double spacing, double step)
      : field_(field), grid_(spacing), spacing_(spacing), step_(step) {}

  /// A line through a place, if nothing is near it; places beside it are where others may begin.
  void draw_from(const Vec3& seed) {
    const std::optional<Place> start = field_.find(seed, step_);
    if (!start || grid_.has_near(start->x, 0.9 * spacing_)) return;
    const std::vector<Place> back = half(*start, -start->along, {});
    std::vector<Place> line(back.rbegin(), back.rend());
    line.push_back(*start);
    const bool is_closed = !back.empty() && closes(back, *start);
    if (!is_closed) {
      const std::vector<Place> forth = half(*start, start->along, back);
      line.insert(line.end(), forth.begin(), forth.end());
    }
    if (static_cast<double>(line.size() - 1) * step_ < spacing_) return;
    Streamline& drawn = lines_.emplace_back();
    for (const Place& place : line) {
      drawn.points.push_back(place.x);
      drawn.normals.push_back(place.normal);
      grid_.add(place.x);
      const Vec3 aside = spacing_ * place.normal.cross(place.along);
      seeds_.push_back(place.x + aside);
      seeds_.push_back(place.x - aside);
    }
  }

  /// Everything that can be reached from lines that are there.
  void fill() {
    while (!seeds_.empty()) {
      const Vec3 seed = seeds_.front();
      seeds_.pop_front();
      // A seed was set aside in a plane; on a curved surface it lies a little off.
      const std::optional<Place> place = field_.find(seed, 0.5 * spacing_);
      if (place) draw_from(place->x);
    }
  }

  [[nodiscard]] std::vector<Streamline> take() { return std::move(lines_); }

 private:
  [[nodiscard]] bool closes(const std::vector<Place>& line, const Place& start) const {
    return line.size() > 8 && (line.back().x - start.x).norm() < 1.01 * step_;
  }

  /// The line from a place one way, without that place; `back` is what goes the other way.
  [[nodiscard]] std::vector<Place> half(const Place& start, Vec3 along,
                                        const std::vector<Place>& back) const {
    // Of itself a line is near what it drew less than so many steps ago.
    const auto behind = static_cast<std::size_t>(std::ceil(2.0 * spacing_ / step_));
    PointGrid own(spacing_);
    for (std::size_t i = behind; i < back.size(); ++i)
      own.add(back[i].x);
    std::vector<Place> line;
    Vec3 x = start.x;
    while (line.size() < most_steps) {
      std::optional<Place> next = field_.find(x + step_ * along, 0.3 * step_);
      if (!next || (next->x - x).norm() < 0.5 * step_) break;
      if (next->along.dot(along) < 0.0) next->along = -next->along;
      if (next->along.dot(along) < sharpest_cosine) break;
      if (grid_.has_near(next->x, nearest_part * spacing_)) break;
      if (own.has_near(next->x, nearest_part * spacing_)) break;
      x = next->x;
      along = next->along;
      line.push_back(*next);
      if (closes(line, start)) break;
      if (line.size() > behind) own.add(line[line.size() - 1 - behind].x);
    }
    return line;
  }

  SmoothField field_;
  PointGrid grid_;
  double spacing_, step_;
  std::deque<Vec3> seeds_;
  std::vector<Streamline> lines_;
};

}  // namespace

std::vector<Streamline> even_streamlines(const AxisField& field, double spacing, double step) {
  if (field.triangles.empty()) return {};
  Drawing drawing(field, spacing, step);
  for (const auto& [a, b, c] : field.triangles) {
    drawing.draw_from((field.X[at(a)] + field.X[at(b)] + field.X[at(c)]) / 3.0);
    drawing.fill();
  }
  return drawing.take();
}

}  // namespace facies::results
