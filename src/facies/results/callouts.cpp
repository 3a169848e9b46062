// SPDX-License-Identifier: Apache-2.0
#include "facies/results/callouts.hpp"

#include <algorithm>

namespace facies::results {

namespace {

/// The ascending numbers nearest to these (pool adjacent violators).
std::vector<double> nearest_ascending(const std::vector<double>& wanted) {
  struct Pool {
    double sum = 0.0;
    std::size_t n = 0;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(n); }
  };
  std::vector<Pool> pools;
  for (const double value : wanted) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].n += pools.back().n;
      pools.pop_back();
    }
  }
  std::vector<double> result;
  for (const Pool& pool : pools)
    result.insert(result.end(), pool.n, pool.mean());
  return result;
}

/// Rows at least `spacing` apart near to ascending ones.
std::vector<double> spread(const std::vector<double>& rows, int height, double spacing) {
  std::vector<double> wanted;
  for (std::size_t i = 0; i < rows.size(); ++i)
    wanted.push_back(rows[i] - static_cast<double>(i) * spacing);
  const double first = 0.5 * spacing;
  const double last = height - (static_cast<double>(rows.size()) - 0.5) * spacing;
  std::vector<double> result = nearest_ascending(wanted);
  for (std::size_t i = 0; i < rows.size(); ++i)
    result[i] =
        std::clamp(result[i], first, std::max(first, last)) + static_cast<double>(i) * spacing;
  return result;
}

}  // namespace

std::vector<CalloutPlace> place_callouts(std::span<const Dot> dots, int width, int height,
                                         double spacing) {
  std::vector<CalloutPlace> places;
  for (const bool is_left : {true, false}) {
    std::vector<std::size_t> side;
    for (std::size_t d = 0; d < dots.size(); ++d) {
      if ((dots[d].column < 0.5 * width) == is_left) side.push_back(d);
    }
    std::ranges::stable_sort(side, {}, [&](std::size_t d) { return dots[d].row; });
    std::vector<double> rows;
    rows.reserve(side.size());
    for (const std::size_t d : side)
      rows.push_back(dots[d].row);
    rows = spread(rows, height, spacing);
    for (std::size_t i = 0; i < side.size(); ++i)
      places.push_back({side[i], is_left, rows[i]});
  }
  return places;
}

}  // namespace facies::results
