// SPDX-License-Identifier: Apache-2.0
#include "facies/results/atlas.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "facies/base/files.hpp"
#include "facies/mesh/surface.hpp"
#include "facies/results/anatomy_pictures.hpp"
#include "facies/results/eyes.hpp"
#include "facies/results/figure.hpp"
#include "facies/results/muscle_shapes.hpp"
#include "facies/results/palette.hpp"
#include "facies/results/stage.hpp"
#include "facies/results/streamlines.hpp"

namespace facies::results {

namespace {

/// How dense the skin is in front of muscles.
constexpr float veil_density = 0.05F;
/// A muscle counts as seen where what is drawn is at most this far in front of it [mm].
constexpr double muscle_tolerance = 0.4;
/// Skin lines: from each other, from point to point, how far the drawn skin may be in front of one that is seen [mm].
constexpr double line_spacing = 3.5;
constexpr double line_step = 0.5;
constexpr double line_tolerance = 0.6;
/// Pieces of fewer points are specks.
constexpr std::size_t fewest_points = 8;
/// Where the skin is seen more aslant than this cosine, lines would run into each other.
constexpr double line_facing = 0.25;
constexpr double line_width = 1.3;  // [pixels]
/// Of each muscle alone, as a part of the others' height; how many stand side by side.
constexpr double small_view = 0.42;
constexpr std::size_t muscles_in_a_row = 5;

struct Page {
  std::string name;
  Figure figure;
};

/// Bones beside each other have different colours; what is named after teeth keeps theirs.
Subject with_coloured_bones(Subject subject) {
  std::size_t n = 0;
  for (BoneShape& bone : subject.bones) {
    if (bone.name.ends_with("teeth")) {
      bone.colour = palette::teeth;
    } else {
      bone.colour = palette::bones.at(n++ % palette::bones.size());
    }
  }
  return subject;
}

std::vector<LegendEntry> bone_legend(const Subject& subject) {
  std::vector<LegendEntry> legend;
  bool has_teeth = false;
  for (const BoneShape& bone : subject.bones) {
    const bool is_teeth = bone.colour == palette::teeth;
    has_teeth =
        has_teeth || is_teeth || std::ranges::find(bone.is_tooth, true) != bone.is_tooth.end();
    if (!is_teeth) legend.push_back({bone.colour, bone.meaning.empty() ? bone.name : bone.meaning});
  }
  if (has_teeth) legend.push_back({palette::teeth, "teeth"});
  return legend;
}

/// The skin's surface with its lines.
AxisField field_of(const Subject& subject) {
  const mesh::Mesh& mesh = *subject.mesh;
  const std::span<const mesh::Face> skin = mesh.faces("outer");
  const mesh::FaceTriangles cut = mesh::triangulate(mesh, skin);
  AxisField field{{mesh.X().begin(), mesh.X().end()}, cut.triangles, {}};
  for (const Index face : cut.face)
    field.axes.push_back(subject.skin_lines[at(skin[at(face)].element)]);
  return field;
}

/// What a camera sees of lines on what it looks at.
std::vector<Stroke> strokes_of(const std::vector<Streamline>& lines, const Scene& scene,
                               const Camera& camera) {
  std::vector<Stroke> strokes;
  for (const Streamline& line : lines) {
    Stroke stroke{{}, palette::skin_line, line_width};
    const auto end = [&] {
      if (stroke.points.size() >= fewest_points) strokes.push_back(stroke);
      stroke.points.clear();
    };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const bool is_facing = -line.normals[i].dot(camera.direction) > line_facing;
      if (is_facing && scene.sees(camera, line.points[i], line_tolerance)) {
        stroke.points.push_back(camera.project(line.points[i]));
      } else {
        end();
      }
    }
    end();
  }
  return strokes;
}

Panel halved(const Panel& panel) {
  Panel half{results::halved(panel.image), panel.caption, {}};
  for (Stroke stroke : panel.strokes) {
    for (Eigen::Vector2d& point : stroke.points)
      point *= 0.5;
    stroke.width *= 0.7;
    half.strokes.push_back(std::move(stroke));
  }
  for (const Dot& dot : panel.dots)
    half.dots.push_back({0.5 * dot.column, 0.5 * dot.row, ""});
  return half;
}

/// Draws pages, each with the views of the others.
class Atlas {
 public:
  Atlas(const Subject& subject, const PictureOptions& options)
      : subject_(with_coloured_bones(subject)),
        options_(options),
        stage_(subject_, options.threads),
        nowhere_{std::vector<Vec3>(subject.mesh->n_nodes(), Vec3::Zero())},
        views_(standard_views(*subject.mesh, {}, options.height)),
        skin_(stage_.in_light(nowhere_)),
        row_(row_of(render_all(skin_))) {}

  std::vector<Page> draw() {
    add("skin", "skin", {row_});
    if (!subject_.bones.empty()) add_bones();
    if (!subject_.muscles.empty()) add_muscles();
    add_layers();
    if (!subject_.skin_lines.empty()) add_tension_lines();
    if (!subject_.landmarks.empty()) add_landmarks();
    pages_.insert(pages_.begin(), {"overview", overview()});
    return std::move(pages_);
  }

 private:
  /// A page. Its panel at `sample` stands for it in the overview.
  Figure& add(const std::string& name, const std::string& what,
              std::vector<std::vector<Panel>> rows, std::size_t sample = 1) {
    Panel small = halved(rows.back().at(sample));
    small.caption = what;
    samples_.push_back(std::move(small));
    return add_alone(name, what, std::move(rows));
  }

  Figure& add_alone(const std::string& name, const std::string& what,
                    std::vector<std::vector<Panel>> rows) {
    pages_.push_back({name, {what, options_.subject, std::move(rows), scale(), {}}});
    return pages_.back().figure;
  }

  void add_bones() {
    Figure& page = add("bones", "bones",
                       {row_of(stage_.with_bones(nowhere_, {}, views_)),
                        row_of(stage_.through_skin(nowhere_, views_))});
    page.legend = bone_legend(subject_);
  }

  void add_muscles() {
    const std::vector<MuscleGroup> groups = muscle_groups(subject_);
    const std::vector<MuscleShape> shapes = muscle_shapes(groups, *subject_.mesh, false);
    Surface all;
    for (const MuscleShape& shape : shapes)
      append(all, shape.surface());
    for (const EyeShape& eye : subject_.eyes)
      append(all, surface_of(eye));
    const Scene scene(std::move(all), options_.threads);
    const Scene veil = stage_.skin(nowhere_);
    const std::array<Actor, 2> actors{
        {{.scene = &scene}, {.scene = &veil, .density = veil_density}}};
    std::vector<Panel> row = row_of(stage_.with_bones(nowhere_, actors, views_));
    for (std::size_t v = 0; v < row.size(); ++v) {
      const Camera& camera = views_[v].camera;
      row[v].callouts = muscle_names(shapes, camera, [&](const Vec3& x) {
        return scene.sees(camera, x, muscle_tolerance) && stage_.is_before_bones(camera, x);
      });
    }
    Figure& page = add("muscles", "muscles", {std::move(row)});
    for (const MuscleGroup& group : groups)
      page.legend.push_back({group.colour, label_of(group)});
    add_each_muscle(groups, veil);
  }

  void add_each_muscle(const std::vector<MuscleGroup>& groups, const Scene& veil) {
    const std::vector<MuscleShape> shapes = muscle_shapes(groups, *subject_.mesh, true);
    View view = views_[1];
    view.camera.mm_per_pixel /= small_view;
    view.camera.width = static_cast<int>(view.camera.width * small_view);
    view.camera.height = static_cast<int>(view.camera.height * small_view);
    std::vector<std::vector<Panel>> rows;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const Scene scene(shapes[g].surface(), options_.threads);
      const std::array<Actor, 2> actors{
          {{.scene = &scene}, {.scene = &veil, .density = veil_density}}};
      if (g % muscles_in_a_row == 0) rows.emplace_back();
      rows.back().push_back(
          {stage_.with_bones(nowhere_, actors, {&view, 1}).front(), groups[g].name, {}});
    }
    Figure& page = add_alone("muscles-one-by-one", "muscles one by one", std::move(rows));
    page.mm_per_pixel = view.camera.mm_per_pixel;
    for (const MuscleGroup& group : groups)
      page.legend.push_back({group.colour, label_of(group)});
  }

  void add_layers() {
    std::vector<View> cuts = section_views(*subject_.mesh, {}, options_.height);
    cuts.push_back(transverse_view(*subject_.mesh, {}, options_.height));
    const std::vector<Image> images = stage_.cut_open(nowhere_, cuts);
    std::vector<Panel> row;
    for (std::size_t c = 0; c < cuts.size(); ++c)
      row.push_back({images[c], cuts[c].name, {}, cuts[c].camera.mm_per_pixel});
    Figure& page = add("layers", "layers", {std::move(row)}, 0);
    page.mm_per_pixel = 0.0;
    page.legend = section_legend(subject_);
  }

  void add_tension_lines() {
    const std::vector<Streamline> lines =
        even_streamlines(field_of(subject_), line_spacing, line_step);
    std::vector<Panel> row = row_;
    for (std::size_t v = 0; v < row.size(); ++v)
      row[v].strokes = strokes_of(lines, skin_, views_[v].camera);
    add("tension-lines", "skin tension lines", {std::move(row)});
  }

  void add_landmarks() {
    std::vector<Panel> row = row_;
    for (std::size_t v = 0; v < row.size(); ++v) {
      row[v].callouts = landmarks_in(subject_, skin_, views_[v].camera);
      for (const Dot& dot : row[v].callouts)
        row[v].dots.push_back({dot.column, dot.row, ""});
    }
    Figure& page = add("landmarks", "landmarks", {std::move(row)});
    for (const NamedNode& landmark : subject_.landmarks)
      page.legend.push_back({{}, fmt::format("{}: {}", landmark.name, landmark.meaning)});
  }

  /// One panel of every page, in two rows.
  [[nodiscard]] Figure overview() const {
    Figure figure{"anatomy", options_.subject, {}, 0.0, {}};
    const std::size_t in_a_row = (samples_.size() + 1) / 2;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      if (s % in_a_row == 0) figure.rows.emplace_back();
      figure.rows.back().push_back(samples_[s]);
    }
    return figure;
  }

  static std::string label_of(const MuscleGroup& group) {
    return group.meaning.empty() ? group.name : fmt::format("{}: {}", group.name, group.meaning);
  }

  [[nodiscard]] std::vector<Image> render_all(const Scene& scene) const {
    std::vector<Image> images;
    for (const View& view : views_)
      images.push_back(scene.render(view.camera, {}, options_.threads));
    return images;
  }

  [[nodiscard]] std::vector<Panel> row_of(std::vector<Image> images) const {
    std::vector<Panel> row;
    for (std::size_t v = 0; v < images.size(); ++v)
      row.push_back({std::move(images[v]), views_[v].name, {}});
    return row;
  }

  [[nodiscard]] double scale() const { return views_.front().camera.mm_per_pixel; }

  Subject subject_;
  PictureOptions options_;
  Stage stage_;
  mechanics::State nowhere_;
  std::vector<View> views_;
  Scene skin_;
  std::vector<Panel> row_;  ///< the skin, from all sides
  std::vector<Page> pages_;
  std::vector<Panel> samples_;
};

}  // namespace

const std::vector<std::string>& atlas_files() {
  static const std::vector<std::string> names{
      "overview.png",           "skin.png",   "bones.png",         "muscles.png",
      "muscles-one-by-one.png", "layers.png", "tension-lines.png", "landmarks.png"};
  return names;
}

std::vector<std::string> write_atlas(const Subject& subject, const std::filesystem::path& folder,
                                     const PictureOptions& options) {
  std::vector<std::pair<std::string, std::string>> files;
  for (Page& page : Atlas(subject, options).draw()) {
    if (!options.title.empty()) page.figure.title = options.title + ": " + page.figure.title;
    files.emplace_back(page.name + ".png", to_png(page.figure));
  }
  std::vector<std::string> names;
  for (const auto& [name, png] : files) {
    write_file(folder / name, png);
    names.push_back(name);
  }
  return names;
}

}  // namespace facies::results
