// SPDX-License-Identifier: Apache-2.0
#include "facies/results/colour.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace facies::results {

namespace {

/// lajolla by F. Crameri, Scientific colour maps (MIT licence, doi:10.5281/zenodo.1243862): rows 255, 238 ... 51 of its
/// 256. The darkest fifth is left out: on a shaded surface it could not be told from shadow.
constexpr std::array<Colour, 13> lajolla_table{{{1.000000F, 0.997796F, 0.794247F},
                                                {0.986977F, 0.930880F, 0.612445F},
                                                {0.964092F, 0.838685F, 0.426519F},
                                                {0.940913F, 0.740544F, 0.341539F},
                                                {0.923462F, 0.657468F, 0.326981F},
                                                {0.907514F, 0.579777F, 0.320985F},
                                                {0.891333F, 0.501443F, 0.315120F},
                                                {0.870213F, 0.417898F, 0.308478F},
                                                {0.815214F, 0.334831F, 0.297889F},
                                                {0.700683F, 0.285371F, 0.278167F},
                                                {0.562556F, 0.252534F, 0.238525F},
                                                {0.431694F, 0.213130F, 0.178213F},
                                                {0.317951F, 0.174991F, 0.118267F}}};

/// viridis by S. van der Walt, N. Smith and E. Firing (matplotlib, CC0): rows 0, 17, 34 ... 255 of its 256.
constexpr std::array<Colour, 16> viridis_table{{{0.267004F, 0.004874F, 0.329415F},
                                                {0.282656F, 0.100196F, 0.422160F},
                                                {0.277134F, 0.185228F, 0.489898F},
                                                {0.253935F, 0.265254F, 0.529983F},
                                                {0.221989F, 0.339161F, 0.548752F},
                                                {0.190631F, 0.407061F, 0.556089F},
                                                {0.163625F, 0.471133F, 0.558148F},
                                                {0.139147F, 0.533812F, 0.555298F},
                                                {0.120565F, 0.596422F, 0.543611F},
                                                {0.134692F, 0.658636F, 0.517649F},
                                                {0.208030F, 0.718701F, 0.472873F},
                                                {0.327796F, 0.773980F, 0.406640F},
                                                {0.477504F, 0.821444F, 0.318195F},
                                                {0.647257F, 0.858400F, 0.209861F},
                                                {0.824940F, 0.884720F, 0.106217F},
                                                {0.993248F, 0.906157F, 0.143936F}}};

constexpr Colour bytes(int r, int g, int b) {
  return {static_cast<float>(r) / 255.0F, static_cast<float>(g) / 255.0F,
          static_cast<float>(b) / 255.0F};
}

/// The smooth cool-warm map of K. Moreland, "Diverging color maps for scientific visualization" (2009), evaluated from
/// its definition in Msh space at 17 equal steps.
constexpr std::array<Colour, 17> cool_warm_table{
    {bytes(59, 76, 192), bytes(78, 104, 215), bytes(98, 130, 234), bytes(119, 154, 247),
     bytes(141, 176, 254), bytes(163, 194, 255), bytes(184, 208, 249), bytes(204, 217, 238),
     bytes(221, 221, 221), bytes(236, 211, 198), bytes(245, 196, 173), bytes(247, 177, 148),
     bytes(244, 154, 123), bytes(236, 127, 99), bytes(222, 97, 76), bytes(203, 62, 56),
     bytes(180, 4, 38)}};

std::span<const Colour> table_of(ColourMap map) {
  switch (map) {
    case ColourMap::lajolla:
      return lajolla_table;
    case ColourMap::viridis:
      return viridis_table;
    case ColourMap::cool_warm:
      break;
  }
  return cool_warm_table;
}

float mix(float a, float b, float t) {
  return a + (b - a) * t;
}

// IEC 61966-2-1.
float decode(float s) {
  return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
}
float encode(float l) {
  l = std::clamp(l, 0.0F, 1.0F);
  return l <= 0.0031308F ? 12.92F * l : 1.055F * std::pow(l, 1.0F / 2.4F) - 0.055F;
}

}  // namespace

std::array<float, 3> to_light(const Colour& colour) {
  return {decode(colour.r), decode(colour.g), decode(colour.b)};
}

Colour from_light(const std::array<float, 3>& light) {
  return {encode(light[0]), encode(light[1]), encode(light[2])};
}

Colour colour_at(ColourMap map, double t) {
  const std::span<const Colour> table = table_of(map);
  const double place = (t > 0.0 ? std::min(t, 1.0) : 0.0) * static_cast<double>(table.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(below));
  const Colour& a = table[below];
  const Colour& b = table[below + 1];
  return {mix(a.r, b.r, part), mix(a.g, b.g, part), mix(a.b, b.b, part)};
}

Colour ColourScale::colour_of(double value) const {
  return colour_at(map, (value - minimum) / (maximum - minimum));
}

std::vector<double> ColourScale::ticks() const {
  const double rough = (maximum - minimum) / 8.0;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * decade;
  for (const double factor : {5.0, 2.5, 2.0, 1.0}) {
    if (factor * decade >= rough * (1.0 - 1e-9)) step = factor * decade;
  }
  std::vector<double> list;
  const auto first = static_cast<long>(std::ceil(minimum / step - 1e-9));
  const auto last = static_cast<long>(std::floor(maximum / step + 1e-9));
  for (long i = first; i <= last; ++i)
    list.push_back(static_cast<double>(i) * step);
  return list;
}

double round_up(double value) {
  if (!(value > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (factor * decade >= value * (1.0 - 1e-9)) return factor * decade;
  }
  return 10.0 * decade;
}

}  // namespace facies::results
