// SPDX-License-Identifier: Apache-2.0
// Pictures put together on a page: panels in rows with captions, a scale bar, a colour bar, marked points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facies/results/callouts.hpp"
#include "facies/results/render.hpp"

namespace facies::results {

/// A line on a panel.
struct Stroke {
  std::vector<Eigen::Vector2d> points;  ///< column and row in pixels of the panel's image
  Colour colour;
  double width = 1.0;  ///< [pixels]
};

struct Panel {
  Image image;
  std::string caption;
  std::vector<Dot> dots;
  double mm_per_pixel = 0.0;  ///< a scale bar is drawn below the panel where it is positive
  std::vector<Stroke> strokes = {};
  std::vector<Dot> callouts = {};  ///< named beside the image, each tied to its point by a line
};

struct ColourBar {
  ColourScale scale;
  std::string label;  ///< with its unit: "displacement [mm]"
};

/// What a colour means; without one, text alone.
struct LegendEntry {
  std::optional<Colour> colour;
  std::string label;
};

struct Figure {
  std::string title, subtitle;
  std::vector<std::vector<Panel>> rows;
  double mm_per_pixel = 0.0;     ///< of every panel; one scale bar is drawn where it is positive
  std::optional<ColourBar> bar;  ///< stands beside the last row
  std::vector<LegendEntry> legend =
      {};  ///< below the rows: in one line, or in columns where that is too short
};

/// The figure as a PNG file. Throws std::runtime_error where cairo fails.
[[nodiscard]] std::string to_png(const Figure& figure);

/// Pixels of a PNG file. Throws DataError with `where` for anything else.
[[nodiscard]] Image read_png(const std::string& png, const std::string& where);

}  // namespace facies::results
