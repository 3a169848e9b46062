// SPDX-License-Identifier: Apache-2.0
// The muscles of expression of the built-in face: where they run and which elements are theirs.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_face.hpp"
#include "facies/anatomy/builtin_muscles.hpp"
#include "facies/anatomy/muscle_band.hpp"
#include "facies/mesh/segments.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

const fs::path data = fs::path(FACIES_SOURCE_DIR) / "data" / "builtin";

/// A face of a size with its muscles, made once.
struct Sample {
  FaceAnatomy face;
  std::vector<Muscle> muscles;
};

const Sample& sample(const std::string& options) {
  static std::map<std::string, Sample> made;
  const auto found = made.find(options);
  if (found != made.end()) return found->second;
  Sample& sample = made[options];
  sample.face = make_builtin_face(options, data);
  sample.muscles = select_muscles(sample.face, {6.0, 3.0}, 1.1);
  return sample;
}

const MusclePaths& paths_of(const FaceAnatomy& face, const std::string& name) {
  const auto found = std::ranges::find(face.muscle_paths, name, &MusclePaths::name);
  require(found != face.muscle_paths.end(), "the face has this muscle");
  return *found;
}

/// The fibres of the right half.
std::vector<FibrePath> right_paths(const FaceAnatomy& face, const std::string& name) {
  std::vector<FibrePath> paths;
  for (const FibrePath& path : paths_of(face, name).paths) {
    if (path.side != Side::left) paths.push_back(path);
  }
  return paths;
}

Vec3 landmark(const FaceAnatomy& face, const std::string& name) {
  const auto found = std::ranges::find(face.landmarks, name, &Landmark::name);
  require(found != face.landmarks.end(), "the face has this landmark");
  return face.mesh.X()[at(found->node)];
}

double length(const FibrePath& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

/// Pairs of positions in muscle.elements that share a face.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(const mesh::Mesh& mesh,
                                                            const Muscle& muscle) {
  std::map<std::vector<Index>, std::size_t> first_with;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < muscle.elements.size(); ++i) {
    for (std::uint8_t local = 0; local < 6; ++local) {
      std::vector<Index> nodes = mesh.face_nodes({muscle.elements[i], local});
      std::ranges::sort(nodes);
      const auto [found, is_new] = first_with.try_emplace(nodes, i);
      if (!is_new) pairs.emplace_back(found->second, i);
    }
  }
  return pairs;
}

/// The sizes of the parts of a muscle that do not hang together, ascending.
std::vector<std::size_t> pieces(const mesh::Mesh& mesh, const Muscle& muscle) {
  std::vector<std::size_t> piece(muscle.elements.size());
  for (std::size_t i = 0; i < piece.size(); ++i)
    piece[i] = i;
  const auto root = [&](std::size_t i) {
    while (piece[i] != i)
      i = piece[i];
    return i;
  };
  for (const auto& [a, b] : neighbours(mesh, muscle))
    piece[root(b)] = root(a);
  std::map<std::size_t, std::size_t> sizes;
  for (std::size_t i = 0; i < piece.size(); ++i)
    ++sizes[root(i)];
  std::vector<std::size_t> sorted;
  for (const auto& [first, size] : sizes)
    sorted.push_back(size);
  std::ranges::sort(sorted);
  return sorted;
}

class BuiltinMusclesAtSize : public testing::TestWithParam<const char*> {};

TEST_P(BuiltinMusclesAtSize, AreAllThere) {
  const auto names = {
      "ZYG_L",  "ZYG_R",  "LLSAN_L", "LLSAN_R", "LAO_L",  "LAO_R",  "RIS_L",  "RIS_R",  "BUC_L",
      "BUC_R",  "DAO_L",  "DAO_R",   "DLI_L",   "DLI_R",  "MENT_L", "MENT_R", "OOP",    "OOM",
      "LLS_L",  "LLS_R",  "ZYGm_L",  "ZYGm_R",  "FRO_L",  "FRO_R",  "COR_L",  "COR_R",  "PROC_L",
      "PROC_R", "OOcP_L", "OOcP_R",  "OOcO_L",  "OOcO_R", "NAS_L",  "NAS_R",  "PLAT_L", "PLAT_R"};
  std::vector<std::string> found;
  for (const Muscle& muscle : sample(GetParam()).muscles)
    found.push_back(muscle.name);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(names));
}

TEST_P(BuiltinMusclesAtSize, HangTogether) {
  const auto& [face, muscles] = sample(GetParam());
  for (const Muscle& muscle : muscles) {
    EXPECT_EQ(without_lone_elements(face.mesh, muscle.elements), muscle.elements) << muscle.name;
    EXPECT_THAT(pieces(face.mesh, muscle), testing::SizeIs(1)) << muscle.name;
  }
}

TEST_P(BuiltinMusclesAtSize, TurnLittleFromElementToElement) {
  const auto& [face, muscles] = sample(GetParam());
  // A ring of radius 15 mm round the eye turns by 40 degrees from one element of 10 mm to the next.
  const double most = std::string(GetParam()) == "size=coarse" ? 60.0 : 30.0;
  for (const Muscle& muscle : muscles) {
    std::size_t n_sharp = 0;
    const auto pairs = neighbours(face.mesh, muscle);
    for (const auto& [a, b] : pairs) {
      const double cosine = std::abs(muscle.directions[a].dot(muscle.directions[b]));
      n_sharp += cosine < std::cos(most * std::numbers::pi / 180.0) ? 1 : 0;
    }
    EXPECT_LE(static_cast<double>(n_sharp), 0.03 * static_cast<double>(pairs.size()))
        << muscle.name;
  }
}

TEST_P(BuiltinMusclesAtSize, AreMirrorImages) {
  const auto& [face, muscles] = sample(GetParam());
  for (const Muscle& left : muscles) {
    if (left.side != Side::left) continue;
    const Muscle& right = *std::ranges::find_if(muscles, [&](const Muscle& muscle) {
      return muscle.side == Side::right && muscle.group == left.group;
    });
    std::size_t n_alone = 0;
    for (const Index e : left.elements) {
      const Vec3 c = face.mesh.centroid(e);
      const Vec3 mirrored(c.x(), -c.y(), c.z());
      // The mesh is its own mirror image within a tenth of a millimetre.
      n_alone += std::ranges::none_of(right.elements,
                                      [&](Index other) {
                                        return (face.mesh.centroid(other) - mirrored).norm() < 0.1;
                                      })
                     ? 1
                     : 0;
    }
    EXPECT_LE(n_alone, 2 + left.elements.size() / 50) << left.group;
    const auto n_left = static_cast<double>(left.elements.size());
    EXPECT_NEAR(n_left, static_cast<double>(right.elements.size()), 2.0 + 0.01 * n_left)
        << left.group;
  }
}

TEST_P(BuiltinMusclesAtSize, StayBelowTheSkin) {
  const auto& [face, muscles] = sample(GetParam());
  for (const Muscle& muscle : muscles) {
    for (const Index e : face.mesh.elements("skin"))
      EXPECT_FALSE(std::ranges::binary_search(muscle.elements, e)) << muscle.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, BuiltinMusclesAtSize,
                         testing::Values("size=coarse", "size=standard", "size=fine"));

TEST(BuiltinMuscles, HaveTheLengthsThatDissectionsFind) {
  // Means and ranges of adult muscles: ZYG Sarilita et al. 2021 and cadaver series (belly 45.5, to its skin end 56), COR Janis et al. 2007 with
  // its ends, the others the ranges of anatomy texts.
  const std::map<std::string, std::array<double, 2>> ranges{
      {"ZYG", {42, 60}},  {"LLSAN", {25, 60}}, {"LAO", {25, 38}}, {"RIS", {20, 50}},
      {"BUC", {15, 55}},  {"DAO", {25, 42}},   {"DLI", {20, 30}}, {"MENT", {14, 25}},
      {"LLS", {30, 45}},  {"ZYGm", {32, 45}},  {"FRO", {32, 60}}, {"COR", {23, 36}},
      {"PROC", {20, 28}}, {"NAS", {25, 36}}};
  const FaceAnatomy& face = sample("size=coarse").face;
  for (const auto& [name, range] : ranges) {
    for (const FibrePath& path : right_paths(face, name)) {
      EXPECT_GE(length(path), range[0]) << name;
      EXPECT_LE(length(path), range[1]) << name;
    }
  }
}

TEST(BuiltinMuscles, MeetInTheModiolusBesideTheMouthCorner) {
  const FaceAnatomy& face = sample("size=fine").face;
  const Vec3 corner = landmark(face, "RMC");
  const auto skin_over = [&](const Vec3& x) {
    const auto distance = [&](Index node) { return (face.mesh.X()[at(node)] - x).norm(); };
    return face.mesh.X()[at(*std::ranges::min_element(face.mesh.nodes("outer"), {}, distance))];
  };
  // 14.4 lateral in young Koreans, 10 to 12 in Westerners; 20 high and 10 thick.
  for (const char* name : {"ZYG", "RIS", "DAO"}) {
    for (const FibrePath& path : right_paths(face, name)) {
      const Vec3 over = skin_over(path.points.back());
      EXPECT_NEAR((over - corner).norm(), 12.0, 4.0) << name;
      EXPECT_NEAR(over.z() - corner.z(), 0.0, 8.0) << name;
      EXPECT_GT(over.y(), corner.y() + 5.0) << name;
    }
  }
  const Vec3 end_of_zygomaticus = right_paths(face, "ZYG").front().points.back();
  for (const char* name : {"LAO", "BUC"}) {
    for (const FibrePath& path : right_paths(face, name))
      EXPECT_LT((path.points.back() - end_of_zygomaticus).norm(), 10.0) << name;
  }
}

TEST(BuiltinMuscles, OfTheEyesAreClosedRoundEachFissure) {
  const FaceAnatomy& face = sample("size=coarse").face;
  const Vec3 corner = landmark(face, "RC");
  for (const char* name : {"OOcP", "OOcO"}) {
    for (const FibrePath& path : right_paths(face, name)) {
      EXPECT_EQ(path.side, Side::right);
      EXPECT_TRUE(path.closed);
      const auto [medial, lateral] =
          std::ranges::minmax(path.points, {}, [](const Vec3& x) { return x.y(); });
      EXPECT_GT(medial.y(), 0.0);
      EXPECT_LT(medial.y(), corner.y());
      EXPECT_GT(lateral.y(), corner.y() + 28.0);
    }
  }
}

TEST(BuiltinMuscles, FollowAFaceThatChanges) {
  // The mouth of a woman is narrower; the muscles that end beside it come along.
  const FaceAnatomy& he = sample("size=coarse").face;
  const FaceAnatomy& she = sample("size=coarse,preset=female").face;
  for (const char* name : {"ZYG", "LAO", "DAO"}) {
    const Vec3 his = right_paths(he, name).front().points.back() - landmark(he, "RMC");
    const Vec3 hers = right_paths(she, name).front().points.back() - landmark(she, "RMC");
    EXPECT_LT((his - hers).norm(), 2.0) << name;
  }
  for (const Muscle& muscle : sample("size=coarse,preset=female").muscles)
    EXPECT_THAT(pieces(she.mesh, muscle), testing::SizeIs(1)) << muscle.name;
}

TEST(SmoothPoints, GoThroughTheDrawnOnes) {
  const DrawnFibre fibre{"M", "1", FibreForm::fibre, {{10, 0, 0.9}, {14, 9, 0.5}, {12, 20, 0.4}}};
  const std::vector<DrawnPoint> points = smooth_points(fibre, 2.0);
  for (const DrawnPoint& drawn : fibre.points) {
    EXPECT_TRUE(std::ranges::any_of(points, [&](const DrawnPoint& p) {
      return std::hypot(p.lateral - drawn.lateral, p.up - drawn.up, p.depth - drawn.depth) < 1e-12;
    }));
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(
        std::hypot(points[i].lateral - points[i - 1].lateral, points[i].up - points[i - 1].up),
        2.5);
    EXPECT_LE(points[i].depth, points[i - 1].depth);
  }
}

TEST(SmoothPoints, OfALoopOnACircleStayNearIt) {
  DrawnFibre loop{"M", "1", FibreForm::loop, {}};
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6.0;
    loop.points.push_back({30.0 + 20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.5});
  }
  for (const DrawnPoint& p : smooth_points(loop, 1.0))
    EXPECT_NEAR(std::hypot(p.lateral - 30.0, p.up), 20.0, 0.06);
}

TEST(SmoothPoints, OfARingCrossTheMidlineAtARightAngle) {
  const DrawnFibre ring{
      "M", "1", FibreForm::ring, {{0, 10, 0.5}, {10, 6, 0.5}, {10, -6, 0.5}, {0, -10, 0.5}}};
  const std::vector<DrawnPoint> points = smooth_points(ring, 0.1);
  EXPECT_DOUBLE_EQ(points.front().lateral, 0.0);
  EXPECT_DOUBLE_EQ(points.back().lateral, 0.0);
  EXPECT_NEAR(points[1].up, 10.0, 0.02 * points[1].lateral);
  EXPECT_NEAR(points[points.size() - 2].up, -10.0, 0.02 * points[points.size() - 2].lateral);
}

/// The drawings with muscles and paths of our own.
class MuscleTables : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy(data, folder_, fs::copy_options::recursive);
    write("muscles.csv", "name,meaning,width_mm,thickness_mm,course,source\nM,a muscle,5,1,,\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::trunc) << text;
  }
  /// What reading says with these rows of muscle-paths.csv.
  [[nodiscard]] std::string complaint(const std::string& rows) const {
    write("muscle-paths.csv", "muscle,fibre,form,lateral_mm,up_mm,depth\n" + rows);
    try {
      (void)read_drawings(folder_);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("builtin_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(MuscleTables, MayHoldFibresRingsAndLoops) {
  EXPECT_EQ(complaint("M,1,fibre,30,60,0.5\nM,1,fibre,30,70,0.5\n"
                      "M,2,ring,0,-10,0.5\nM,2,ring,0,-36,0.5\n"
                      "M,3,loop,20,80,0.5\nM,3,loop,30,80,0.5\nM,3,loop,25,90,0.5\n"),
            "");
}

TEST_F(MuscleTables, SayWhatIsWrongWithAFibre) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(
      complaint("M,1,rope,30,60,0.5\nM,1,rope,30,70,0.5\n"),
      AllOf(HasSubstr("muscle-paths.csv:2:"), HasSubstr("rope"), HasSubstr("fibre, ring or loop")));
  EXPECT_THAT(complaint("N,1,fibre,30,60,0.5\nN,1,fibre,30,70,0.5\n"),
              HasSubstr("a muscle of muscles.csv"));
  EXPECT_THAT(complaint("M,1,fibre,30,60,0.5\n"), HasSubstr("at least 2"));
  EXPECT_THAT(complaint("M,1,loop,30,60,0.5\nM,1,loop,30,70,0.5\n"), HasSubstr("at least 3"));
  EXPECT_THAT(complaint("M,1,ring,30,60,0.5\nM,1,ring,0,40,0.5\n"),
              AllOf(HasSubstr("30; expected 0"), HasSubstr("a ring on one side is a loop")));
}

TEST_F(MuscleTables, SayThatABandNeedsASize) {
  write("muscles.csv", "name,meaning,width_mm,thickness_mm,course,source\nM,a muscle,0,-1,,\n");
  EXPECT_THAT(complaint("M,1,fibre,30,60,0.5\nM,1,fibre,30,70,0.5\n"),
              testing::AllOf(testing::HasSubstr("0 mm"), testing::HasSubstr("-1 mm"),
                             testing::HasSubstr("more than 0 mm")));
}

TEST_F(MuscleTables, SayWhichFibreLeavesTheFace) {
  ASSERT_EQ(complaint("M,1,fibre,30,60,0.5\nM,1,fibre,30,170,0.5\n"), "");
  try {
    (void)make_builtin_face("size=coarse", folder_);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("muscle-paths.csv:3:11: (30, 170) is not on the face"));
  }
}

}  // namespace
}  // namespace facies::anatomy
