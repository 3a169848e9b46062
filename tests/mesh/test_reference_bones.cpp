// SPDX-License-Identifier: Apache-2.0
// The bones of the reference face against what its README (section 13) says of them, and intersections against a script
// in exact rational arithmetic. Skipped where they are not at hand.
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "facies/mesh/nearest.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class ReferenceBones : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* variable = std::getenv("FACIES_REFERENCE_FACE");  // NOLINT(concurrency-mt-unsafe)
    const std::filesystem::path upstream =
        variable != nullptr
            ? std::filesystem::path(variable)
            : std::filesystem::path(FACIES_SOURCE_DIR) / "../shared/reference-face/upstream";
    folder_ = upstream / "face/geometry";
    if (!std::filesystem::exists(folder_ / "badinjaw.obj")) {
      GTEST_SKIP() << "the reference face is not here: set FACIES_REFERENCE_FACE to the folder "
                      "that holds 'face'";
    }
  }

  [[nodiscard]] TriangleSurface bone(const std::string& name) const {
    Problems problems;
    TriangleSurface surface = read_obj(folder_ / name, 1000.0, problems);
    problems.throw_if_any<DataError>();
    return merge_coincident_vertices(surface);
  }

  std::filesystem::path folder_;
};

TEST_F(ReferenceBones, AreReadWhateverProgramWroteThem) {
  int n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() != ".obj") continue;
    EXPECT_GT(bone(entry.path().filename()).triangles.size(), 1000U) << entry.path();
    ++n;
  }
  EXPECT_GE(n, 3);
}

TEST_F(ReferenceBones, HaveAClosedJaw) {
  const TriangleSurface jaw = bone("badinjaw.obj");
  const SurfaceReport report = check_surface(jaw);
  EXPECT_THAT(jaw.triangles, SizeIs(4184));
  EXPECT_TRUE(report.is_closed());
  EXPECT_GT(report.volume, 0.0);
  EXPECT_THAT(report.intersections,
              ElementsAre(TrianglePair{38, 983}, TrianglePair{658, 1053}, TrianglePair{2094, 3039},
                          TrianglePair{2714, 3109}));
}

TEST_F(ReferenceBones, IntersectThemselvesAsExactArithmeticSays) {
  EXPECT_THAT(check_surface(bone("badinmaxilla.obj")).intersections, IsEmpty());
  EXPECT_THAT(check_surface(bone("ubccranium.obj")).intersections, SizeIs(41));
  EXPECT_THAT(check_surface(bone("ubcmaxilla.obj")).intersections, SizeIs(691));
}

TEST_F(ReferenceBones, HaveAnOpenMaxilla) {
  const TriangleSurface maxilla = bone("badinmaxilla.obj");
  const SurfaceReport report = check_surface(maxilla);
  EXPECT_THAT(maxilla.triangles, SizeIs(5808));
  EXPECT_THAT(report.border_edges, SizeIs(160));
  EXPECT_LT(report.upper.y(), 40.0);
  EXPECT_GT(report.lower.y(), -40.0);
}

TEST_F(ReferenceBones, HaveAnOpenCranium) {
  const TriangleSurface cranium = bone("badincranium.obj");
  const SurfaceReport report = check_surface(cranium);
  EXPECT_THAT(cranium.triangles, SizeIs(1156));
  EXPECT_FALSE(report.is_closed());
  EXPECT_NEAR(report.lower.x(), 78.7, 0.1);
  EXPECT_NEAR(report.lower.z(), 146.5, 0.1);
}

}  // namespace
}  // namespace facies::mesh
