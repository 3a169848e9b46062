// SPDX-License-Identifier: Apache-2.0
// The reader of triangle_surface.hpp. Two passes, because a face may name a vertex that comes after it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "facies/base/text.hpp"
#include "facies/base/text_file.hpp"
#include "facies/mesh/triangle_surface.hpp"

namespace facies::mesh {
namespace {

/// What says nothing about a surface.
constexpr std::array<std::string_view, 12> passed_over{
    "vn", "vt", "vp", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "l", "p"};

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& path, double scale, Problems& problems)
      : file_(path, problems), bad_(path.string(), "unusable lines or numbers"), scale_(scale) {}

  TriangleSurface read(Problems& problems) {
    for_each_line([&](std::size_t line, const Fields& fields) {
      if (fields[0] == "v") {
        read_vertex(line, fields);
      } else if (fields[0] != "f" &&
                 std::ranges::find(passed_over, fields[0]) == passed_over.end()) {
        bad_.add({file_.where(line, fields[0]), excerpt(fields[0]), "a line of v or f",
                  "surfaces other than polygons are not read"});
      }
    });
    for_each_line([&](std::size_t line, const Fields& fields) {
      if (fields[0] == "v") ++n_before_;
      if (fields[0] == "f") read_face(line, fields);
    });
    if (bad_.empty() && file_.is_usable() && surface_.triangles.empty()) {
      bad_.add({file_.name(), "has no face", "lines like 'f 1 2 3'", "is it an OBJ file?"});
    }
    const bool is_good = bad_.empty();
    bad_.move_to(problems);
    return is_good ? std::move(surface_) : TriangleSurface{};
  }

 private:
  using Fields = std::vector<std::string_view>;

  /// The fields of each line that has any, without comments.
  template <class Read>
  void for_each_line(Read read) {
    for (std::size_t i = 0; i < file_.n_lines(); ++i) {
      const std::string_view line = file_.line(i);
      const Fields fields = split_blanks(line.substr(0, line.find('#')));
      if (!fields.empty()) read(i, fields);
    }
  }

  void read_vertex(std::size_t line, const Fields& fields) {
    // Behind the coordinates some programs write a weight or a colour.
    Vec3& X = surface_.X.emplace_back(Vec3::Zero());
    if (fields.size() < 4 || fields.size() > 8) {
      bad_.add({file_.where(line), fmt::format("a vertex of {} numbers", fields.size() - 1),
                "x y z", ""});
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view field = fields[i + 1];
      X(Eigen::Index(i)) = scale_ * parse_number(field).value_or(HUGE_VAL);
      if (!std::isfinite(X(Eigen::Index(i))))
        bad_.add({file_.where(line, field), excerpt(field), "a finite number", ""});
    }
  }

  void read_face(std::size_t line, const Fields& fields) {
    if (fields.size() < 4) {
      bad_.add({file_.where(line), fmt::format("a face of {} vertices", fields.size() - 1),
                "at least 3", ""});
      return;
    }
    std::vector<Index> corners;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const std::optional<Index> corner = read_corner(line, fields[i]);
      if (corner) corners.push_back(*corner);
    }
    if (corners.size() != fields.size() - 1) return;
    for (std::size_t i = 2; i < corners.size(); ++i)
      surface_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }

  /// The vertex that "4", "4/1", "4//2", "4/1/2" or "-1/..." names.
  std::optional<Index> read_corner(std::size_t line, std::string_view field) {
    const Fields parts = split(field, '/');
    const std::optional<long> number = parse_integer(parts[0]);
    const bool is_well_formed =
        number && parts.size() <= 3 && std::ranges::all_of(parts, [](std::string_view part) {
          return part.empty() || parse_integer(part);
        });
    if (!is_well_formed) {
      bad_.add({file_.where(line, field), excerpt(field),
                "a vertex number, or vertex/texture/normal", ""});
      return std::nullopt;
    }
    const auto n = static_cast<long>(surface_.X.size());
    const long position = *number > 0 ? *number - 1 : n_before_ + *number;
    if (*number != 0 && position >= 0 && position < n) return static_cast<Index>(position);
    bad_.add({file_.where(line, field), fmt::format("vertex {}", *number),
              *number < 0 ? fmt::format("one of the {} above this line", n_before_)
                          : fmt::format("1 to {}", n),
              ""});
    return std::nullopt;
  }

  TextFile file_;
  ProblemsOfOneKind bad_;
  double scale_;
  TriangleSurface surface_;
  long n_before_ = 0;  ///< vertices above the present line
};

}  // namespace

TriangleSurface read_obj(const std::filesystem::path& path, double scale, Problems& problems) {
  require(std::isfinite(scale) && scale > 0.0, "read_obj: the scale must be positive");
  return ObjReader(path, scale, problems).read(problems);
}

}  // namespace facies::mesh
