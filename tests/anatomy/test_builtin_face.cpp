// SPDX-License-Identifier: Apache-2.0
// The built-in face at its presets: shape of elements, symmetry, measures, layers, supports.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <set>

#include "anatomy/builtin_files.hpp"
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_face.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::anatomy {
namespace {

/// Each face is made once for all tests.
const FaceAnatomy& face_of(const std::string& options) {
  static std::map<std::string, FaceAnatomy> made;
  const auto found = made.find(options);
  if (found != made.end()) return found->second;
  return made.emplace(options, make_builtin_face(options, builtin_folder())).first->second;
}

const Drawings& drawings() {
  static const Drawings all = read_drawings(builtin_folder());
  return all;
}

const std::vector<std::string>& sizes() {
  static const std::vector<std::string> all{"size=coarse", "size=standard", "size=fine",
                                            "size=coarse,preset=female", "preset=female"};
  return all;
}

Vec3 mirror_image(const Vec3& x) {
  return {x.x(), -x.y(), x.z()};
}

/// The node at the mirror image of each node, or -1 where none is within 1e-9 mm.
std::vector<Index> twins(const mesh::Mesh& mesh) {
  std::vector<Index> order;
  for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
    order.push_back(to_index(n));
  const std::span<const Vec3> X = mesh.X();
  std::ranges::sort(order, {}, [&](Index n) { return X[at(n)].z(); });
  std::vector<Index> result;
  for (const Vec3& x : X) {
    const Vec3 image = mirror_image(x);
    Index twin = -1;
    const auto first = std::ranges::lower_bound(order, image.z() - 1e-9, {},
                                                [&](Index n) { return X[at(n)].z(); });
    for (auto n = first; n != order.end() && X[at(*n)].z() <= image.z() + 1e-9; ++n) {
      if ((X[at(*n)] - image).norm() < 1e-9) twin = *n;
    }
    result.push_back(twin);
  }
  return result;
}

TEST(BuiltinFace, HasWellShapedElementsAtEverySize) {
  for (const std::string& options : sizes()) {
    const mesh::Mesh& mesh = face_of(options).mesh;
    EXPECT_TRUE(mesh::check_geometry(mesh).empty()) << options;
    const mesh::QualityReport report = mesh::quality(mesh, mesh.X());
    EXPECT_TRUE(report.inverted_corners.empty()) << options;
    double gauss = 1.0;
    double corner = 1.0;
    for (const mesh::ElementQuality& element : report.elements) {
      gauss = std::min(gauss, element.scaled_jacobian_gauss);
      corner = std::min(corner, element.scaled_jacobian_corner);
    }
    EXPECT_GE(gauss, 0.2) << options;
    EXPECT_GE(corner, 0.2) << options;
  }
}

/// The mean length of an element's edges [mm].
double mean_edge(const mesh::Mesh& mesh, Index e) {
  const mesh::Element& element = mesh.element(e);
  const auto edges = mesh::edges(element.type);
  double sum = 0.0;
  for (const auto& [a, b] : edges)
    sum += (mesh.X()[at(element.nodes.at(a))] - mesh.X()[at(element.nodes.at(b))]).norm();
  return sum / static_cast<double>(edges.size());
}

/// The area of a face with four nodes [mm^2].
double area_of(const mesh::Mesh& mesh, const mesh::Face& face) {
  const std::vector<Index> nodes = mesh.face_nodes(face);
  const auto X = [&](std::size_t k) { return mesh.X()[at(nodes[k])]; };
  return 0.5 * (X(2) - X(0)).cross(X(3) - X(1)).norm();
}

/// By how much the roots of the areas of neighbours on the skin differ at most.
double worst_side(const mesh::Mesh& mesh) {
  std::map<std::pair<Index, Index>, double> sides;
  double worst = 1.0;
  for (const mesh::Face& face : mesh.faces("outer")) {
    const std::vector<Index> nodes = mesh.face_nodes(face);
    const double side = std::sqrt(area_of(mesh, face));
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [other, is_new] = sides.emplace(std::minmax(nodes[k], nodes[(k + 1) % 4]), side);
      if (!is_new) worst = std::max({worst, side / other->second, other->second / side});
    }
  }
  return worst;
}

// Size in three senses: the cube root of an element's volume, the mean length of its edges, and the root of the area of its face on
// the skin. Neighbours share a face.
TEST(BuiltinFace, HasNeighboursWhoseSizesDifferByAFactorOfTwoAndAHalfAtMost) {
  for (const std::string& options : sizes()) {
    const mesh::Mesh& mesh = face_of(options).mesh;
    std::map<mesh::FaceKey, Index> first;
    double worst_volume = 1.0;
    double worst_edge = 1.0;
    for (Index e = 0; e < to_index(mesh.n_elements()); ++e) {
      for (std::uint8_t local = 0; local < 6; ++local) {
        const auto [other, is_new] = first.emplace(mesh::face_key(mesh, {e, local}), e);
        if (is_new) continue;
        const double volume = std::cbrt(mesh::element_volume(mesh, e, mesh.X()) /
                                        mesh::element_volume(mesh, other->second, mesh.X()));
        const double edge = mean_edge(mesh, e) / mean_edge(mesh, other->second);
        worst_volume = std::max({worst_volume, volume, 1.0 / volume});
        worst_edge = std::max({worst_edge, edge, 1.0 / edge});
      }
    }
    EXPECT_LE(worst_volume, 2.5) << options;
    EXPECT_LE(worst_edge, 2.5) << options;
    EXPECT_LE(worst_side(mesh), 2.5) << options;
    RecordProperty("side:" + options, fmt::format("{:.2f}", worst_side(mesh)));
    RecordProperty("volume:" + options, fmt::format("{:.2f}", worst_volume));
    RecordProperty("edge:" + options, fmt::format("{:.2f}", worst_edge));
  }
}

TEST(BuiltinFace, IsSymmetricWhereNothingElseIsChosen) {
  for (const std::string& options : sizes()) {
    const FaceAnatomy& face = face_of(options);
    const std::vector<Index> twin = twins(face.mesh);
    EXPECT_EQ(std::ranges::count(twin, -1), 0) << options;
    for (const auto& [name, nodes] : face.mesh.node_sets()) {
      for (const Index node : nodes)
        EXPECT_TRUE(std::ranges::binary_search(nodes, twin[at(node)])) << options << " " << name;
    }
    for (const MusclePaths& muscle : face.muscle_paths) {
      std::vector<Vec3> left;
      std::vector<Vec3> right;
      for (const FibrePath& path : muscle.paths) {
        for (const Vec3& x : path.points) {
          if (path.side != Side::right) left.push_back(x);
          if (path.side != Side::left) right.push_back(mirror_image(x));
        }
      }
      EXPECT_EQ(left.size(), right.size()) << muscle.name;
      for (const Vec3& x : left) {
        EXPECT_TRUE(std::ranges::any_of(right, [&](const Vec3& y) {
          return (x - y).norm() < 1e-9;
        })) << muscle.name;
      }
    }
    std::map<std::string, std::map<Side, std::size_t>> n_elements;
    for (const Muscle& muscle : select_muscles(face, {6.0, 3.0}, 1.1))
      n_elements[muscle.group][muscle.side] = muscle.elements.size();
    for (auto& [name, sides] : n_elements)
      EXPECT_EQ(sides[Side::left], sides[Side::right]) << options << " " << name;
  }
}

/// The measure from the nodes of both halves, by the definitions at the head of measures.csv.
double taken_from(const FaceAnatomy& face, const FaceMeasure& measure) {
  const auto node = [&](const std::string& name, bool left) {
    const auto landmark =
        std::ranges::find(drawings().measures.landmarks, name, &SkinLandmark::name);
    const Index point = drawings().skin.index.at(landmark->point);
    return face.mesh.X()[at(left ? drawings().skin.mirrored[at(point)] : point)];
  };
  const Vec3 a = node(measure.a, false);
  if (measure.kind == MeasureKind::width) return (a - node(measure.a, true)).norm();
  const Vec3 b = node(measure.b, false);
  if (measure.kind == MeasureKind::forward) return b.x() - a.x();
  if (measure.kind == MeasureKind::up) return a.z() - b.z();
  return (a - b).norm();
}

TEST(BuiltinFace, HasTheMeasuresOfItsPreset) {
  for (const std::string preset : {"male", "female"}) {
    for (const std::string size : {"coarse", "standard"}) {
      const FaceAnatomy& face = face_of("size=" + size + ",preset=" + preset);
      for (const FaceMeasure& measure : drawings().measures.measures) {
        const double wanted = preset == "male" ? measure.male : measure.female;
        // What follows from the others is near what the table says of it; the rest is met.
        EXPECT_NEAR(taken_from(face, measure), wanted, measure.rest_of.empty() ? 1e-6 : 1.0)
            << preset << " " << measure.key;
      }
    }
  }
}

constexpr const char* some_lengths =
    "size=coarse,mouth_width=58 mm,nose_width=40 mm,ear_depth=-100 mm,chin_height=35 mm,"
    "depth_pogonion=12.5 mm";

TEST(BuiltinFace, HasTheMeasuresThatItIsGiven) {
  const FaceAnatomy& face = face_of(some_lengths);
  const auto value = [&](const std::string& key) {
    return taken_from(face,
                      *std::ranges::find(drawings().measures.measures, key, &FaceMeasure::key));
  };
  EXPECT_NEAR(value("mouth_width"), 58.0, 1e-6);
  EXPECT_NEAR(value("nose_width"), 40.0, 1e-6);
  EXPECT_NEAR(value("ear_depth"), -100.0, 1e-6);
  EXPECT_NEAR(value("chin_height"), 35.0, 1e-6);
}

TEST(BuiltinFace, TellsTheLengthsThatItHas) {
  const FaceAnatomy& face = face_of(some_lengths);
  const auto length = [&](const std::string& key) {
    return *std::ranges::find(face.lengths, key, &FaceLength::key);
  };
  EXPECT_EQ(face.lengths.size(), drawings().measures.measures.size() + drawings().depths.size());
  for (const FaceMeasure& measure : drawings().measures.measures)
    EXPECT_NEAR(length(measure.key).found, taken_from(face, measure), 1e-9) << measure.key;
  for (const FaceLength& asked : face.lengths) {
    EXPECT_NEAR(asked.found, asked.wanted.value_or(asked.found), 1.0) << asked.key;
  }
  EXPECT_EQ(length("mouth_width").wanted, 58.0);
  EXPECT_EQ(length("depth_pogonion").wanted, 12.5);
  EXPECT_FALSE(length("face_height").wanted);  // what the chin is what is left of
  EXPECT_FALSE(length("depth_nasion").wanted);
  EXPECT_GT(length("depth_nasion").found, 0.0);
}

/// What skin-thickness.csv asks for at each column of a face [mm].
std::vector<double> thickness_of(const std::string& options) {
  const std::size_t n_columns = face_of(options).mesh.nodes("outer").size();
  const bool female = options.find("female") != std::string::npos;
  const Cage& skin = drawings().skin;
  for (int levels = 0;; ++levels) {
    const mesh::LimitMesh refined = mesh::limit_mesh(skin.net, levels);
    if (at(refined.net.n_vertices) < n_columns) continue;
    return mesh::weighted(refined.limit, skin_thickness(skin, drawings().skin_regions, female));
  }
}

// Skin of its thickness or 0.3 of a column, whichever is less; the two layers of fat share the rest (builtin_tissue.hpp).
TEST(BuiltinFace, HasLayersOfTheirThickness) {
  for (const std::string& options : sizes()) {
    const mesh::Mesh& mesh = face_of(options).mesh;
    const std::size_t n_columns = mesh.nodes("outer").size();
    const std::size_t n_deep = mesh.n_nodes() / n_columns - 1;
    ASSERT_EQ(mesh.n_nodes(), n_columns * (n_deep + 1));
    ASSERT_EQ(n_deep % 3, 0U);
    const std::vector<double> thickness = thickness_of(options);
    for (std::size_t v = 0; v < n_columns; ++v) {
      const auto x = [&](std::size_t depth) { return mesh.X()[depth * n_columns + v]; };
      const double whole = (x(n_deep) - x(0)).norm();
      const double skin = (x(n_deep / 3) - x(0)).norm();
      const double middle = (x(2 * n_deep / 3) - x(n_deep / 3)).norm();
      EXPECT_NEAR(skin, std::min(thickness[v], 0.3 * whole), 1e-9) << options << " column " << v;
      EXPECT_NEAR(middle, 0.5 * (whole - skin), 1e-9) << options << " column " << v;
    }
    std::size_t n = 0;
    for (const std::string& layer : layer_names())
      n += mesh.elements(layer).size();
    EXPECT_EQ(n, mesh.n_elements());
  }
}

/// What skin-thickness.csv asks for, on average over the area of a face [mm].
double mean_thickness(const std::string& options) {
  const mesh::Mesh& mesh = face_of(options).mesh;
  const std::vector<double> thickness = thickness_of(options);
  double volume = 0.0;
  double area = 0.0;
  for (const mesh::Face& face : mesh.faces("outer")) {
    const double own = area_of(mesh, face);
    area += own;
    for (const Index node : mesh.face_nodes(face))
      volume += 0.25 * own * thickness[at(node)];
  }
  return volume / area;
}

// As thick on average as in the paper, and in women as much thinner as published.
TEST(BuiltinFace, HasSkinOfThePublishedThickness) {
  const double men = mean_thickness("size=standard");
  EXPECT_NEAR(men, 1.5, 0.05);
  EXPECT_NEAR(mean_thickness("preset=female") / men, 0.85, 0.02);
}

TEST(BuiltinFace, HasThinLidsAndAThickTipOfTheNose) {
  const std::vector<double> thickness = thickness_of("size=standard");
  const auto at_point = [&](const char* point) {
    return thickness[at(drawings().skin.index.at(point))];
  };
  EXPECT_NEAR(at_point("eye0.2"), 0.80, 0.05);
  EXPECT_NEAR(at_point("k3.0"), 2.05, 0.2);
  EXPECT_NEAR(at_point("f1.4"), 1.60, 0.01);
  EXPECT_NEAR(at_point("k4.8"), 1.70, 0.02);
  EXPECT_EQ(at_point("k4.8"), at_point("k4.8-left"));
}

TEST(BuiltinFace, HasTheNodeSetsThatModelsRelyOn) {
  for (const std::string& options : sizes()) {
    const mesh::Mesh& mesh = face_of(options).mesh;
    for (const char* name : {"outer", "inner"}) {
      EXPECT_TRUE(
          std::ranges::equal(mesh::face_set_nodes(mesh, mesh.faces(name)), mesh.nodes(name)))
          << options;
    }
    EXPECT_TRUE(std::ranges::includes(mesh.nodes("held_in_tension"), mesh.nodes("inner")));
    EXPECT_TRUE(std::ranges::includes(mesh.nodes("held_in_tension"), mesh.nodes("rim")));
    std::set<Index> supported(mesh.nodes("rim").begin(), mesh.nodes("rim").end());
    EXPECT_FALSE(supported.empty()) << options;
    for (const char* name : {"zygomatic", "nose", "orbit", "mandibular"}) {
      EXPECT_FALSE(mesh.nodes(name).empty()) << options << " " << name;
      EXPECT_TRUE(std::ranges::includes(mesh.nodes("inner"), mesh.nodes(name))) << name;
      for (const Index node : mesh.nodes(name))
        EXPECT_TRUE(supported.insert(node).second) << options << " twice: " << node;
    }
  }
}

// The border of the face from the hairline past the ears to the neck, and not that of the mouth, an eye or a nostril.
TEST(BuiltinFace, HasItsRimAroundTheFace) {
  const FaceAnatomy& face = face_of("size=coarse");
  const std::span<const Index> rim = face.mesh.nodes("rim");
  const auto is_in_rim = [&](const char* point) {
    return std::ranges::binary_search(rim, drawings().skin.index.at(point));
  };
  for (const char* point : {"f0.0", "f0.12", "k0.12", "w2.0", "w2.12-left"})
    EXPECT_TRUE(is_in_rim(point)) << point;
  for (const char* point : {"lip0.0", "low0.0", "lip0.6", "eye0.0", "nostril.0", "k0.0"})
    EXPECT_FALSE(is_in_rim(point)) << point;
  EXPECT_TRUE(std::ranges::includes(face.mesh.nodes("border"), rim));
}

TEST(BuiltinFace, HasLandmarksOnItsSkinInTheirPlaces) {
  const FaceAnatomy& face = face_of("size=standard");
  const auto x = [&](const std::string& name) {
    return face.mesh.X()[at(std::ranges::find(face.landmarks, name, &Landmark::name)->node)];
  };
  for (const Landmark& landmark : face.landmarks)
    EXPECT_TRUE(std::ranges::binary_search(face.mesh.nodes("outer"), landmark.node));
  EXPECT_LT((x("RMC") - mirror_image(x("LMC"))).norm(), 1e-9);
  EXPECT_GT(x("RMC").y(), 0.0) << "+y is the subject's right";
  EXPECT_LT(x("PRN").x(), x("SN").x()) << "-x is anterior";
  EXPECT_GT(x("N").z(), x("PG").z());
  for (const LandmarkPair& pair : face.pairs)
    EXPECT_GT((x(pair.a) - x(pair.b)).norm(), 1.0);
}

TEST(BuiltinFace, HasSkinAxesThatAreRotations) {
  const FaceAnatomy& face = face_of("size=standard");
  ASSERT_EQ(face.axes.size(), face.mesh.n_elements());
  for (const Mat3& axes : face.axes) {
    EXPECT_LT((axes.transpose() * axes - Mat3::Identity()).norm(), 1e-9);
    EXPECT_GT(axes.determinant(), 0.0);
  }
}

TEST(BuiltinFace, IsMadeOfEachFileOnce) {
  const std::vector<std::filesystem::path>& files = face_of("size=coarse").files;
  EXPECT_EQ(std::set(files.begin(), files.end()).size(), files.size());
  for (const auto& file : files)
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

TEST(BuiltinFace, IsTheSameTwice) {
  const FaceAnatomy& once = face_of("size=coarse");
  const FaceAnatomy again = make_builtin_face("size=coarse", builtin_folder());
  EXPECT_TRUE(std::ranges::equal(once.mesh.X(), again.mesh.X()));
  EXPECT_EQ(once.axes, again.axes);
  EXPECT_EQ(once.mesh.node_sets(), again.mesh.node_sets());
  ASSERT_EQ(once.muscle_paths.size(), again.muscle_paths.size());
  for (std::size_t m = 0; m < once.muscle_paths.size(); ++m) {
    for (std::size_t p = 0; p < once.muscle_paths[m].paths.size(); ++p)
      EXPECT_EQ(once.muscle_paths[m].paths[p].points, again.muscle_paths[m].paths[p].points);
  }
}

}  // namespace
}  // namespace facies::anatomy
