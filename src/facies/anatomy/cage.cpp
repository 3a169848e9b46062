// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/cage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/base/text_file.hpp"

namespace facies::anatomy {
namespace {

using Json = nlohmann::json;
using Quad = std::array<Index, 4>;

/// From (lateral, up, forward) to the axes of a face: -x anterior, +y the subject's right, +z up.
Vec3 in_face(const Vec3& drawn) {
  return {-drawn.z(), drawn.x(), drawn.y()};
}

std::string point_name(const std::string& row, std::size_t column) {
  return fmt::format("{}.{}", row, column);
}

/// What a drawing may say (cage.hpp).
const std::vector<std::string>& known_keys() {
  static const std::vector<std::string> keys{"about", "unit",   "rows",  "sheets",  "without",
                                             "rings", "strips", "quads", "mirrored"};
  return keys;
}

/// One file on its way to a cage.
class CageReader {
 public:
  CageReader(const std::filesystem::path& path, Problems& problems)
      : path_(path.string()), problems_(problems) {}

  Cage read(const Json& drawing);

 private:
  void check_keys(const Json& drawing);
  void read_rows(const Json& rows);
  void read_row(const std::string& row, const Json& points);
  void add_sheets(const Json& sheets, const Json& without);
  void add_sheet(const std::string& upper, const std::string& lower,
                 const std::set<std::string>& left_out);
  void add_bands(const std::string& key, const Json& bands, bool closed);
  void add_quads(const Json& quads);
  void add_twins();
  void make_consistent();
  void face_outwards();
  void check_surface();

  /// The points of a list: "lip0.0:6", or several of these.
  std::vector<Index> points_of(const Json& list, const std::string& where);
  /// The value if it is a list, else a problem and an empty one; and so on.
  const Json& list(const Json& value, const std::string& where);
  std::string text(const Json& value, const std::string& where);

  void refuse(const std::string& where, const std::string& found, const std::string& expected,
              const std::string& hint = "") {
    problems_.add({path_ + where, found, expected, hint});
  }
  [[nodiscard]] std::optional<Index> find(const std::string& name) const {
    const auto found = cage_.index.find(name);
    if (found == cage_.index.end()) return std::nullopt;
    return found->second;
  }

  std::string path_;
  Problems& problems_;
  Cage cage_;
  std::map<std::string, std::size_t> row_lengths_;
  Json none_ = Json::array();
};

const Json& CageReader::list(const Json& value, const std::string& where) {
  if (value.is_array()) return value;
  refuse(where, excerpt(value.dump()), "a list in [ ]");
  return none_;
}

std::string CageReader::text(const Json& value, const std::string& where) {
  if (value.is_string()) return value.get<std::string>();
  refuse(where, excerpt(value.dump()), "a name in quotes");
  return "";
}

void CageReader::check_keys(const Json& drawing) {
  for (const auto& [key, value] : drawing.items()) {
    if (std::ranges::find(known_keys(), key) == known_keys().end())
      refuse("/" + key, "unknown key", "", did_you_mean(key, known_keys()));
  }
  const Json unit = drawing.value("unit", Json());
  if (unit != "mm") refuse("/unit", unit.dump(), "\"mm\", the unit of the points");
  const Json mirrored = drawing.value("mirrored", Json(false));
  if (!mirrored.is_boolean()) refuse("/mirrored", excerpt(mirrored.dump()), "true or false");
}

void CageReader::read_rows(const Json& rows) {
  if (!rows.is_object() || rows.empty()) {
    refuse("/rows", excerpt(rows.dump()), "rows of points by name in { }");
    return;
  }
  for (const auto& [row, points] : rows.items())
    read_row(row, list(points, "/rows/" + row));
}

void CageReader::read_row(const std::string& row, const Json& points) {
  row_lengths_[row] = points.size();
  for (std::size_t column = 0; column < points.size(); ++column) {
    const Json& point = points[column];
    if (point.is_null()) continue;
    const bool is_point = point.is_array() && point.size() == 3 &&
                          std::ranges::all_of(point, [](const Json& x) { return x.is_number(); });
    if (!is_point) {
      refuse(fmt::format("/rows/{}/{}", row, column), excerpt(point.dump()),
             "three numbers [lateral, up, forward] or null");
      continue;
    }
    const std::string name = point_name(row, column);
    cage_.index[name] = to_index(cage_.points.size());
    cage_.names.push_back(name);
    cage_.points.push_back(
        in_face({point[0].get<double>(), point[1].get<double>(), point[2].get<double>()}));
  }
}

void CageReader::add_sheets(const Json& sheets, const Json& without) {
  std::set<std::string> left_out;
  for (const Json& cell : without) {
    const std::string name = text(cell, "/without");
    if (!find(name)) refuse("/without", name, "a point", did_you_mean(name, cage_.names));
    left_out.insert(name);
  }
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const std::string where = fmt::format("/sheets/{}", s);
    std::string upper;
    for (const Json& row : list(sheets[s], where)) {
      const std::string lower = text(row, where);
      if (!row_lengths_.contains(lower)) {
        std::vector<std::string> rows;
        std::ranges::transform(row_lengths_, std::back_inserter(rows),
                               [](const auto& known) { return known.first; });
        refuse(where, lower, "a row", did_you_mean(lower, rows));
      } else if (!upper.empty()) {
        add_sheet(upper, lower, left_out);
      }
      upper = lower;
    }
  }
}

void CageReader::add_sheet(const std::string& upper, const std::string& lower,
                           const std::set<std::string>& left_out) {
  for (std::size_t k = 0; k < row_lengths_[upper]; ++k) {
    const auto a = find(point_name(upper, k));
    const auto b = find(point_name(upper, k + 1));
    const auto c = find(point_name(lower, k + 1));
    const auto d = find(point_name(lower, k));
    if (a && b && c && d && !left_out.contains(point_name(upper, k)))
      cage_.net.quads.push_back({*a, *b, *c, *d});
  }
}

std::vector<Index> CageReader::points_of(const Json& list, const std::string& where) {
  if (!list.is_array()) return points_of_range(cage_, text(list, where), path_ + where, problems_);
  std::vector<Index> points;
  for (const Json& range : list) {
    const std::vector<Index> more =
        points_of_range(cage_, text(range, where), path_ + where, problems_);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

void CageReader::add_bands(const std::string& key, const Json& bands, bool closed) {
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const std::string where = fmt::format("/{}/{}", key, b);
    const Json& band = list(bands[b], where);
    std::vector<Index> before;
    for (std::size_t i = 0; i < band.size(); ++i) {
      std::vector<Index> points = points_of(band[i], where);
      const std::size_t n = points.size();
      if (i > 0 && n != before.size()) {
        refuse(fmt::format("{}/{}", where, i), fmt::format("{} points", n),
               fmt::format("{}, as many as in the list before", before.size()));
      } else if (i > 0) {
        for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k) {
          cage_.net.quads.push_back(
              {before[k], before[(k + 1) % n], points[(k + 1) % n], points[k]});
        }
      }
      before = std::move(points);
    }
  }
}

void CageReader::add_quads(const Json& quads) {
  for (std::size_t q = 0; q < quads.size(); ++q) {
    const std::string where = fmt::format("/quads/{}", q);
    const std::vector<Index> points = points_of(quads[q], where);
    if (points.size() != 4) {
      refuse(where, fmt::format("{} points", points.size()), "four");
      continue;
    }
    cage_.net.quads.push_back({points[0], points[1], points[2], points[3]});
  }
}

void CageReader::add_twins() {
  const std::size_t n_points = cage_.points.size();
  const std::size_t n_quads = cage_.net.quads.size();
  cage_.mirrored.resize(n_points);
  for (std::size_t i = 0; i < n_points; ++i) {
    cage_.mirrored[i] = to_index(i);
    Vec3 twin = cage_.points[i];
    if (twin.y() == 0.0) continue;
    twin.y() = -twin.y();
    cage_.mirrored[i] = to_index(cage_.points.size());
    cage_.mirrored.push_back(to_index(i));
    cage_.names.push_back(cage_.names[i] + "-left");
    cage_.index[cage_.names.back()] = cage_.mirrored[i];
    cage_.points.push_back(twin);
  }
  for (std::size_t q = 0; q < n_quads; ++q) {
    Quad twin = cage_.net.quads[q];
    for (Index& v : twin)
      v = cage_.mirrored[at(v)];
    std::ranges::reverse(twin);
    cage_.net.quads.push_back(twin);
  }
}

/// Turns quadrilaterals until neighbours agree, from the first of each connected part on.
void CageReader::make_consistent() {
  std::vector<Quad>& quads = cage_.net.quads;
  const std::map<mesh::NetEdge, std::vector<Index>> along = mesh::edges_of(cage_.net);
  const auto runs_along = [&](std::size_t q, Index from, Index to) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (quads[q][k] == from && quads[q][(k + 1) % 4] == to) return true;
    }
    return false;
  };
  std::vector<bool> done(quads.size(), false);
  for (std::size_t first = 0; first < quads.size(); ++first) {
    if (done[first]) continue;
    done[first] = true;
    std::vector<std::size_t> front{first};
    while (!front.empty()) {
      const Quad quad = quads[front.back()];
      front.pop_back();
      for (std::size_t k = 0; k < 4; ++k) {
        const Index from = quad[k];
        const Index to = quad[(k + 1) % 4];
        for (const Index neighbour : along.at(mesh::edge_of(from, to))) {
          const std::size_t other = at(neighbour);
          if (done[other]) continue;
          if (runs_along(other, from, to)) std::ranges::reverse(quads[other]);
          done[other] = true;
          front.push_back(other);
        }
      }
    }
  }
}

void CageReader::face_outwards() {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : cage_.points)
    mean += x / static_cast<double>(cage_.points.size());
  double outwards = 0.0;
  for (const Quad& q : cage_.net.quads) {
    const auto x = [&](std::size_t k) -> const Vec3& { return cage_.points[at(q[k])]; };
    outwards += (x(2) - x(0)).cross(x(3) - x(1)).dot(x(0) - mean);
  }
  if (outwards >= 0.0) return;
  for (Quad& quad : cage_.net.quads)
    std::ranges::reverse(quad);
}

/// A net that a smooth surface through these places can follow, which have no order, it can follow through any.
bool can_be_smooth(const mesh::QuadNet& net) {
  std::vector<Vec3> places;
  for (Index v = 0; v < net.n_vertices; ++v)
    places.emplace_back(std::sin(1.0 * v), std::sin(2.0 * v), std::sin(5.0 * v));
  try {
    (void)mesh::control_points_through(net, places);
  } catch (const BugError&) {
    return false;
  }
  return true;
}

void CageReader::check_surface() {
  if (cage_.net.quads.empty()) {
    refuse("", "no quadrilateral", "a surface", "sheets, rings, strips and quads make them");
  } else if (const auto fault = mesh::find_fault(cage_.net)) {
    std::string names;
    for (const Index v : fault->vertices)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", cage_.names.at(at(v)));
    refuse("", fmt::format("{} ({})", fault->what, names), "a surface of quadrilaterals",
           "look through the sheets, rings, strips and quads that have these points");
  } else if (!can_be_smooth(cage_.net)) {
    refuse("", "a net that no smooth surface through its points can follow", "an irregular one",
           "points with three quadrilaterals each, as of a cube, need others between them");
  }
}

Cage CageReader::read(const Json& drawing) {
  const std::size_t before = problems_.size();
  if (!drawing.is_object()) {
    refuse("", excerpt(drawing.dump()), "a drawing: one object in { }");
    return {};
  }
  check_keys(drawing);
  const auto list_at = [&](const char* key) {
    return list(drawing.value(key, none_), fmt::format("/{}", key));
  };
  read_rows(drawing.value("rows", Json::object()));
  add_sheets(list_at("sheets"), list_at("without"));
  add_bands("rings", list_at("rings"), true);
  add_bands("strips", list_at("strips"), false);
  add_quads(list_at("quads"));
  if (problems_.size() != before) return {};
  if (drawing.value("mirrored", false)) {
    add_twins();
  } else {
    for (std::size_t i = 0; i < cage_.points.size(); ++i)
      cage_.mirrored.push_back(to_index(i));
  }
  cage_.net.n_vertices = to_index(cage_.points.size());
  make_consistent();
  face_outwards();
  check_surface();
  return problems_.size() == before ? std::move(cage_) : Cage{};
}

/// "path:line:column" of a byte of a text, all counted from 1.
std::string place_in(const std::filesystem::path& path, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}:{}", path.string(), 1 + std::ranges::count(before, '\n'),
                     1 + before.size() - line_begin);
}

}  // namespace

mesh::TriangleSurface smooth_surface(const Cage& cage, const std::vector<Vec3>& points) {
  constexpr int levels = 2;
  const mesh::LimitMesh fine = mesh::limit_mesh(cage.net, levels);
  mesh::TriangleSurface surface;
  surface.X = mesh::weighted(fine.limit, mesh::control_points_through(cage.net, points));
  surface.triangles = mesh::cut_into_triangles(fine.net);
  return surface;
}

std::vector<Index> points_of_range(const Cage& cage, const std::string& range,
                                   const std::string& where, Problems& problems) {
  const std::vector<std::string_view> parts = split(range, '.');
  const std::vector<std::string_view> ends =
      parts.size() == 2 ? split(parts[1], ':') : std::vector<std::string_view>{};
  const std::optional<long> first = ends.empty() ? std::nullopt : parse_integer(ends.front());
  const std::optional<long> last = ends.empty() ? std::nullopt : parse_integer(ends.back());
  std::vector<Index> points;
  if (!first || !last || *first < 0 || *last < 0 || ends.size() > 2) {
    problems.add({where, excerpt(range), "points such as \"lip0.3\" or \"lip0.0:6\"", ""});
    return points;
  }
  if (static_cast<std::size_t>(std::abs(*last - *first)) >= cage.names.size()) {
    problems.add({where, excerpt(range), "no more points than the drawing has", ""});
    return points;
  }
  const long step = *last >= *first ? 1 : -1;
  for (long k = *first; k != *last + step; k += step) {
    const std::string name = fmt::format("{}.{}", parts[0], k);
    const auto found = cage.index.find(name);
    if (found != cage.index.end()) {
      points.push_back(found->second);
    } else {
      problems.add({where, name, "a point", did_you_mean(name, cage.names)});
    }
  }
  return points;
}

Cage read_cage(const std::filesystem::path& path, Problems& problems) {
  std::string text;
  try {
    text = read_file(path);
    return CageReader(path, problems).read(Json::parse(text));
  } catch (const DataError& error) {
    problems.add(error.problems());
  } catch (const Json::parse_error& error) {
    problems.add({place_in(path, text, error.byte), "no JSON from here on",
                  "a drawing of a surface in JSON", error.what()});
  } catch (const Json::exception& error) {
    problems.add({path.string(), error.what(), "a drawing of a surface in JSON", ""});
  }
  return {};
}

}  // namespace facies::anatomy
