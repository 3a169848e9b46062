// SPDX-License-Identifier: Apache-2.0
// The skin tension lines of the built-in face: axes by region, singular points, symmetry, sizes of the mesh.
#include <algorithm>
#include <cmath>
#include <complex>
#include <gmock/gmock.h>
#include <map>
#include <numbers>

#include "anatomy/builtin_files.hpp"
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "facies/anatomy/builtin_face.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::anatomy {
namespace {

using ::testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180.0;

const FaceAnatomy& face_of(const std::string& options) {
  static std::map<std::string, FaceAnatomy> made;
  const auto found = made.find(options);
  if (found != made.end()) return found->second;
  return made.emplace(options, make_builtin_face(options, builtin_folder())).first->second;
}

const std::vector<std::string>& sizes() {
  static const std::vector<std::string> all{"size=coarse", "size=standard", "size=fine"};
  return all;
}

/// An element of the skin below one quadrilateral of the outer surface.
struct Patch {
  std::vector<Index> nodes;  ///< counter-clockwise seen from outside
  Vec3 centre, line, normal;
  double area = 0.0;  ///< [mm^2]
};

std::vector<Patch> patches_of(const FaceAnatomy& face) {
  std::vector<Patch> patches;
  for (const mesh::Face f : face.mesh.faces("outer")) {
    Patch patch{face.mesh.face_nodes(f), Vec3::Zero(), face.axes[at(f.element)].col(0),
                face.axes[at(f.element)].col(1)};
    for (const Index n : patch.nodes)
      patch.centre += 0.25 * face.mesh.X()[at(n)];
    patch.area = mesh::area_vector(face.mesh, f, face.mesh.X()).norm();
    patches.push_back(patch);
  }
  return patches;
}

/// A box in the frontal view [mm], right half and mirror image of the left one, and the axis there [degrees]: 0 level, positive where
/// the line rises laterally.
struct Region {
  const char* name;
  double medial, lateral, low, high;
  double axis, coherence;
};

/// Mean axis of the skin lines of flynn2015 in the frontal plane and how far they agree (1: parallel), from the element rotations published with
/// its model (artisynth_models, data/rstl_rotMat_badin_old.txt). The boxes give these values on that face too, within 10 degrees where the
/// coherence is 0.75 or more, once heights and widths are those of its own landmarks.
const std::vector<Region>& regions() {
  static const std::vector<Region> all{{"forehead", 5, 55, 78, 105, -8, 0.98},
                                       {"glabella", 0, 12, 58, 74, -3, 0.99},
                                       {"upper lid and brow", 15, 50, 51, 66, -13, 0.93},
                                       {"lower lid", 16, 46, 24, 40, -20, 0.90},
                                       {"nose", 0, 14, 18, 48, -21, 0.54},
                                       {"columella", 0, 5, 0, 8, 90, 1.00},
                                       {"temple", 52, 68, 42, 68, -53, 0.64},
                                       {"zygoma", 50, 64, 12, 38, -74, 0.77},
                                       {"medial cheek", 20, 42, -16, 18, -71, 0.55},
                                       {"lateral cheek", 54, 75, -30, 8, 75, 0.89},
                                       {"upper lip", 2, 22, -16, -2, -86, 0.98},
                                       {"lower lip", 2, 20, -38, -29, -88, 0.98},
                                       {"chin", 0, 20, -68, -46, 28, 0.46},
                                       {"jowl", 24, 48, -62, -32, 60, 0.77}};
  return all;
}

struct MeanAxis {
  double axis = 0.0;       ///< [degrees]
  double coherence = 0.0;  ///< 0 to 1
};

/// The mean over the region's area, without what looks backwards.
MeanAxis mean_axis(const std::vector<Patch>& patches, const Region& region) {
  std::complex<double> sum = 0.0;
  double area = 0.0;
  for (const Patch& patch : patches) {
    const double side = patch.centre.y() < 0.0 ? -1.0 : 1.0;
    const double lateral = side * patch.centre.y();
    const double up = patch.centre.z();
    const bool is_inside = lateral >= region.medial && lateral <= region.lateral &&
                           up >= region.low && up <= region.high;
    if (!is_inside || patch.normal.x() > 0.3) continue;
    sum += patch.area * std::polar(1.0, 2.0 * std::atan2(patch.line.z(), side * patch.line.y()));
    area += patch.area;
  }
  return {0.5 * std::arg(sum) / degree, std::abs(sum) / area};
}

TEST(BuiltinLines, HaveTheAxesOfThePublishedFieldInEveryRegion) {
  constexpr double coherent = 0.75;
  for (const std::string& size : sizes()) {
    const std::vector<Patch> patches = patches_of(face_of(size));
    for (const Region& region : regions()) {
      const MeanAxis mean = mean_axis(patches, region);
      RecordProperty(size + " " + region.name, fmt::format("{:.1f} degrees", mean.axis));
      if (region.coherence < coherent) continue;
      EXPECT_LT(std::abs(std::remainder(mean.axis - region.axis, 180.0)), 15.0)
          << size << " " << region.name << ": " << mean.axis;
      EXPECT_GT(mean.coherence, coherent) << size << " " << region.name;
    }
  }
}

/// What turns a patch's tangent plane into another's, without turning about the normal.
Eigen::Quaterniond roll(const Patch& from, const Patch& to) {
  return Eigen::Quaterniond::FromTwoVectors(from.normal, to.normal);
}

/// The angle from v to w about the normal.
double angle(const Vec3& v, const Vec3& w, const Vec3& normal) {
  return std::atan2(normal.dot(v.cross(w)), v.dot(w));
}

/// The patches around each node, counter-clockwise; nothing for nodes at borders.
std::map<Index, std::vector<const Patch*>> rings_of(const std::vector<Patch>& patches) {
  std::map<std::pair<Index, Index>, const Patch*> along;
  for (const Patch& patch : patches) {
    for (std::size_t k = 0; k < 4; ++k)
      along[{patch.nodes[k], patch.nodes[(k + 1) % 4]}] = &patch;
  }
  std::map<Index, std::vector<const Patch*>> rings;
  for (const auto& [edge, first] : along) {
    const Index node = edge.first;
    if (rings.contains(node)) continue;
    std::vector<const Patch*>& ring = rings[node];
    for (const Patch* patch = first; patch != nullptr;) {
      ring.push_back(patch);
      const auto k =
          static_cast<std::size_t>(std::ranges::find(patch->nodes, node) - patch->nodes.begin());
      const auto next = along.find({node, patch->nodes[(k + 3) % 4]});
      if (next == along.end()) ring.clear();
      patch = next == along.end() || next->second == first ? nullptr : next->second;
    }
  }
  return rings;
}

/// How often the lines turn around a node as one goes round it once (1/2: half a turn the same way).
double index_at(const std::vector<const Patch*>& ring) {
  double turned = 0.0;
  Vec3 carried = ring.front()->line;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Patch& from = *ring[i];
    const Patch& to = *ring[(i + 1) % ring.size()];
    const double whole = angle(roll(from, to) * from.line, to.line, to.normal);
    turned += std::remainder(whole, std::numbers::pi);
    carried = roll(from, to) * carried;
  }
  // What is carried round comes back turned by the curvature inside.
  turned += angle(ring.front()->line, carried, ring.front()->normal);
  return turned / (2.0 * std::numbers::pi);
}

TEST(BuiltinLines, AreSingularAtTheTipOfTheNoseAndInTheLabiomentalHollowOnly) {
  std::vector<std::string> faces = sizes();
  faces.emplace_back("preset=female");
  for (const std::string& options : faces) {
    const FaceAnatomy& face = face_of(options);
    const std::vector<Patch> patches = patches_of(face);
    std::vector<Vec3> singular;
    for (const auto& [node, ring] : rings_of(patches)) {
      if (ring.empty()) continue;
      const double index = index_at(ring);
      EXPECT_NEAR(2.0 * index, std::round(2.0 * index), 1e-6);
      if (std::abs(index) < 0.25) continue;
      EXPECT_NEAR(index, 0.5, 1e-6) << options;
      singular.push_back(face.mesh.X()[at(node)]);
    }
    std::ranges::sort(singular, {}, [](const Vec3& x) { return -x.z(); });
    ASSERT_EQ(singular.size(), 2U) << options;
    const auto landmark = [&](const char* name) {
      return face.mesh.X()[at(std::ranges::find(face.landmarks, name, &Landmark::name)->node)];
    };
    EXPECT_LT((singular[0] - landmark("PRN")).norm(), 3.0) << options << " " << singular[0];
    EXPECT_LT((singular[1] - landmark("SL")).norm(), 3.0) << options << " " << singular[1];
    for (const Vec3& x : singular)
      EXPECT_NEAR(x.y(), 0.0, 1e-9) << options;
  }
}

// Away from the singular points neighbours, 4 mm apart in the middle, differ by the bends of the drawn lines alone.
TEST(BuiltinLines, TurnLittleFromElementToElementElsewhere) {
  constexpr double around = 8.0;  // [mm]
  const FaceAnatomy& face = face_of("size=standard");
  std::vector<Vec3> singular;
  for (const Landmark& landmark : face.landmarks) {
    if (landmark.name == "PRN" || landmark.name == "SL")
      singular.push_back(face.mesh.X()[at(landmark.node)]);
  }
  const std::vector<Patch> patches = patches_of(face);
  std::vector<double> turns;
  for (const auto& [node, ring] : rings_of(patches)) {
    const Vec3& x = face.mesh.X()[at(node)];
    const bool is_near = std::ranges::any_of(
        singular, [&](const Vec3& point) { return (point - x).norm() < around; });
    if (is_near) continue;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Patch& to = *ring[(i + 1) % ring.size()];
      const double whole = angle(roll(*ring[i], to) * ring[i]->line, to.line, to.normal);
      turns.push_back(std::abs(std::remainder(whole, std::numbers::pi)) / degree);
    }
  }
  std::ranges::sort(turns);
  EXPECT_LT(turns[turns.size() / 2], 5.0);
  EXPECT_LT(turns[turns.size() * 99 / 100], 25.0);
  EXPECT_LT(turns.back(), 40.0);
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) / degree;
}

TEST(BuiltinLines, AreMirrorImages) {
  for (const std::string& size : sizes()) {
    std::vector<Patch> right = patches_of(face_of(size));
    const auto middle =
        std::ranges::partition(right, [](const Patch& p) { return p.centre.y() > 0.0; });
    std::vector<Patch> left(middle.begin(), middle.end());
    right.erase(middle.begin(), middle.end());
    ASSERT_EQ(left.size(), right.size());
    for (Patch& patch : left) {
      for (Vec3* v : {&patch.centre, &patch.line, &patch.normal})
        v->y() = -v->y();
    }
    for (const Patch& patch : right) {
      const auto twin = std::ranges::min_element(
          left, {}, [&](const Patch& other) { return (other.centre - patch.centre).norm(); });
      ASSERT_LT((twin->centre - patch.centre).norm(), 1e-9);
      EXPECT_LT(angle_between(twin->line, patch.line), 1e-4) << size << " " << patch.centre;
    }
  }
}

// Each patch of a size is four of the next one, in the order of the patches. Compared in the tangent plane of the larger one.
TEST(BuiltinLines, AgreeBetweenSizesOfTheMesh) {
  for (std::size_t s = 0; s + 1 < sizes().size(); ++s) {
    const std::vector<Patch> coarse = patches_of(face_of(sizes()[s]));
    const std::vector<Patch> fine = patches_of(face_of(sizes()[s + 1]));
    ASSERT_EQ(fine.size(), 4 * coarse.size());
    std::vector<double> angles;
    for (std::size_t p = 0; p < coarse.size(); ++p) {
      std::complex<double> sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Patch& part = fine[4 * p + k];
        const Vec3 line = roll(part, coarse[p]) * part.line;
        sum += std::polar(part.area, 2.0 * angle(coarse[p].line, line, coarse[p].normal));
      }
      angles.push_back(std::abs(0.5 * std::arg(sum)) / degree);
    }
    std::ranges::sort(angles);
    EXPECT_LT(angles[angles.size() / 2], 0.5);
    EXPECT_LT(angles[angles.size() * 95 / 100], 2.0) << sizes()[s];
    EXPECT_LT(angles.back(), 10.0) << sizes()[s];
  }
}

TEST(BuiltinLines, ThatCrossAnEyeBetweenTwoPointsSayWhere) {
  BuiltinFiles files;
  files.append("tension-lines.csv", "eye,33,60");
  files.append("tension-lines.csv", "eye,33,20");
  std::string told;
  try {
    (void)make_builtin_face("size=coarse", files.path());
  } catch (const DataError& error) {
    told = error.what();
  }
  EXPECT_THAT(told, HasSubstr("tension-lines.csv"));
  EXPECT_THAT(told, HasSubstr("is not on the face"));
  EXPECT_THAT(told, HasSubstr("(33, "));
}

}  // namespace
}  // namespace facies::anatomy
