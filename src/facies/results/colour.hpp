// SPDX-License-Identifier: Apache-2.0
// Colours of pictures: colour maps whose equal steps look equal, and round numbers for colour bars.
#pragma once

#include <array>
#include <vector>

namespace facies::results {

/// A colour in sRGB, each component 0..1.
struct Colour {
  float r = 0.0F, g = 0.0F, b = 0.0F;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// The same colour as amounts of light, which can be added and averaged; and back.
[[nodiscard]] std::array<float, 3> to_light(const Colour& colour);
[[nodiscard]] Colour from_light(const std::array<float, 3>& light);

enum class ColourMap {
  lajolla,    ///< magnitudes on a shaded surface: cream is small, like skin, dark red is large
  viridis,    ///< magnitudes on a flat picture: dark is small, bright is large
  cool_warm,  ///< signed values: blue below zero, grey at zero, red above
};

/// The colour at t in 0..1; values outside are clamped, NaN gives the colour at 0.
[[nodiscard]] Colour colour_at(ColourMap map, double t);

/// Which values a colour map covers. minimum < maximum.
struct ColourScale {
  ColourMap map = ColourMap::lajolla;
  double minimum = 0.0, maximum = 1.0;

  [[nodiscard]] Colour colour_of(double value) const;
  /// Round numbers from minimum to maximum, both included where they are round; 4 to 9 of them.
  [[nodiscard]] std::vector<double> ticks() const;
};

/// The smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `value`; 1 for value <= 0.
[[nodiscard]] double round_up(double value);

}  // namespace facies::results
