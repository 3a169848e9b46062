// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_drawings.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

/// Points of `inner` in the order of the skin's; a problem for each that is missing.
std::vector<Vec3> points_below(const Cage& skin, const Cage& inner, const std::string& where,
                               Problems& problems) {
  std::vector<Vec3> points;
  for (const std::string& name : skin.names) {
    const auto found = inner.index.find(name);
    if (found == inner.index.end()) {
      problems.add({where, "no point " + name, "a point for each of skin.json",
                    "the two drawings have the same rows"});
    } else {
      points.push_back(inner.points[at(found->second)]);
    }
  }
  return points;
}

DrawnPoint read_point(const Table& table, std::size_t row, bool has_depth, Problems& problems) {
  const DrawnPoint point{table.number(row, "lateral_mm", problems).value_or(0.0),
                         table.number(row, "up_mm", problems).value_or(0.0),
                         has_depth ? table.number(row, "depth", problems).value_or(0.0) : 0.0,
                         table.where(row, "lateral_mm")};
  if (point.depth < 0.0 || point.depth > 1.0)
    problems.add({table.where(row, "depth"), fmt::format("{:g}", point.depth),
                  "0 (the skin's surface) to 1 (the inner surface)", ""});
  return point;
}

/// A problem for a curve of too few points.
void check_curve(const std::string& name, const std::vector<DrawnPoint>& points, std::size_t least,
                 Problems& problems) {
  if (points.size() < least)
    problems.add({points.front().where, fmt::format("{} of {} point(s)", name, points.size()),
                  fmt::format("at least {}", least), "rows of a curve follow each other"});
}

double read_size(const Table& table, std::size_t row, const char* column, Problems& problems) {
  const std::optional<double> size = table.number(row, column, problems);
  if (size && *size <= 0.0) {
    problems.add({table.where(row, column), fmt::format("{:g} mm", *size), "more than 0 mm", ""});
  }
  return size.value_or(0.0);
}

std::vector<DrawnMuscle> read_muscles(const fs::path& path, Problems& problems) {
  const Table table(path, {"name", "meaning", "width_mm", "thickness_mm", "source"}, problems);
  std::vector<DrawnMuscle> muscles;
  std::vector<std::string> names;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    muscles.push_back({table.new_name(row, "name", names, problems),
                       std::string(table.text(row, "meaning")),
                       read_size(table, row, "width_mm", problems),
                       read_size(table, row, "thickness_mm", problems)});
  }
  return muscles;
}

FibreForm read_form(const Table& table, std::size_t row, Problems& problems) {
  static const std::map<std::string, FibreForm, std::less<>> forms = {
      {"fibre", FibreForm::fibre}, {"ring", FibreForm::ring}, {"loop", FibreForm::loop}};
  const auto found = forms.find(table.text(row, "form"));
  if (found != forms.end()) return found->second;
  problems.add({table.where(row, "form"), excerpt(table.text(row, "form")), "fibre, ring or loop",
                "a ring is closed by its mirror image, a loop on its own side"});
  return FibreForm::fibre;
}

/// A fibre needs two points, a loop three; a ring begins and ends in the midline.
void check_fibre(const DrawnFibre& fibre, Problems& problems) {
  const std::size_t least = fibre.form == FibreForm::loop ? 3 : 2;
  check_curve(fibre.muscle + "." + fibre.name, fibre.points, least, problems);
  if (fibre.form != FibreForm::ring) return;
  for (const DrawnPoint* end : {&fibre.points.front(), &fibre.points.back()}) {
    if (end->lateral != 0.0)
      problems.add({end->where, fmt::format("{:g}", end->lateral),
                    "0: half a ring begins and ends in the midline",
                    "a ring on one side is a loop"});
  }
}

std::vector<DrawnFibre> read_fibres(const fs::path& path, const std::vector<DrawnMuscle>& muscles,
                                    Problems& problems) {
  const Table table(path, {"muscle", "fibre", "form", "lateral_mm", "up_mm", "depth"}, problems);
  std::vector<std::string> names;
  std::ranges::transform(muscles, std::back_inserter(names), &DrawnMuscle::name);
  std::vector<DrawnFibre> fibres;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    const std::string muscle =
        table.known_name(row, "muscle", names, "a muscle of muscles.csv", problems);
    const std::string name(table.text(row, "fibre"));
    if (fibres.empty() || fibres.back().muscle != muscle || fibres.back().name != name)
      fibres.push_back({muscle, name, read_form(table, row, problems), {}});
    fibres.back().points.push_back(read_point(table, row, true, problems));
  }
  for (const DrawnFibre& fibre : fibres)
    check_fibre(fibre, problems);
  return fibres;
}

std::vector<std::vector<DrawnPoint>> read_lines(const fs::path& path, Problems& problems) {
  const Table table(path, {"curve", "lateral_mm", "up_mm"}, problems);
  std::vector<std::vector<DrawnPoint>> lines;
  std::vector<std::string> names;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    const std::string_view name = table.text(row, "curve");
    if (lines.empty() || name != names.back()) {
      names.emplace_back(name);
      lines.emplace_back();
    }
    lines.back().push_back(read_point(table, row, false, problems));
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    check_curve(names[i], lines[i], 2, problems);
  return lines;
}

std::vector<DrawnLandmark> read_landmarks(const fs::path& path, const Cage& skin,
                                          Problems& problems) {
  const Table table(path, {"name", "point", "meaning", "in_paper"}, problems);
  std::vector<DrawnLandmark> landmarks;
  std::vector<std::string> names;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    landmarks.push_back(
        {table.new_name(row, "name", names, problems),
         table.known_name(row, "point", skin.names, "a point of skin.json", problems),
         std::string(table.text(row, "meaning")), table.flag(row, "in_paper", problems)});
  }
  return landmarks;
}

/// Node sets of face_anatomy.hpp that regions.csv may say; the others follow from the net.
const std::vector<std::string>& region_names() {
  static const std::vector<std::string> names{"zygomatic", "nose", "orbit", "mandibular"};
  return names;
}

/// The points of lists such as "e2.0:3 k0.1", and their twins.
std::map<std::string, std::vector<Index>> read_regions(const fs::path& path, const Cage& skin,
                                                       Problems& problems) {
  const Table table(path, {"set", "points", "source"}, problems);
  std::map<std::string, std::vector<Index>> regions;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    const std::string set =
        table.known_name(row, "set", region_names(), "a node set that models rely on", problems);
    std::vector<Index>& points = regions[set];
    for (const std::string_view range : split_blanks(table.text(row, "points"))) {
      for (const Index point :
           points_of_range(skin, std::string(range), table.where(row, "points"), problems)) {
        points.push_back(point);
        points.push_back(skin.mirrored[at(point)]);
      }
    }
  }
  return regions;
}

std::vector<std::array<std::string, 2>> read_pairs(const fs::path& path,
                                                   const std::vector<DrawnLandmark>& landmarks,
                                                   Problems& problems) {
  const Table table(path, {"a", "b"}, problems);
  std::vector<std::string> names;
  std::ranges::transform(landmarks, std::back_inserter(names), &DrawnLandmark::name);
  std::vector<std::array<std::string, 2>> pairs;
  const auto landmark = [&](std::size_t row, const char* column) {
    return table.known_name(row, column, names, "a landmark of face-landmarks.csv", problems);
  };
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    pairs.push_back({landmark(row, "a"), landmark(row, "b")});
  return pairs;
}

}  // namespace

Problem beside_the_face(const DrawnPoint& point) {
  return {point.where, fmt::format("({:g}, {:g}) is not on the face", point.lateral, point.up),
          "a place where the frontal view of skin.json shows skin",
          "beside the face, in an eye, a nostril and between the lips there is none"};
}

Drawings read_drawings(const fs::path& folder) {
  Drawings all;
  Problems problems;
  const auto file = [&](const char* name) {
    all.files.push_back(folder / name);
    return all.files.back();
  };
  all.skin = read_cage(file("skin.json"), problems);
  all.measures = read_measures(folder, all.skin, problems);
  all.depths = read_depth_sites(folder, problems);
  for (const char* name : {"landmarks.csv", "measures.csv", "depths.csv"})
    (void)file(name);
  const fs::path inner = file("inner.json");
  const std::size_t before = problems.size();
  const Cage below = read_cage(inner, problems);
  if (problems.size() == before && !all.skin.names.empty())
    all.inner = points_below(all.skin, below, inner.string(), problems);
  all.muscles = read_muscles(file("muscles.csv"), problems);
  all.fibres = read_fibres(file("muscle-paths.csv"), all.muscles, problems);
  all.tension_lines = read_lines(file("tension-lines.csv"), problems);
  all.landmarks = read_landmarks(file("face-landmarks.csv"), all.skin, problems);
  const fs::path regions = file("regions.csv");
  if (!all.skin.names.empty()) all.regions = read_regions(regions, all.skin, problems);
  const fs::path thickness = file("skin-thickness.csv");
  if (!all.skin.names.empty()) all.skin_regions = read_skin_regions(thickness, all.skin, problems);
  all.pairs = read_pairs(file("pairs.csv"), all.landmarks, problems);
  problems.throw_if_any<DataError>();
  return all;
}

}  // namespace facies::anatomy
