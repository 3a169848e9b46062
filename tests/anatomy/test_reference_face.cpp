// SPDX-License-Identifier: Apache-2.0
// The reference face against what is known about it from the files themselves, counted by an independent program.
#include <algorithm>
#include <gmock/gmock.h>
#include <set>

#include "anatomy/reference_face.hpp"
#include <gtest/gtest.h>

#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::anatomy {
namespace {

using ReferenceFace = ReferenceFaceTest;

std::size_t count(const mesh::Mesh& mesh, const std::string& set, mesh::CellType type) {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh.elements(set), [&](Index e) { return mesh.element(e).type == type; }));
}

TEST_F(ReferenceFace, HasThePapersNodesAndElements) {
  const mesh::Mesh& mesh = face().mesh;
  EXPECT_EQ(mesh.n_nodes(), 8720U);
  EXPECT_EQ(mesh.n_elements(), 6342U);
  EXPECT_TRUE(face().is_reference_face);
  EXPECT_EQ(std::ranges::count(mesh.elements(), mesh::CellType::wedge6, &mesh::Element::type), 318);
}

TEST_F(ReferenceFace, HasThreeEqualLayersThatTogetherAreAllElements) {
  const mesh::Mesh& mesh = face().mesh;
  std::set<Index> all;
  for (const std::string& layer : layer_names()) {
    EXPECT_EQ(count(mesh, layer, mesh::CellType::hex8), 2008U) << layer;
    EXPECT_EQ(count(mesh, layer, mesh::CellType::wedge6), 106U) << layer;
    all.insert(mesh.elements(layer).begin(), mesh.elements(layer).end());
  }
  EXPECT_EQ(all.size(), 6342U);
}

TEST_F(ReferenceFace, HasElementsAndLayersAsComputedIndependently) {
  const auto rows = derived_table("elements.csv");
  if (rows.empty()) GTEST_SKIP() << "no derived tables";
  const mesh::Mesh& mesh = face().mesh;
  for (const CsvRow& row : rows) {
    const Index e = index_of(row, "element");
    std::vector<Index> nodes;
    for (const char* column : {"n1", "n2", "n3", "n4", "n5", "n6", "n7", "n8"}) {
      if (!row.at(column).empty()) nodes.push_back(index_of(row, column));
    }
    EXPECT_THAT(mesh.element(e).connectivity(), testing::ElementsAreArray(nodes)) << e;
    const std::string layer =
        row.at("layer") == "hypodermis_outer" ? "hypodermis_mid" : row.at("layer");
    EXPECT_TRUE(std::ranges::binary_search(mesh.elements(layer), e)) << e;
  }
}

TEST_F(ReferenceFace, HasTheKnownSizesOfSets) {
  const mesh::Mesh& mesh = face().mesh;
  const std::map<std::string, std::size_t> expected{
      {"outer", 2180},       {"inner", 2180},    {"held_in_tension", 2244},
      {"rim", 432},          {"zygomatic", 6},   {"nose", 120},
      {"orbit", 78},         {"mandibular", 12}, {"lip_free", 595},
      {"cheek_free", 39},    {"nose_free", 19},  {"submental_free", 211},
      {"zygomatic_free", 34}};
  for (const auto& [name, size] : expected)
    EXPECT_EQ(mesh.nodes(name).size(), size) << name;
  EXPECT_EQ(mesh.node_sets().size(), expected.size());
  EXPECT_EQ(mesh.faces("outer").size(), 2114U);
  EXPECT_EQ(mesh.faces("inner").size(), 2114U);
  EXPECT_THAT(mesh::face_set_nodes(mesh, mesh.faces("outer")),
              testing::ElementsAreArray(mesh.nodes("outer")));
  EXPECT_THAT(mesh::face_set_nodes(mesh, mesh.faces("inner")),
              testing::ElementsAreArray(mesh.nodes("inner")));
}

TEST_F(ReferenceFace, Fixes636DistinctNodesFromTheReleaseOn) {
  std::set<Index> fixed;
  for (const char* name : {"rim", "zygomatic", "nose", "orbit"})
    fixed.insert(face().mesh.nodes(name).begin(), face().mesh.nodes(name).end());
  EXPECT_EQ(fixed.size(), 636U);
}

TEST_F(ReferenceFace, TiesOnlyInnerNodesToTheMandible) {
  // Read as numbers instead of 0-based indices, five of the twelve would lie elsewhere.
  for (const Index node : face().mesh.nodes("mandibular"))
    EXPECT_TRUE(std::ranges::binary_search(face().mesh.nodes("inner"), node)) << node;
}

TEST_F(ReferenceFace, HoldsInTension1920InnerNodesAndTheWholeRim) {
  const mesh::Mesh& mesh = face().mesh;
  std::size_t n_inner = 0;
  for (const Index node : mesh.nodes("held_in_tension"))
    n_inner += std::ranges::binary_search(mesh.nodes("inner"), node) ? 1U : 0U;
  EXPECT_EQ(n_inner, 1920U);
  EXPECT_TRUE(std::ranges::includes(mesh.nodes("held_in_tension"), mesh.nodes("rim")));
}

TEST_F(ReferenceFace, LooksTowardsMinusXInMillimetres) {
  Vec3 lower = face().mesh.X()[0];
  Vec3 upper = lower;
  for (const Vec3& X : face().mesh.X()) {
    lower = lower.cwiseMin(X);
    upper = upper.cwiseMax(X);
  }
  EXPECT_LT((lower - Vec3(20.47, -84.33, 29.38)).norm(), 0.02);
  EXPECT_LT((upper - Vec3(176.91, 84.33, 201.61)).norm(), 0.02);
}

TEST_F(ReferenceFace, HasPositiveJacobiansAndTheKnownVolume) {
  const mesh::QualityReport report = mesh::quality(face().mesh, face().mesh.X());
  EXPECT_TRUE(report.inverted.empty());
  EXPECT_NEAR(report.volume * 1e-3, 632.27, 0.005);
}

TEST_F(ReferenceFace, HasItsLandmarksWhereTheyAreKnownToBe) {
  const std::map<std::string, Vec3> expected{
      {"RC", {62.22, 16.47, 159.85}},     {"ROR", {56.87, 34.90, 129.70}},
      {"RAN", {49.85, 20.51, 122.98}},    {"SN", {35.81, -1.68, 121.49}},
      {"RMU", {39.92, 11.34, 105.55}},    {"PH", {37.42, -0.57, 103.56}},
      {"RMC", {54.05, 27.14, 96.96}},     {"LMC", {56.21, -28.17, 97.20}},
      {"RML", {48.87, 14.86, 85.96}},     {"SL", {44.05, -1.32, 83.69}},
      {"PG", {46.95, -1.25, 60.26}},      {"PH_buried", {44.51, -3.20, 103.03}},
      {"RTR", {139.245, 73.376, 126.303}}};
  std::size_t n_found = 0;
  for (const Landmark& landmark : face().landmarks) {
    if (landmark.name != "PH_buried") {
      EXPECT_TRUE(std::ranges::binary_search(face().mesh.nodes("outer"), landmark.node))
          << landmark.name;
    }
    const auto known = expected.find(landmark.name);
    if (known == expected.end()) continue;
    ++n_found;
    EXPECT_LT((face().mesh.X()[at(landmark.node)] - known->second).norm(), 0.01) << landmark.name;
  }
  EXPECT_EQ(n_found, expected.size());
  EXPECT_EQ(std::ranges::count(face().landmarks, true, &Landmark::in_paper), 11);
}

TEST_F(ReferenceFace, HasLandmarkDistancesOfTheRestFace) {
  const std::map<std::string, double> expected{{"RMC-LMC", 55.3558},
                                               {"RC-RMC", 64.3147},
                                               {"RTR-RMC", 101.2752},
                                               {"PH-SL", 20.9579},
                                               {"SN-PH", 18.0371}};
  const auto position = [](const std::string& name) {
    const auto found = std::ranges::find(face().landmarks, name, &Landmark::name);
    return face().mesh.X()[at(found->node)];
  };
  ASSERT_EQ(face().pairs.size(), expected.size());
  for (const LandmarkPair& pair : face().pairs) {
    EXPECT_NEAR((position(pair.a) - position(pair.b)).norm(), expected.at(pair.a + "-" + pair.b),
                1e-3);
  }
}

TEST_F(ReferenceFace, HasOrthonormalRightHandedSkinAxesOnTheOutwardNormal) {
  const mesh::Mesh& mesh = face().mesh;
  for (const mesh::Face& outer : mesh.faces("outer")) {
    const Mat3& axes = face().axes[at(outer.element)];
    EXPECT_LT((axes.transpose() * axes - Mat3::Identity()).norm(), 1e-12) << outer.element;
    EXPECT_GT(axes.determinant(), 0.0) << outer.element;
    const Vec3 normal = mesh::area_vector(mesh, outer, mesh.X()).normalized();
    EXPECT_LT((axes.col(1) - normal).norm(), 1e-12) << outer.element;
    // Outwards: away from the element's middle.
    Vec3 middle = Vec3::Zero();
    for (const Index node : mesh.face_nodes(outer))
      middle += mesh.X()[at(node)] / double(mesh.face_nodes(outer).size());
    EXPECT_GT(normal.dot(middle - mesh.centroid(outer.element)), 0.0) << outer.element;
  }
  for (const Index e : mesh.elements("hypodermis_mid"))
    EXPECT_EQ(face().axes[at(e)], Mat3::Identity());
}

TEST_F(ReferenceFace, HasTheFilesSkinDirectionsProjectedOnTheSkin) {
  const auto rows = derived_table("skin-faces.csv");
  if (rows.empty()) GTEST_SKIP() << "no derived tables";
  EXPECT_EQ(rows.size(), 2114U);
  for (const CsvRow& row : rows) {
    const Mat3& axes = face().axes[at(index_of(row, "element"))];
    const Vec3 normal(real(row, "nx"), real(row, "ny"), real(row, "nz"));
    const Vec3 a1(real(row, "a1x"), real(row, "a1y"), real(row, "a1z"));
    // The table has six and five decimals; the shortest projection is a quarter of a1.
    EXPECT_LT((axes.col(1) - normal).norm(), 3e-6) << row.at("element");
    EXPECT_LT((axes.col(0) - (a1 - a1.dot(normal) * normal).normalized()).norm(), 1e-4)
        << row.at("element");
  }
}

TEST_F(ReferenceFace, SaysWhatItDidToTheFiles) {
  EXPECT_THAT(face().notes, testing::Contains(testing::HasSubstr("6024 left-handed")));
  EXPECT_THAT(face().notes, testing::Contains(testing::HasSubstr("318 degenerate")));
}

}  // namespace
}  // namespace facies::anatomy
