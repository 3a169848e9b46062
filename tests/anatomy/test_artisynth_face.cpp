// SPDX-License-Identifier: Apache-2.0
// Reading a face in the layout of artisynth_models, on a small face written by the test.
#include <gmock/gmock.h>

#include "anatomy/synthetic_face.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/quality.hpp"

namespace facies::anatomy {
namespace {

TEST(ArtisynthFace, GivesBackTheMeshThatWasWritten) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  const mesh::Mesh& sheet = files.sheet();
  ASSERT_EQ(face.mesh.n_nodes(), sheet.n_nodes());
  ASSERT_EQ(face.mesh.n_elements(), sheet.n_elements());
  for (std::size_t n = 0; n < sheet.n_nodes(); ++n)
    EXPECT_LT((face.mesh.X()[n] - sheet.X()[n]).norm(), 1e-12);
  for (std::size_t e = 0; e < sheet.n_elements(); ++e)
    EXPECT_EQ(face.mesh.elements()[e].nodes, sheet.elements()[e].nodes) << e;
  EXPECT_FALSE(face.is_reference_face);
}

TEST(ArtisynthFace, FindsLayersAndSurfacesFromTheNodeLists) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  for (const std::string& layer : layer_names()) {
    EXPECT_THAT(face.mesh.elements(layer),
                testing::ElementsAreArray(files.sheet().elements(layer)));
  }
  EXPECT_THAT(face.mesh.faces("outer"), testing::ElementsAreArray(files.sheet().faces("outer")));
  EXPECT_THAT(face.mesh.faces("inner"), testing::ElementsAreArray(files.sheet().faces("inner")));
  EXPECT_THAT(face.mesh.nodes("outer"), testing::ElementsAreArray(files.sheet().nodes("outer")));
}

TEST(ArtisynthFace, ReadsListsThatCountFromZeroAsSuch) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  EXPECT_THAT(face.mesh.nodes("mandibular"),
              testing::ElementsAreArray(files.sheet().nodes("y_min")));
  EXPECT_THAT(face.mesh.nodes("rim"), testing::ElementsAreArray(files.sheet().nodes("rim")));
}

TEST(ArtisynthFace, ProjectsTheFirstMatrixColumnOnTheSkin) {
  // The matrix says a1 = (0.6, 0, 0.8); the skin looks along -x.
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  Mat3 expected;
  expected << 0, -1, 0,  //
      0, 0, -1,          //
      1, 0, 0;
  for (const Index e : face.mesh.elements("skin"))
    EXPECT_LT((face.axes[at(e)] - expected).norm(), 1e-12) << e;
}

TEST(ArtisynthFace, MovesFibrePointsIntoTheTissueAndMirrorsTheLeft) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  const MusclePaths& muscle = face.muscle_paths.at(0);
  ASSERT_EQ(muscle.name, "ZYG");
  ASSERT_EQ(muscle.paths.size(), 2U);
  const std::vector<Vec3> left{{4, -30, -20}, {0, -30, 0}, {4, -30, 20}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT((muscle.paths[0].points.at(i) - left[i]).norm(), 1e-9);
    const Vec3 mirrored(left[i].x(), -left[i].y(), left[i].z());
    EXPECT_LT((muscle.paths[1].points.at(i) - mirrored).norm(), 1e-9);
  }
  EXPECT_EQ(muscle.paths[0].side, Side::left);
  EXPECT_EQ(muscle.paths[1].side, Side::right);
}

TEST(ArtisynthFace, RunsRingsThroughTheHexahedraOfTheirList) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  const FibrePath& ring = face.muscle_paths.at(1).paths.at(0);
  EXPECT_TRUE(ring.closed);
  EXPECT_EQ(ring.side, Side::middle);
  std::vector<Vec3> expected;
  for (const Index e : {0, 1, 2, 3, 6, 8}) {
    if (files.sheet().element(e).type == mesh::CellType::hex8)
      expected.push_back(files.sheet().centroid(e));
  }
  ASSERT_LT(expected.size(), 6U);
  ASSERT_EQ(ring.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LT((ring.points[i] - expected[i]).norm(), 1e-9);
}

TEST(ArtisynthFace, TakesLandmarksAndPairsFromTheTables) {
  const SyntheticFace files;
  const FaceAnatomy face = files.read();
  ASSERT_EQ(face.landmarks.size(), 2U);
  EXPECT_EQ(face.landmarks[1].name, "B");
  EXPECT_EQ(face.landmarks[1].node, 4);
  EXPECT_TRUE(face.landmarks[0].in_paper);
  ASSERT_EQ(face.pairs.size(), 1U);
}

TEST(ArtisynthFace, NamesEveryFileThatWasRead) {
  const SyntheticFace files;
  std::vector<std::filesystem::path> expected;
  for (const auto& folder : {files.models(), files.tables()}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) expected.push_back(entry.path());
    }
  }
  EXPECT_THAT(files.read().files, testing::UnorderedElementsAreArray(expected));
}

TEST(ArtisynthFace, ReadsFilesWithWindowsLineEndsAndWithoutAnEndOfTheLastLine) {
  const SyntheticFace files;
  for (const char* name : {"badinface_adjusted.node", "badinface_adjusted.elem",
                           "edge_nodes.nodenum", "atlas_external.node"}) {
    SyntheticFace::replace_all(files.geometry(name), "\n", "\r\n");
    std::string content = read_file(files.geometry(name));
    content.resize(content.size() - 2);
    SyntheticFace::write(files.geometry(name), content);
  }
  EXPECT_EQ(files.message(), "");
  EXPECT_EQ(files.read().mesh.n_nodes(), files.sheet().n_nodes());
}

TEST(ArtisynthFace, KeepsElementsThatAreRightHandedInTheFile) {
  const SyntheticFace files;
  ASSERT_EQ(files.sheet().element(0).type, mesh::CellType::hex8);
  std::string row;
  for (const Index node : files.sheet().element(0).connectivity())
    row += fmt::format("{} ", node + SyntheticFace::first_node);
  SyntheticFace::replace_line(files.geometry("badinface_adjusted.elem"), 1, row + "1 1 1 1 0 1");
  EXPECT_EQ(files.read().mesh.element(0).nodes, files.sheet().element(0).nodes);
}

TEST(ArtisynthFace, TurnsLeftHandedWedges) {
  const SyntheticFace files;
  ASSERT_EQ(files.sheet().element(1).type, mesh::CellType::wedge6);
  const auto& n = files.sheet().element(1).nodes;
  std::string row;
  for (const Index node : {n[0], n[2], n[1], n[1], n[3], n[5], n[4], n[4]})
    row += fmt::format("{} ", node + SyntheticFace::first_node);
  SyntheticFace::replace_line(files.geometry("badinface_adjusted.elem"), 2, row + "1 1 1 1 0 2");
  EXPECT_EQ(files.read().mesh.element(1).nodes, n);
}

}  // namespace
}  // namespace facies::anatomy
