// SPDX-License-Identifier: Apache-2.0
// Reads scenarios from literals, for tests.
#pragma once

#include <string>
#include <vector>

#include "facies/scenario/read_scenario.hpp"

namespace facies::scenario {

/// The text as a file called "x.yaml" with `changes` ("key=value") on top.
inline Reading read(const std::string& text, const std::vector<std::string>& changes = {}) {
  std::vector<Override> overrides;
  for (const std::string& change : changes)
    overrides.push_back(parse_override(change));
  return read_text(text, "x.yaml", "x", overrides);
}

/// Every problem in one text, one below the other.
inline std::string problems_of(const std::string& text,
                               const std::vector<std::string>& changes = {}) {
  std::string all;
  for (const Problem& problem : read(text, changes).problems)
    all += to_string(problem) + '\n';
  return all;
}

/// The smallest scenario, to put other things in front of.
inline const std::string relax = "steps: [express: {ZYG: 0}]\n";

}  // namespace facies::scenario
