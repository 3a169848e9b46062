// SPDX-License-Identifier: Apache-2.0
#include "facies/anatomy/builtin_options.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "facies/base/quantity.hpp"
#include "facies/base/text.hpp"
#include "facies/base/text_file.hpp"

namespace facies::anatomy {
namespace {

const std::array<std::pair<const char*, FaceSize>, 4> sizes{{{"coarse", FaceSize::coarse},
                                                             {"standard", FaceSize::standard},
                                                             {"fine", FaceSize::fine},
                                                             {"finer", FaceSize::finer}}};

/// A length that is given for a FaceMeasure or a DepthSite.
template <class Measure>
void set_length(const Measure& measure, const std::string& where, std::string_view text,
                MeasureValues& values, Problems& problems) {
  const auto value = parse_quantity(text, unit("mm"));
  if (const auto* problem = std::get_if<Problem>(&value)) {
    problems.add({where, problem->found, problem->expected, problem->hint});
    return;
  }
  const double length = std::get<double>(value);
  if (length < measure.smallest || length > measure.largest) {
    problems.add({where, std::string(text),
                  fmt::format("{:g} mm to {:g} mm", measure.smallest, measure.largest),
                  measure.meaning});
  }
  values[measure.key] = length;
}

}  // namespace

std::string builtin_usage() {
  return "builtin:size=standard,preset=male";
}

BuiltinOptions parse_builtin_options(const std::string& text,
                                     const std::vector<FaceMeasure>& measures,
                                     const std::vector<DepthSite>& depths) {
  BuiltinOptions options;
  Problems problems;
  std::vector<std::string> known{"size", "preset"};
  std::ranges::transform(measures, std::back_inserter(known), &FaceMeasure::key);
  std::ranges::transform(depths, std::back_inserter(known), &DepthSite::key);
  std::vector<std::string> seen;
  for (const std::string_view item :
       text.empty() ? std::vector<std::string_view>{} : split(text, ',')) {
    const std::size_t equals = item.find('=');
    const std::string key(trim(item.substr(0, equals)));
    const std::string_view value =
        equals == std::string_view::npos ? "" : trim(item.substr(equals + 1));
    const std::string where = "builtin:" + key;
    if (std::ranges::find(seen, key) != seen.end())
      problems.add({where, "given twice", "each option once", ""});
    seen.push_back(key);
    const auto measure = std::ranges::find(measures, key, &FaceMeasure::key);
    const auto depth = std::ranges::find(depths, key, &DepthSite::key);
    if (measure != measures.end()) {
      set_length(*measure, where, value, options.given, problems);
    } else if (depth != depths.end()) {
      set_length(*depth, where, value, options.depths, problems);
    } else if (key == "size") {
      const auto size =
          std::ranges::find_if(sizes, [&](const auto& s) { return s.first == value; });
      if (size == sizes.end()) {
        problems.add({where, excerpt(value), "coarse, standard, fine or finer", ""});
      } else {
        options.size = size->second;
      }
    } else if (key == "preset") {
      options.female = value == "female";
      if (value != "female" && value != "male")
        problems.add({where, excerpt(value), "male or female", ""});
    } else {
      problems.add({where, "unknown option", "", did_you_mean(key, known)});
    }
  }
  problems.throw_if_any<UsageError>();
  return options;
}

}  // namespace facies::anatomy
