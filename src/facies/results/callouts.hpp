// SPDX-License-Identifier: Apache-2.0
// Names beside a picture: where each stands so that none covers another.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace facies::results {

/// A named point of an image.
struct Dot {
  double column = 0.0, row = 0.0;  ///< in pixels of the image
  std::string label;
};

/// Where the name of a point stands.
struct CalloutPlace {
  std::size_t dot = 0;   ///< position in the list of points
  bool is_left = false;  ///< of the image; else right
  double row = 0.0;      ///< of the middle of the name, in pixels of the image
};

/// Names of points beside an image of this size: on the side that each point is nearer to, in the order of their heights, at
/// least `spacing` [pixels] apart and as near to the heights of their points as that allows (least squares), inside the image where
/// there is room for all. The left ones first, each side from the top.
[[nodiscard]] std::vector<CalloutPlace> place_callouts(std::span<const Dot> dots, int width,
                                                       int height, double spacing);

}  // namespace facies::results
