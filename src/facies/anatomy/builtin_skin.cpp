// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_skin.hpp"

#include <map>
#include <optional>

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

/// No skin of a face is thinner or thicker [mm].
constexpr double thinnest = 0.3;
constexpr double thickest = 3.0;

double read_thickness(const Table& table, std::size_t row, const char* column, Problems& problems) {
  const std::optional<double> value = table.number(row, column, problems);
  if (value && (*value < thinnest || *value > thickest)) {
    problems.add({table.where(row, column), fmt::format("{:g} mm", *value),
                  fmt::format("skin of {:g} mm to {:g} mm", thinnest, thickest), ""});
  }
  return value.value_or(thinnest);
}

/// The points of a region. `taken` says which region has a point.
std::vector<Index> read_points(const Table& table, std::size_t row, const Cage& skin,
                               const std::string& region, std::map<Index, std::string>& taken,
                               Problems& problems) {
  const std::string where = table.where(row, "points");
  std::vector<Index> points;
  const std::string_view text = table.text(row, "points");
  for (const std::string_view range : split_blanks(text)) {
    for (const Index point : points_of_range(skin, std::string(range), where, problems)) {
      const auto [before, is_new] = taken.emplace(point, region);
      if (!is_new) {
        problems.add({where, skin.names[at(point)] + " is in " + before->second + " already",
                      "each point in one region", ""});
        continue;
      }
      points.push_back(point);
      const Index twin = skin.mirrored[at(point)];
      if (twin != point) points.push_back(twin);
    }
  }
  if (split_blanks(text).empty()) problems.add({where, "no point", "points of skin.json", ""});
  return points;
}

}  // namespace

std::vector<SkinRegion> read_skin_regions(const std::filesystem::path& path, const Cage& skin,
                                          Problems& problems) {
  const std::size_t before = problems.size();
  const Table table(path, {"region", "points", "male_mm", "female_mm", "source"}, problems);
  std::vector<SkinRegion> regions;
  std::vector<std::string> names;
  std::map<Index, std::string> taken;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    SkinRegion& region = regions.emplace_back();
    region.name = table.new_name(row, "region", names, problems);
    region.points = read_points(table, row, skin, region.name, taken, problems);
    region.male = read_thickness(table, row, "male_mm", problems);
    region.female = read_thickness(table, row, "female_mm", problems);
  }
  if (regions.empty() && problems.size() == before)
    problems.add({path.string(), "no region", "the thickness of the skin of one at least", ""});
  return regions;
}

std::vector<double> skin_thickness(const Cage& skin, const std::vector<SkinRegion>& regions,
                                   bool female) {
  const Index n = skin.net.n_vertices;
  std::vector<double> known(at(n), 0.0);
  for (const SkinRegion& region : regions) {
    for (const Index point : region.points)
      known[at(point)] = female ? region.female : region.male;
  }
  require(!regions.empty(), "skin_thickness: no region");
  // One equation for each point that is not known: its neighbours' differences from it add up to nothing.
  std::vector<Index> unknown(at(n), -1);
  Index n_unknown = 0;
  for (Index v = 0; v < n; ++v) {
    if (known[at(v)] == 0.0) unknown[at(v)] = n_unknown++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n_unknown);
  const auto add = [&](Index v, Index neighbour) {
    const Index row = unknown[at(v)];
    if (row < 0) return;
    entries.emplace_back(row, row, 1.0);
    if (unknown[at(neighbour)] >= 0) {
      entries.emplace_back(row, unknown[at(neighbour)], -1.0);
    } else {
      rhs(row) += known[at(neighbour)];
    }
  };
  for (const auto& [edge, quads] : mesh::edges_of(skin.net)) {
    add(edge.first, edge.second);
    add(edge.second, edge.first);
  }
  Eigen::SparseMatrix<double> A(n_unknown, n_unknown);
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd found = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(A).solve(rhs);
  std::vector<double> thickness = known;
  for (Index v = 0; v < n; ++v) {
    if (unknown[at(v)] >= 0) thickness[at(v)] = found(unknown[at(v)]);
  }
  return thickness;
}

}  // namespace facies::anatomy
