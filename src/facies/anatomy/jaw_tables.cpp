// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/jaw_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "facies/anatomy/table.hpp"
#include "facies/base/text.hpp"
#include "facies/math/rotation.hpp"

namespace facies::anatomy {
namespace {

namespace fs = std::filesystem;

constexpr double coincident = 1e-3;   // [mm]
constexpr double unit_length = 1e-3;  // what a normal's length may differ from 1
constexpr double newton = 1000.0;     // [mN]

constexpr const char* a_bone = "a bone of jaw-bones.csv";

/// What the rows of all tables share: where numbers are read and names looked up.
class Row {
 public:
  Row(const Table& table, std::size_t row, Problems& problems)
      : table_(table), row_(row), problems_(problems) {}

  [[nodiscard]] std::string text(const std::string& column) const {
    return std::string(table_.text(row_, column));
  }

  [[nodiscard]] std::string name(std::vector<std::string>& names) const {
    return table_.new_name(row_, "name", names, problems_);
  }

  [[nodiscard]] bool flag(const std::string& column) const {
    return table_.flag(row_, column, problems_);
  }

  [[nodiscard]] double number(const std::string& column) const {
    return table_.number(row_, column, problems_).value_or(0.0);
  }

  /// A number that `holds`; a problem where it does not.
  template <class Holds>
  [[nodiscard]] double number(const std::string& column, const char* expected,
                              const Holds& holds) const {
    const std::optional<double> value = table_.number(row_, column, problems_);
    if (value && !holds(*value)) refuse(column, fmt::format("{}", *value), expected);
    return value.value_or(0.0);
  }
  [[nodiscard]] double positive(const std::string& column) const {
    return number(column, "more than 0", [](double x) { return x > 0.0; });
  }
  [[nodiscard]] double not_negative(const std::string& column) const {
    return number(column, "0 or more", [](double x) { return x >= 0.0; });
  }

  /// Columns before_x_after, before_y_after, before_z_after.
  [[nodiscard]] Vec3 vector(const std::string& before, const std::string& after) const {
    const double x = number(before + "x" + after);
    const double y = number(before + "y" + after);
    return {x, y, number(before + "z" + after)};
  }

  /// Place of the name in `column` in a list of named things; -1 and a problem where it is not there, `expected` in
  /// words. Of an empty list, whose table has problems of its own, nothing is said.
  template <class T>
  [[nodiscard]] Index place(const std::string& column, std::string_view name,
                            const std::vector<T>& list, const std::string& expected) const {
    const auto found = std::ranges::find(list, name, &T::name);
    if (found != list.end()) return to_index(static_cast<std::size_t>(found - list.begin()));
    std::vector<std::string> known;
    known.reserve(list.size());
    for (const T& entry : list)
      known.push_back(entry.name);
    if (!list.empty()) {
      refuse(column, excerpt(name), expected, did_you_mean(name, known));
    }
    return -1;
  }
  template <class T>
  [[nodiscard]] Index place(const std::string& column, const std::vector<T>& list,
                            const std::string& expected) const {
    return place(column, text(column), list, expected);
  }

  [[nodiscard]] std::string where(const std::string& column) const {
    return table_.where(row_, column);
  }

  void refuse(const std::string& column, const std::string& found, const std::string& expected,
              const std::string& hint = "") const {
    problems_.add({where(column), found, expected, hint});
  }

 private:
  const Table& table_;
  std::size_t row_;
  Problems& problems_;
};

/// Calls read(row) for every row of the table.
template <class Read>
void for_each_row(const fs::path& path, const std::vector<std::string>& columns, Problems& problems,
                  const Read& read) {
  const Table table(path, columns, problems);
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    read(Row(table, row, problems));
}

Mat3 read_inertia(const Row& row) {
  const auto entry = [&](const char* axes) {
    return row.number(fmt::format("inertia_{}_kg_mm2", axes));
  };
  Mat3 inertia = to_matrix(
      Sym3<double>{entry("xx"), entry("yy"), entry("zz"), entry("xy"), entry("yz"), entry("xz")});
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvalues();
  if (!(principal(0) > 0.0 && principal(0) + principal(1) >= principal(2))) {
    row.refuse("inertia_xx_kg_mm2",
               fmt::format("principal moments of inertia {:.4g}, {:.4g}, {:.4g}", principal(0),
                           principal(1), principal(2)),
               "positive, none larger than the other two together");
  }
  return inertia;
}

void read_bones(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  int n_moving = 0;
  for_each_row(path,
               {"name", "meaning", "moves", "mass_kg", "centre_x_mm", "centre_y_mm", "centre_z_mm",
                "inertia_xx_kg_mm2", "inertia_yy_kg_mm2", "inertia_zz_kg_mm2", "inertia_xy_kg_mm2",
                "inertia_yz_kg_mm2", "inertia_xz_kg_mm2", "translational_damping_kg_per_s",
                "rotational_damping_kg_mm2_per_s"},
               problems, [&](const Row& row) {
                 Bone bone;
                 bone.name = row.name(names);
                 bone.meaning = row.text("meaning");
                 bone.moves = row.flag("moves");
                 if (bone.moves) {
                   ++n_moving;
                   jaw.mandible = to_index(jaw.bones.size());
                   bone.mass = row.positive("mass_kg");
                   bone.centre = row.vector("centre_", "_mm");
                   bone.inertia = read_inertia(row);
                   bone.translational_damping = row.not_negative("translational_damping_kg_per_s");
                   bone.rotational_damping = row.not_negative("rotational_damping_kg_mm2_per_s");
                 }
                 jaw.bones.push_back(std::move(bone));
               });
  if (!jaw.bones.empty() && n_moving != 1) {
    problems.add({path.string(), fmt::format("{} bones that move", n_moving), "one, the jaw", ""});
  }
}

JawPose read_pose(const Row& row, const Bone& jaw) {
  const Vec3 centre = row.vector("centre_", "_mm");
  const Vec3 axis = row.vector("axis_", "");
  const double angle = row.number("angle_deg") * std::numbers::pi / 180.0;
  if (std::abs(axis.norm() - 1.0) > unit_length) {
    row.refuse("axis_x", fmt::format("an axis of length {:.4g}", axis.norm()), "length 1");
  }
  return {centre - jaw.centre, rotation_matrix(angle * axis)};
}

void read_poses(const fs::path& path, Jaw& jaw, Problems& problems) {
  const Bone nowhere;
  const Bone& mandible = jaw.mandible < 0 ? nowhere : jaw.bones[at(jaw.mandible)];
  std::vector<std::string> found;
  for_each_row(path,
               {"name", "centre_x_mm", "centre_y_mm", "centre_z_mm", "axis_x", "axis_y", "axis_z",
                "angle_deg"},
               problems, [&](const Row& row) {
                 const std::string name = row.name(found);
                 const JawPose pose = read_pose(row, mandible);
                 if (name == "start") {
                   jaw.start = pose;
                 } else if (name == "intercuspal") {
                   jaw.intercuspal = pose;
                 } else {
                   row.refuse("name", excerpt(name), "'start' or 'intercuspal'");
                 }
               });
  for (const char* name : {"start", "intercuspal"}) {
    if (!found.empty() && std::ranges::find(found, name) == found.end()) {
      problems.add({path.string(), fmt::format("no pose '{}'", name),
                    "the poses start and intercuspal", ""});
    }
  }
}

void read_points(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for_each_row(path, {"name", "meaning", "bone", "x_mm", "y_mm", "z_mm"}, problems,
               [&](const Row& row) {
                 JawPoint point;
                 point.name = row.name(names);
                 point.meaning = row.text("meaning");
                 point.at = {row.place("bone", jaw.bones, a_bone), row.vector("", "_mm")};
                 jaw.points.push_back(std::move(point));
               });
}

/// The point of the jaw that a row leads, -1 and a problem where there is none.
Index read_led_point(const Row& row, const Jaw& jaw) {
  const Index point = row.place("point", jaw.points, "a point of jaw-points.csv");
  if (point < 0 || jaw.mandible < 0) return -1;
  const Index bone = jaw.points[at(point)].at.bone;
  if (bone == jaw.mandible) return point;
  if (bone >= 0) {
    row.refuse("point", excerpt(row.text("point")) + " of " + jaw.bones[at(bone)].name,
               "a point of the bone that moves");
  }
  return -1;
}

void read_guides(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for_each_row(path, {"name", "point", "travel_mm", "descent_mm", "first_slope", "last_slope"},
               problems, [&](const Row& row) {
                 JawGuide guide;
                 guide.name = row.name(names);
                 guide.where = row.where("name");
                 guide.point = read_led_point(row, jaw);
                 const double travel = row.positive("travel_mm");
                 const double descent = row.number("descent_mm");
                 const double first = row.number("first_slope");
                 const double last = row.number("last_slope");
                 if (guide.point >= 0) {
                   const Vec3 begin =
                       place_of(jaw, jaw.intercuspal, jaw.points[at(guide.point)].at);
                   guide.curve = swept_curve(begin.x(), begin.z(), travel, descent, first, last);
                 }
                 jaw.guides.push_back(std::move(guide));
               });
}

/// A unit vector; any where the table has none.
Vec3 read_normal(const Row& row) {
  const Vec3 normal = row.vector("normal_", "");
  if (std::abs(normal.norm() - 1.0) <= unit_length) return normal.normalized();
  row.refuse("normal_x", fmt::format("a normal of length {:.4g}", normal.norm()), "length 1");
  return Vec3::UnitZ();
}

void read_stops(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for_each_row(
      path,
      {"name", "meaning", "point", "enabled", "normal_x", "normal_y", "normal_z", "offset_mm"},
      problems, [&](const Row& row) {
        JawStop stop;
        stop.name = row.name(names);
        stop.where = row.where("name");
        stop.meaning = row.text("meaning");
        stop.point = read_led_point(row, jaw);
        stop.enabled = row.flag("enabled");
        stop.normal = read_normal(row);
        const double offset = row.number("offset_mm");
        if (stop.point >= 0) {
          stop.plane =
              place_of(jaw, jaw.intercuspal, jaw.points[at(stop.point)].at) - offset * stop.normal;
        }
        jaw.stops.push_back(std::move(stop));
      });
}

Side read_side(const Row& row) {
  const std::string side = row.text("side");
  if (side == "left") return Side::left;
  if (side == "right") return Side::right;
  if (side != "middle") row.refuse("side", excerpt(side), "left, right or middle");
  return Side::middle;
}

JawMuscle read_muscle(const Row& row, const Jaw& jaw, std::vector<std::string>& names) {
  JawMuscle muscle;
  muscle.name = row.name(names);
  muscle.meaning = row.text("muscle");
  muscle.side = read_side(row);
  const std::string bone = fmt::format("{} for muscle {}", a_bone, muscle.name);
  muscle.origin = {row.place("origin_bone", jaw.bones, bone), row.vector("origin_", "_mm")};
  muscle.insertion = {row.place("insertion_bone", jaw.bones, bone),
                      row.vector("insertion_", "_mm")};
  if ((muscle.origin.X - muscle.insertion.X).norm() < coincident) {
    row.refuse("insertion_x_mm", fmt::format("both ends of muscle {} at one place", muscle.name),
               "two different points");
  } else if (muscle.origin.bone >= 0 && muscle.origin.bone == muscle.insertion.bone) {
    row.refuse("insertion_bone",
               fmt::format("both ends of muscle {} on {}", muscle.name, row.text("origin_bone")),
               "two different bones", "a muscle within one bone moves nothing");
  }
  muscle.max_force = newton * row.positive("max_force_N");
  muscle.optimal_length = row.positive("opt_length_mm");
  muscle.max_length = row.number("max_length_mm", "more than opt_length_mm",
                                 [&](double x) { return x > muscle.optimal_length; });
  muscle.tendon_ratio = row.number("tendon_ratio", "0 or more and less than 1",
                                   [](double x) { return x >= 0.0 && x < 1.0; });
  muscle.passive_fraction = row.not_negative("passive_fraction");
  muscle.damping = row.not_negative("damping_mN_s_per_mm");
  return muscle;
}

void read_muscles(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for_each_row(
      path,
      {"name", "side", "muscle", "origin_bone", "origin_x_mm", "origin_y_mm", "origin_z_mm",
       "insertion_bone", "insertion_x_mm", "insertion_y_mm", "insertion_z_mm", "max_force_N",
       "opt_length_mm", "max_length_mm", "tendon_ratio", "passive_fraction", "damping_mN_s_per_mm"},
      problems, [&](const Row& row) { jaw.muscles.push_back(read_muscle(row, jaw, names)); });
}

void read_exciters(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for (const JawMuscle& muscle : jaw.muscles)
    names.push_back(muscle.name);  // a scenario may name either
  for_each_row(path, {"name", "meaning", "muscles"}, problems, [&](const Row& row) {
    Exciter exciter;
    exciter.name = row.name(names);
    exciter.meaning = row.text("meaning");
    const std::string listed = row.text("muscles");
    for (const std::string_view name : split_blanks(listed)) {
      const Index muscle = row.place("muscles", name, jaw.muscles, "a muscle of jaw-muscles.csv");
      if (std::ranges::find(exciter.muscles, muscle) != exciter.muscles.end() && muscle >= 0) {
        row.refuse("muscles", excerpt(name) + " twice", "each muscle once");
      }
      exciter.muscles.push_back(muscle);
    }
    if (exciter.muscles.empty()) row.refuse("muscles", "no muscle", "at least one");
    std::ranges::sort(exciter.muscles);
    jaw.exciters.push_back(std::move(exciter));
  });
}

SurfaceKind read_kind(const Row& row) {
  const std::string kind = row.text("kind");
  if (kind == "shell") return SurfaceKind::shell;
  if (kind == "cast") return SurfaceKind::cast;
  if (kind != "solid") row.refuse("kind", excerpt(kind), "solid, shell or cast");
  return SurfaceKind::solid;
}

void read_surfaces(const fs::path& path, Jaw& jaw, Problems& problems) {
  std::vector<std::string> names;
  for_each_row(path, {"name", "meaning", "bone", "kind", "file", "scale", "closed", "presses"},
               problems, [&](const Row& row) {
                 BoneSurface surface;
                 surface.name = row.name(names);
                 surface.meaning = row.text("meaning");
                 surface.bone = row.place("bone", jaw.bones, a_bone);
                 surface.kind = read_kind(row);
                 surface.file = row.text("file");
                 surface.scale = row.positive("scale");
                 surface.closed = row.flag("closed");
                 surface.presses = row.flag("presses");
                 if (surface.file.empty()) row.refuse("file", "no file", "the file of the surface");
                 jaw.surfaces.push_back(std::move(surface));
               });
}

void read_crowns(const fs::path& path, Jaw& jaw, Problems& problems) {
  for_each_row(path, {"surface", "normal_x", "normal_y", "normal_z", "offset_mm", "back_mm"},
               problems, [&](const Row& row) {
                 Crowns crowns;
                 crowns.surface =
                     row.place("surface", jaw.surfaces, "a surface of jaw-surfaces.csv");
                 crowns.normal = read_normal(row);
                 crowns.offset = row.number("offset_mm");
                 crowns.back = row.number("back_mm");
                 jaw.crowns.push_back(crowns);
               });
}

}  // namespace

std::vector<fs::path> jaw_table_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* table :
       {"bones", "poses", "points", "guides", "stops", "muscles", "exciters", "surfaces", "crowns"})
    files.push_back(folder / fmt::format("jaw-{}.csv", table));
  return files;
}

Jaw read_jaw_tables(const fs::path& folder, Problems& problems) {
  Jaw jaw;
  read_bones(folder / "jaw-bones.csv", jaw, problems);
  read_poses(folder / "jaw-poses.csv", jaw, problems);
  read_points(folder / "jaw-points.csv", jaw, problems);
  read_guides(folder / "jaw-guides.csv", jaw, problems);
  read_stops(folder / "jaw-stops.csv", jaw, problems);
  read_muscles(folder / "jaw-muscles.csv", jaw, problems);
  read_exciters(folder / "jaw-exciters.csv", jaw, problems);
  read_surfaces(folder / "jaw-surfaces.csv", jaw, problems);
  read_crowns(folder / "jaw-crowns.csv", jaw, problems);
  return jaw;
}

}  // namespace facies::anatomy
