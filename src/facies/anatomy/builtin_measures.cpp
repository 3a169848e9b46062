// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include <Eigen/QR>
#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

const std::array<std::pair<const char*, MeasureKind>, 4> kinds{{{"distance", MeasureKind::distance},
                                                                {"width", MeasureKind::width},
                                                                {"forward", MeasureKind::forward},
                                                                {"up", MeasureKind::up}}};

/// A problem where the drawing has the landmark's point not where its side says.
void check_side(const SkinLandmark& landmark, const Table& table, std::size_t row, const Cage& skin,
                Problems& problems) {
  const auto found = skin.index.find(landmark.point);
  if (found == skin.index.end()) return;
  const bool in_midline = skin.points[at(found->second)].y() == 0.0;
  if (in_midline == landmark.both)
    problems.add({table.where(row, "side"),
                  landmark.point + (in_midline ? " is in the midline" : " is not in the midline"),
                  in_midline ? "middle" : "both", ""});
}

std::vector<SkinLandmark> read_landmarks(const fs::path& path, const Cage& skin,
                                         Problems& problems) {
  const Table table(path, {"name", "point", "side", "meaning"}, problems);
  std::vector<SkinLandmark> landmarks;
  std::vector<std::string> names;
  std::vector<std::string> points;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    SkinLandmark landmark;
    landmark.name = table.new_name(row, "name", names, problems);
    landmark.point = table.new_name(row, "point", points, problems);
    landmark.meaning = table.text(row, "meaning");
    const std::string_view side = table.text(row, "side");
    landmark.both = side == "both";
    (void)table.known_name(row, "point", skin.names, "a point of skin.json", problems);
    if (side != "both" && side != "middle") {
      problems.add({table.where(row, "side"), excerpt(side), "middle or both", ""});
    } else {
      check_side(landmark, table, row, skin, problems);
    }
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

/// One row of measures.csv.
FaceMeasure read_measure(const Table& table, std::size_t row,
                         const std::vector<SkinLandmark>& landmarks, std::vector<std::string>& keys,
                         Problems& problems) {
  FaceMeasure measure;
  measure.key = table.new_name(row, "key", keys, problems);
  measure.meaning = table.text(row, "meaning");
  const std::string_view word = table.text(row, "kind");
  const auto kind = std::ranges::find_if(kinds, [&](const auto& k) { return k.first == word; });
  if (kind == kinds.end()) {
    problems.add({table.where(row, "kind"), excerpt(word), "distance, width, forward or up", ""});
  } else {
    measure.kind = kind->second;
  }
  std::vector<std::string> names;
  std::ranges::transform(landmarks, std::back_inserter(names), &SkinLandmark::name);
  measure.a = table.known_name(row, "a", names, "a name of landmarks.csv", problems);
  if (measure.kind != MeasureKind::width) {
    measure.b = table.known_name(row, "b", names, "a name of landmarks.csv", problems);
    if (measure.a == measure.b)
      problems.add({table.where(row, "b"), excerpt(measure.b), "another landmark than a", ""});
  } else if (const auto a = std::ranges::find(landmarks, measure.a, &SkinLandmark::name);
             a != landmarks.end() && !a->both) {
    problems.add({table.where(row, "a"), measure.a + " is in the midline",
                  "a landmark that each half has", "a width is between the two halves"});
  }
  measure.part_of = table.text(row, "part_of");
  measure.rest_of = table.text(row, "rest_of");
  const auto length = [&](const char* column) {
    return table.number(row, column, problems).value_or(0.0);
  };
  measure.male = length("male_mm");
  measure.female = length("female_mm");
  measure.smallest = length("smallest_mm");
  measure.largest = length("largest_mm");
  for (const double preset : {measure.male, measure.female}) {
    if (preset < measure.smallest || preset > measure.largest)
      problems.add({table.where(row, "smallest_mm"),
                    fmt::format("{:g} mm is not in the range", preset),
                    "both presets from smallest_mm to largest_mm", ""});
  }
  return measure;
}

/// The measure and how it changes with its landmarks.
struct Slope {
  double value = 0.0;
  Vec3 by_a = Vec3::Zero(), by_b = Vec3::Zero();
};

Slope slope_of(const FaceMeasure& measure, const Vec3& a, const Vec3& b) {
  const Vec3 difference = a - b;
  switch (measure.kind) {
    case MeasureKind::width:
      return {2.0 * a.y(), 2.0 * Vec3::UnitY(), Vec3::Zero()};
    case MeasureKind::forward:
      return {-difference.x(), -Vec3::UnitX(), Vec3::UnitX()};
    case MeasureKind::up:
      return {difference.z(), Vec3::UnitZ(), -Vec3::UnitZ()};
    case MeasureKind::distance:
      break;
  }
  const double length = difference.norm();
  const Vec3 along = difference / std::max(length, 1e-9);
  return {length, along, -along};
}

/// A measure and the value that it is to have.
struct Wanted {
  const FaceMeasure* measure;
  double value;
};

std::vector<Wanted> wanted_of(const std::vector<FaceMeasure>& measures,
                              const MeasureValues& values) {
  std::vector<Wanted> wanted;
  for (const FaceMeasure& measure : measures) {
    const auto value = values.find(measure.key);
    if (value != values.end()) wanted.push_back({&measure, value->second});
  }
  return wanted;
}

/// The middle of the ratios between what is asked for and what is drawn, of lengths alone.
double mean_ratio(const std::vector<Wanted>& wanted, const LandmarkPlaces& drawn) {
  std::vector<double> ratios;
  for (const auto& [measure, value] : wanted) {
    const bool is_length =
        measure->kind == MeasureKind::distance || measure->kind == MeasureKind::width;
    if (is_length) ratios.push_back(value / measured(*measure, drawn));
  }
  if (ratios.empty()) return 1.0;
  std::ranges::sort(ratios);
  return ratios[ratios.size() / 2];
}

/// The unknowns: three for each landmark.
class Unknowns {
 public:
  explicit Unknowns(const LandmarkPlaces& drawn) {
    for (const auto& [name, x] : drawn) {
      first_[name] = n_;
      n_ += 3;
    }
  }

  [[nodiscard]] Eigen::Index size() const { return n_; }
  [[nodiscard]] Eigen::Index first(const std::string& name) const { return first_.at(name); }

 private:
  std::map<std::string, Eigen::Index> first_;
  Eigen::Index n_ = 0;
};

/// How changes of landmarks go together, as a covariance [size x size]: those of two places with exp(-distance / reach), both
/// halves of the face alike. So what is near goes along with what moves, and the midline stays in the midline.
Eigen::MatrixXd covariance(const LandmarkPlaces& places, const Unknowns& unknowns) {
  constexpr double reach = 40.0;  // [mm]
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(unknowns.size(), unknowns.size());
  for (const auto& [name, x] : places) {
    for (const auto& [other, y] : places) {
      const double own_half = std::exp(-(x - y).norm() / reach);
      const double other_half = std::exp(-(x - Vec3(y.x(), -y.y(), y.z())).norm() / reach);
      const Vec3 alike = Vec3(1.0, 0.0, 1.0) * (own_half + other_half) +
                         Vec3(0.0, 1.0, 0.0) * (own_half - other_half);
      C.block<3, 3>(unknowns.first(name), unknowns.first(other)) = alike.asDiagonal();
    }
  }
  return C;
}

/// Values minus measures, and how the measures change with the unknowns.
struct Linearised {
  Eigen::VectorXd missing;
  Eigen::MatrixXd J;
};

Linearised linearise(const std::vector<Wanted>& wanted, const LandmarkPlaces& places,
                     const Unknowns& unknowns) {
  const auto n = static_cast<Eigen::Index>(wanted.size());
  Linearised result{Eigen::VectorXd(n), Eigen::MatrixXd::Zero(n, unknowns.size())};
  for (Eigen::Index m = 0; m < n; ++m) {
    const auto& [measure, value] = wanted[static_cast<std::size_t>(m)];
    const bool one = measure->b.empty();
    const Vec3 b = one ? Vec3(Vec3::Zero()) : places.at(measure->b);
    const Slope slope = slope_of(*measure, places.at(measure->a), b);
    result.missing(m) = value - slope.value;
    result.J.block<1, 3>(m, unknowns.first(measure->a)) += slope.by_a.transpose();
    if (!one) result.J.block<1, 3>(m, unknowns.first(measure->b)) += slope.by_b.transpose();
  }
  return result;
}

std::string place_of(const FaceMeasure& measure) {
  return "builtin:" + measure.key;
}

std::string range_of(const FaceMeasure& measure) {
  return fmt::format("{:g} mm to {:g} mm", measure.smallest, measure.largest);
}

bool is_in_range(const FaceMeasure& measure, double value) {
  return value >= measure.smallest && value <= measure.largest;
}

/// `start` with its landmarks moved by `way` [size].
LandmarkPlaces moved(const LandmarkPlaces& start, const Unknowns& unknowns,
                     const Eigen::VectorXd& way) {
  LandmarkPlaces places = start;
  for (auto& [name, x] : places)
    x += way.segment<3>(unknowns.first(name));
  return places;
}

/// The likeliest places that come from `start` and meet what is wanted, as far as there are any. Steps meet the measures to first
/// order, and are cut short until they bring them nearer.
LandmarkPlaces likeliest_places(const std::vector<Wanted>& wanted, const LandmarkPlaces& start) {
  constexpr int most_iterations = 100;
  constexpr double close = 1e-9;  // [mm]
  constexpr double least_part = 1e-3;
  const Unknowns unknowns(start);
  const Eigen::MatrixXd C = covariance(start, unknowns);
  Eigen::VectorXd way = Eigen::VectorXd::Zero(unknowns.size());
  Linearised now = linearise(wanted, start, unknowns);
  for (int i = 0; i < most_iterations && now.missing.norm() > close; ++i) {
    const Eigen::MatrixXd CJt = C * now.J.transpose();
    const Eigen::MatrixXd JCJt = now.J * CJt;
    const Eigen::VectorXd whole =
        CJt * JCJt.completeOrthogonalDecomposition().solve(now.missing + now.J * way) - way;
    const double before = now.missing.norm();
    double part = 2.0;
    do {
      part *= 0.5;
      now = linearise(wanted, moved(start, unknowns, way + part * whole), unknowns);
    } while (now.missing.norm() >= before && part > least_part);
    way += part * whole;
  }
  return moved(start, unknowns, way);
}

/// Everything about places that is not as it was asked for.
void check_places(const std::vector<FaceMeasure>& measures, const MeasureValues& values,
                  const LandmarkPlaces& places) {
  constexpr double close_enough = 0.5;  // [mm]
  constexpr const char* hint =
      "the measures contradict each other: let some of them follow from the others";
  Problems problems;
  for (const FaceMeasure& measure : measures) {
    const double found = measured(measure, places);
    const auto value = values.find(measure.key);
    if (value == values.end()) {
      if (!is_in_range(measure, found))
        problems.add({place_of(measure), fmt::format("{:.1f} mm follow from the others", found),
                      range_of(measure), hint});
    } else if (!(std::abs(found - value->second) < close_enough)) {
      problems.add({place_of(measure), fmt::format("no face has {:g} mm", value->second),
                    "what goes with the other measures", hint});
    }
  }
  problems.throw_if_any<UsageError>();
}

}  // namespace

MeasureTables read_measures(const fs::path& folder, const Cage& skin, Problems& problems) {
  MeasureTables tables;
  tables.landmarks = read_landmarks(folder / "landmarks.csv", skin, problems);
  const Table table(folder / "measures.csv",
                    {"key", "kind", "a", "b", "part_of", "rest_of", "male_mm", "female_mm",
                     "smallest_mm", "largest_mm", "meaning", "source"},
                    problems);
  std::vector<std::string> keys;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    tables.measures.push_back(read_measure(table, row, tables.landmarks, keys, problems));
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    for (const char* column : {"part_of", "rest_of"}) {
      if (!table.text(row, column).empty())
        (void)table.known_name(row, column, keys, "a key of this table", problems);
    }
  }
  return tables;
}

double measured(const FaceMeasure& measure, const LandmarkPlaces& places) {
  const Vec3 b = measure.b.empty() ? Vec3(Vec3::Zero()) : places.at(measure.b);
  return slope_of(measure, places.at(measure.a), b).value;
}

MeasureValues complete_values(const std::vector<FaceMeasure>& measures, bool female,
                              const MeasureValues& given) {
  const auto preset = [&](const std::string& key) {
    const auto measure = std::ranges::find(measures, key, &FaceMeasure::key);
    return female ? measure->female : measure->male;
  };
  // By how much the parts of each height change that is given, and what is left of it if that is given too.
  std::map<std::string, double> factors;
  for (const FaceMeasure& measure : measures) {
    if (!given.contains(measure.key)) continue;
    factors.try_emplace(measure.key, given.at(measure.key) / preset(measure.key));
    if (!measure.rest_of.empty() && given.contains(measure.rest_of)) {
      factors[measure.rest_of] = (given.at(measure.rest_of) - given.at(measure.key)) /
                                 (preset(measure.rest_of) - preset(measure.key));
    }
  }
  MeasureValues values;
  Problems problems;
  for (const FaceMeasure& measure : measures) {
    const bool is_rest_given = std::ranges::any_of(measures, [&](const FaceMeasure& rest) {
      return rest.rest_of == measure.key && given.contains(rest.key);
    });
    const bool follows = !measure.rest_of.empty() || is_rest_given;
    if (given.contains(measure.key)) {
      values[measure.key] = given.at(measure.key);
    } else if (!follows) {
      const bool is_part = factors.contains(measure.part_of);
      values[measure.key] = preset(measure.key) * (is_part ? factors.at(measure.part_of) : 1.0);
    } else {
      continue;
    }
    const double value = values.at(measure.key);
    if (!is_in_range(measure, value))
      problems.add({place_of(measure), fmt::format("{:g} mm", value), range_of(measure), ""});
  }
  problems.throw_if_any<UsageError>();
  return values;
}

LandmarkPlaces place_landmarks(const std::vector<FaceMeasure>& measures,
                               const MeasureValues& values, const LandmarkPlaces& drawn) {
  const std::vector<Wanted> wanted = wanted_of(measures, values);
  const double size = mean_ratio(wanted, drawn);
  LandmarkPlaces scaled = drawn;
  for (auto& [name, x] : scaled)
    x *= size;
  LandmarkPlaces places = wanted.empty() ? scaled : likeliest_places(wanted, scaled);
  check_places(measures, values, places);
  return places;
}

}  // namespace facies::anatomy
