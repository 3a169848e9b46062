// SPDX-License-Identifier: Apache-2.0
// The quality report against numbers that were computed independently (a script of its own) for the mesh of the paper:
// section 4 of the README of the reference face and its table derived/elements.csv. Skipped where it is not at hand.
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/mesh/columns.hpp"
#include "facies/mesh/quality.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<std::string_view>> rows(const std::string& text, char separator) {
  std::vector<std::vector<std::string_view>> all;
  for (const std::string_view line : split(text, '\n')) {
    if (!line.empty())
      all.push_back(separator == ' ' ? split_blanks(line) : split(line, separator));
  }
  return all;
}

double number(std::string_view field) {
  return parse_number(field).value();
}
Index index_of(std::string_view field) {
  return static_cast<Index>(number(field)) - 1;
}

/// The reference mesh from the tables in `derived`, with sets skin, hypodermis_outer, hypodermis_inner and faces outer;
/// what the table says about each element; our report.
struct Reference {
  Mesh mesh;
  std::vector<ElementQuality> expected;
  fs::path derived;
  QualityReport report;
};

Mesh read_mesh(const fs::path& upstream, const std::vector<std::vector<std::string_view>>& table) {
  std::vector<Vec3> X;
  const std::string nodes = read_file(upstream / "face/geometry/badinface_adjusted.node");
  for (const auto& row : rows(nodes, ' ')) {
    X.emplace_back(1000.0 * Vec3(number(row[1]), number(row[2]), number(row[3])));
  }
  std::vector<Element> elements;
  std::map<std::string, std::vector<Index>> layers;
  for (const auto& row : table) {
    Element element;
    element.type = row[1] == "hex8" ? CellType::hex8 : CellType::wedge6;
    for (std::size_t i = 0; i < n_nodes(element.type); ++i)
      element.nodes[i] = index_of(row[3 + i]);
    layers[std::string(row[2])].push_back(to_index(elements.size()));
    elements.push_back(element);
  }
  Mesh mesh(std::move(X), std::move(elements));
  for (const auto& [name, members] : layers)
    mesh.set_elements(name, members);
  return mesh;
}

void set_outer_faces(Mesh& mesh, const fs::path& derived) {
  const std::string text = read_file(derived / "skin-faces.csv");
  std::vector<Face> outer;
  for (const auto& row : rows(text, ',')) {
    if (row[0] == "element") continue;
    std::set<Index> nodes;
    for (std::size_t i = 1; i <= 4; ++i) {
      if (!row[i].empty()) nodes.insert(index_of(row[i]));
    }
    const Index e = index_of(row[0]);
    for (std::uint8_t local = 0; local < mesh::faces(mesh.element(e).type).size(); ++local) {
      const std::vector<Index> own = mesh.face_nodes({e, local});
      if (std::set<Index>(own.begin(), own.end()) == nodes) outer.push_back({e, local});
    }
  }
  mesh.set_faces("outer", outer);
}

const std::optional<Reference>& reference() {
  static const std::optional<Reference> read = []() -> std::optional<Reference> {
    const char* variable = std::getenv("FACIES_REFERENCE_FACE");  // NOLINT(concurrency-mt-unsafe)
    const fs::path upstream =
        variable != nullptr ? fs::path(variable)
                            : fs::path(FACIES_SOURCE_DIR) / "../shared/reference-face/upstream";
    const fs::path derived = upstream / "../derived";
    if (!fs::exists(derived / "elements.csv")) return std::nullopt;
    const std::string text = read_file(derived / "elements.csv");
    auto table = rows(text, ',');
    table.erase(table.begin());
    Reference made{read_mesh(upstream, table), {}, derived, {}};
    for (const auto& row : table) {
      made.expected.push_back({number(row[11]), number(row[12]), number(row[13])});
    }
    set_outer_faces(made.mesh, derived);
    made.report = quality(made.mesh, made.mesh.X());
    return made;
  }();
  return read;
}

class ReferenceMesh : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!reference()) {
      GTEST_SKIP()
          << "the reference face is not here: set FACIES_REFERENCE_FACE to its folder 'upstream' "
             "(with 'derived' beside it)";
    }
    report_ = reference()->report;
  }

  [[nodiscard]] std::size_t count_below(CellType type, double bound) const {
    std::size_t count = 0;
    for (std::size_t e = 0; e < report_.elements.size(); ++e) {
      const bool counted = reference()->mesh.elements()[e].type == type &&
                           report_.elements[e].scaled_jacobian_gauss < bound;
      count += counted ? 1 : 0;
    }
    return count;
  }

  QualityReport report_;
};

TEST_F(ReferenceMesh, HasTheQualityOfEachElementInTheTable) {
  ASSERT_EQ(report_.elements.size(), reference()->expected.size());
  for (std::size_t e = 0; e < report_.elements.size(); ++e) {
    const ElementQuality& found = report_.elements[e];
    const ElementQuality& expected = reference()->expected[e];
    EXPECT_NEAR(found.volume, expected.volume, 6e-6 * expected.volume) << e + 1;
    EXPECT_NEAR(found.scaled_jacobian_gauss, expected.scaled_jacobian_gauss, 6e-6) << e + 1;
    EXPECT_NEAR(found.scaled_jacobian_corner, expected.scaled_jacobian_corner, 6e-6) << e + 1;
  }
}

TEST_F(ReferenceMesh, HasTheCountsVolumesAndBox) {
  EXPECT_EQ(report_.n_nodes, 8720U);
  EXPECT_EQ(report_.n_hex, 6024U);
  EXPECT_EQ(report_.n_wedge, 318U);
  EXPECT_NEAR(report_.volume, 632.27e3, 5.0);
  EXPECT_LT((report_.lower - Vec3(20.47, -84.33, 29.38)).cwiseAbs().maxCoeff(), 0.005);
  EXPECT_LT((report_.upper - Vec3(176.91, 84.33, 201.61)).cwiseAbs().maxCoeff(), 0.005);
  const std::map<std::string, double> volumes{
      {"skin", 125.3e3}, {"hypodermis_outer", 280.5e3}, {"hypodermis_inner", 226.5e3}};
  for (const auto& [layer, volume] : volumes) {
    EXPECT_EQ(report_.sets.at(layer).n_elements, 2114U);
    EXPECT_NEAR(report_.sets.at(layer).volume, volume, 50.0) << layer;
  }
}

TEST_F(ReferenceMesh, HasTheWorstElementsAndDentedCorners) {
  EXPECT_TRUE(report_.inverted.empty());
  std::vector<Index> dented;
  for (const Index e :
       {283, 781, 1219, 1222, 1764, 1910, 1912, 2110, 2734, 2735, 2937, 2945, 3105}) {
    dented.push_back(e - 1);
  }
  EXPECT_EQ(report_.inverted_corners, dented);
  EXPECT_EQ(report_.worst[0], 5126 - 1);
  EXPECT_EQ(report_.worst[1], 6208 - 1);
  EXPECT_EQ(count_below(CellType::hex8, 0.2), 145U);
  EXPECT_EQ(count_below(CellType::wedge6, 0.2), 32U);
  EXPECT_EQ(count_below(CellType::hex8, 0.3), 327U);
  EXPECT_EQ(count_below(CellType::wedge6, 0.3), 71U);
  EXPECT_TRUE(check_geometry(reference()->mesh).empty());
  EXPECT_TRUE(check_size(reference()->mesh, 50.0, 500.0).empty());
}

TEST_F(ReferenceMesh, HasTheThicknessOfItsSkin) {
  const ElementSetQuality& skin = report_.sets.at("skin");
  EXPECT_NEAR(skin.area.value(), 516e2, 50.0);
  const Quantiles thickness = skin.thickness.value();
  EXPECT_NEAR(thickness.p05, 0.61, 0.006);
  EXPECT_NEAR(thickness.p25, 1.18, 0.006);
  EXPECT_NEAR(thickness.p50, 1.85, 0.006);
  EXPECT_NEAR(thickness.p75, 2.83, 0.006);
  EXPECT_NEAR(thickness.p95, 4.30, 0.006);
}

TEST_F(ReferenceMesh, HasTheNodeColumnsOfTheTable) {
  const Mesh& mesh = reference()->mesh;
  const std::string text = read_file(reference()->derived / "node-columns.csv");
  std::set<std::vector<Index>> expected;
  for (const auto& row : rows(text, ',')) {
    if (row[0] == "outer") continue;
    std::vector<Index> column;
    for (const std::string_view field : row)
      column.push_back(index_of(field));
    expected.insert(column);
  }
  const auto columns = node_columns(mesh, mesh.faces("outer"));
  EXPECT_EQ(std::set<std::vector<Index>>(columns.begin(), columns.end()), expected);

  std::vector<double> hypodermis;
  for (const auto& column : columns) {
    const auto X = [&](std::size_t i) { return mesh.X()[at(column[i])]; };
    hypodermis.push_back((X(2) - X(1)).norm() + (X(3) - X(2)).norm());
  }
  const Quantiles thickness = quantiles(hypodermis);
  EXPECT_NEAR(thickness.p05, 4.9, 0.06);
  EXPECT_NEAR(thickness.p25, 7.2, 0.06);
  EXPECT_NEAR(thickness.p50, 9.7, 0.06);
  EXPECT_NEAR(thickness.p75, 13.6, 0.06);
  EXPECT_NEAR(thickness.p95, 21.2, 0.06);
}

TEST_F(ReferenceMesh, HasAClosedBoundary) {
  const Mesh& mesh = reference()->mesh;
  const std::vector<Face> boundary = boundary_faces(mesh);
  EXPECT_EQ(face_set_nodes(mesh, boundary).size(), 4852U);
  EXPECT_EQ(triangulate(mesh, boundary).triangles.size(), 9720U);
  EXPECT_EQ(face_set_nodes(mesh, mesh.faces("outer")).size(), 2180U);
  Vec3 sum = Vec3::Zero();
  for (const Face& face : boundary)
    sum += area_vector(mesh, face, mesh.X());
  EXPECT_LT(sum.norm(), 1e-8);
}

}  // namespace
}  // namespace facies::mesh
