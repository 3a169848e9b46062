// SPDX-License-Identifier: Apache-2.0
// Curves in time: lists of points in a scenario, and tables in a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facies/scenario/curve.hpp"
#include "facies/scenario/yaml_tree.hpp"

namespace facies::scenario {

/// A number, or a list of points [time, value] with times such as 0.2 s between 0 and `duration` [s] (not positive: nobody
/// knows how long). Adds every problem; nothing where there is any.
[[nodiscard]] std::optional<Curve> read_curve(const YamlNode& node, double duration,
                                              Problems& problems);

/// A column of a table of curves.
struct NamedCurve {
  std::string name;   ///< "ZYG"
  std::string where;  ///< of the column's title: "smile.csv:1:8"
  Curve curve;
};

/// A table with the column time_s and one for each name, comma separated; lines that begin with '#' do not count. Adds every
/// problem; nothing where there is any.
[[nodiscard]] std::vector<NamedCurve> read_curve_table(const std::filesystem::path& path,
                                                       double duration, Problems& problems);

}  // namespace facies::scenario
