// SPDX-License-Identifier: Apache-2.0
#include "facies/results/figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <cairo.h>
#include <fmt/format.h>

#include "facies/base/error.hpp"

namespace facies::results {

namespace {

constexpr double margin = 28.0;
constexpr double gap = 14.0;
constexpr double title_size = 26.0;
constexpr double text_size = 17.0;
constexpr double label_size = 12.0;
constexpr double line = 1.5;     ///< line height by text size
constexpr double swatch = 18.0;  ///< side of a colour in a legend
constexpr double bar_width = 24.0;
constexpr double bar_column = 210.0;  ///< width of the page that a colour bar takes

struct ReleaseSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ReleasePen {
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};
using Canvas = std::unique_ptr<cairo_surface_t, ReleaseSurface>;
using Pen = std::unique_ptr<cairo_t, ReleasePen>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(
        fmt::format("cannot draw a figure: {}", cairo_status_to_string(status)));
  }
}

Canvas make_canvas(int width, int height) {
  Canvas canvas(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  check(cairo_surface_status(canvas.get()));
  return canvas;
}

Canvas to_canvas(const Image& image) {
  Canvas canvas = make_canvas(image.width, image.height);
  unsigned char* rows = cairo_image_surface_get_data(canvas.get());
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(canvas.get());
  const std::uint8_t* in = image.rgb.data();
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column, in += 3) {
      const std::uint32_t pixel = std::uint32_t{in[0]} << 16U | std::uint32_t{in[1]} << 8U | in[2];
      std::memcpy(rows + row * stride + std::ptrdiff_t{4} * column, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(canvas.get());
  return canvas;
}

/// Shapes of letters must not depend on the pixel grid: no hinting.
void choose_font(cairo_t* pen) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
}

enum class Align { left, middle, right };

struct TextStyle {
  double size = text_size;
  double grey = 0.15;
  bool bold = false;
  bool halo = false;  ///< white around the letters, to be read on anything
};

const TextStyle title_style{title_size, 0.1, true, false};
const TextStyle small_print{text_size, 0.35, false, false};

/// Writes on the baseline y.
void write(cairo_t* pen, double x, double y, const std::string& text, Align align,
           const TextStyle& style) {
  cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen, style.size);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, text.c_str(), &extents);
  const double shift = align == Align::left ? 0.0 : align == Align::middle ? 0.5 : 1.0;
  cairo_move_to(pen, x - shift * extents.x_advance, y);
  if (style.halo) {
    cairo_text_path(pen, text.c_str());
    cairo_set_source_rgb(pen, 1.0, 1.0, 1.0);
    cairo_set_line_width(pen, 3.0);
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(pen);
    cairo_move_to(pen, x - shift * extents.x_advance, y);
  }
  cairo_set_source_rgb(pen, style.grey, style.grey, style.grey);
  cairo_show_text(pen, text.c_str());
}

/// How wide text comes out.
double text_width(const std::string& text, const TextStyle& style) {
  const Canvas canvas = make_canvas(1, 1);
  const Pen pen(cairo_create(canvas.get()));
  choose_font(pen.get());
  write(pen.get(), 0.0, 0.0, text, Align::left, style);
  double end = 0.0;
  cairo_get_current_point(pen.get(), &end, nullptr);
  return end;
}

/// Names of callouts, how far they stand from the image, and the room that one takes.
const TextStyle callout_style{14.0, 0.1, true, false};
constexpr double callout_distance = 8.0;
constexpr double callout_spacing = 17.0;

std::vector<CalloutPlace> callouts_of(const Panel& panel) {
  return place_callouts(panel.callouts, panel.image.width, panel.image.height, callout_spacing);
}

/// What a panel takes of a row: its image, with names of callouts to either side.
struct Extent {
  double left = 0.0, right = 0.0;  ///< of the image
  double width = 0.0;              ///< of everything
};

Extent extent_of(const Panel& panel) {
  Extent extent;
  for (const CalloutPlace& place : callouts_of(panel)) {
    double& side = place.is_left ? extent.left : extent.right;
    side = std::max(side, std::ceil(callout_distance +
                                    text_width(panel.callouts[place.dot].label, callout_style)));
  }
  extent.width = extent.left + panel.image.width + extent.right;
  return extent;
}

void set_colour(cairo_t* pen, const Colour& colour) {
  cairo_set_source_rgb(pen, double{colour.r}, double{colour.g}, double{colour.b});
}

void draw_strokes(cairo_t* pen, double x, double y, const std::vector<Stroke>& strokes) {
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
  for (const Stroke& stroke : strokes) {
    cairo_new_path(pen);  // text leaves a point behind
    for (const Eigen::Vector2d& point : stroke.points)
      cairo_line_to(pen, x + point.x(), y + point.y());
    set_colour(pen, stroke.colour);
    cairo_set_line_width(pen, stroke.width);
    cairo_stroke(pen);
  }
}

void draw_callouts(cairo_t* pen, double x, double y, const Panel& panel) {
  for (const CalloutPlace& place : callouts_of(panel)) {
    const Dot& dot = panel.callouts[place.dot];
    const double edge =
        place.is_left ? x - callout_distance / 2.0 : x + panel.image.width + callout_distance / 2.0;
    for (const auto& [grey, width] : {std::pair{1.0, 2.6}, std::pair{0.15, 0.9}}) {
      cairo_move_to(pen, edge, y + place.row);
      cairo_line_to(pen, x + dot.column, y + dot.row);
      cairo_set_source_rgba(pen, grey, grey, grey, grey < 0.5 ? 1.0 : 0.6);
      cairo_set_line_width(pen, width);
      cairo_stroke(pen);
    }
    cairo_new_path(pen);
    cairo_arc(pen, x + dot.column, y + dot.row, 2.6, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(pen);
    write(pen, place.is_left ? edge - 0.5 * callout_distance : edge + 0.5 * callout_distance,
          y + place.row + 0.35 * callout_style.size, dot.label,
          place.is_left ? Align::right : Align::left, callout_style);
  }
}

void draw_dots(cairo_t* pen, double x, double y, const std::vector<Dot>& dots) {
  for (const Dot& dot : dots) {
    cairo_new_sub_path(pen);
    cairo_arc(pen, x + dot.column, y + dot.row, 4.0, 0.0, 2.0 * std::numbers::pi);
    cairo_set_source_rgb(pen, 0.70, 0.10, 0.12);
    cairo_fill_preserve(pen);
    cairo_set_source_rgb(pen, 1.0, 1.0, 1.0);
    cairo_set_line_width(pen, 1.2);
    cairo_stroke(pen);
  }
  for (const Dot& dot : dots) {
    write(pen, x + dot.column + 6.0, y + dot.row - 5.0, dot.label, Align::left,
          {label_size, 0.0, true, true});
  }
}

/// The longest of 1, 2, 5, 10, 20, 50 ... mm that takes at most `longest` pixels; it ends at `right`.
void draw_scale_bar(cairo_t* pen, double right, double y, double longest, double mm_per_pixel) {
  const double available = longest * mm_per_pixel;
  const double decade = std::pow(10.0, std::floor(std::log10(available)));
  const double length = available >= 5.0 * decade   ? 5.0 * decade
                        : available >= 2.0 * decade ? 2.0 * decade
                                                    : decade;
  const double pixels = length / mm_per_pixel;
  cairo_set_source_rgb(pen, 0.15, 0.15, 0.15);
  cairo_rectangle(pen, right - pixels, y - 4.0, pixels, 4.0);
  cairo_fill(pen);
  write(pen, right - 0.5 * pixels, y - 11.0, fmt::format("{:g} mm", length), Align::middle, {14.0});
}

void draw_panel(cairo_t* pen, double x, double y, const Panel& panel) {
  const Canvas picture = to_canvas(panel.image);
  cairo_set_source_surface(pen, picture.get(), x, y);
  cairo_paint(pen);
  draw_strokes(pen, x, y, panel.strokes);
  draw_callouts(pen, x, y, panel);
  draw_dots(pen, x, y, panel.dots);
  write(pen, x + 0.5 * panel.image.width, y + panel.image.height + text_size, panel.caption,
        Align::middle, {});
  if (panel.mm_per_pixel > 0.0)
    draw_scale_bar(pen, x + panel.image.width, y + panel.image.height + line * text_size, 120.0,
                   panel.mm_per_pixel);
}

void draw_colour_bar(cairo_t* pen, double x, double y, double height, const ColourBar& bar) {
  write(pen, x, y - 16.0, bar.label, Align::left, {});
  const int rows = static_cast<int>(height);  // whole pixels, so that no row is mixed with the page
  for (int row = 0; row < rows; ++row) {
    const Colour colour = colour_at(bar.scale.map, 1.0 - (row + 0.5) / rows);
    cairo_set_source_rgb(pen, double{colour.r}, double{colour.g}, double{colour.b});
    cairo_rectangle(pen, x, y + row, bar_width, 1.0);
    cairo_fill(pen);
  }
  cairo_set_line_width(pen, 1.0);
  for (const double tick : bar.scale.ticks()) {
    const double place =
        y + rows * (1.0 - (tick - bar.scale.minimum) / (bar.scale.maximum - bar.scale.minimum));
    cairo_set_source_rgb(pen, 0.15, 0.15, 0.15);
    cairo_move_to(pen, x + bar_width, place);
    cairo_line_to(pen, x + bar_width + 6.0, place);
    cairo_stroke(pen);
    write(pen, x + bar_width + 11.0, place + 5.5, fmt::format("{:.6g}", tick), Align::left, {15.0});
  }
}

/// Where the entries of a legend stand: columns of one width, or one line of whatever they take.
struct LegendLayout {
  std::vector<double> columns;  ///< where each begins; in one line one for each entry
  std::size_t n_rows = 0;
};

double entry_width(const LegendEntry& entry) {
  return (entry.colour ? swatch + 8.0 : 0.0) + text_width(entry.label, {});
}

LegendLayout lay_out(const std::vector<LegendEntry>& legend, double width) {
  LegendLayout layout{{}, legend.empty() ? 0U : 1U};
  double end = 0.0;
  double widest = 0.0;
  for (const LegendEntry& entry : legend) {
    layout.columns.push_back(std::round(end));
    end += entry_width(entry) + 2.0 * gap;
    widest = std::max(widest, entry_width(entry) + 2.0 * gap);
  }
  if (end - 2.0 * gap <= width) return layout;
  const double fitting = std::max(1.0, std::floor((width + 2.0 * gap) / widest));
  layout.n_rows = static_cast<std::size_t>(std::ceil(static_cast<double>(legend.size()) / fitting));
  const std::size_t n_columns = (legend.size() + layout.n_rows - 1) / layout.n_rows;
  layout.columns.clear();
  for (std::size_t c = 0; c < n_columns; ++c)
    layout.columns.push_back(std::round(static_cast<double>(c) * widest));
  return layout;
}

/// Column by column, each from the top.
void draw_legend(cairo_t* pen, double x, double y, const std::vector<LegendEntry>& legend,
                 const LegendLayout& layout) {
  for (std::size_t i = 0; i < legend.size(); ++i) {
    double left = x + layout.columns[i / layout.n_rows];
    const double top = y + std::round(line * swatch) * static_cast<double>(i % layout.n_rows);
    if (legend[i].colour) {
      cairo_rectangle(pen, left, top, swatch, swatch);
      set_colour(pen, *legend[i].colour);
      cairo_fill(pen);
      left += swatch + 8.0;
    }
    write(pen, left, top + 0.8 * swatch, legend[i].label, Align::left, {});
  }
}

double row_height(const std::vector<Panel>& row) {
  int height = 0;
  for (const Panel& panel : row)
    height = std::max(height, panel.image.height);
  return std::round(height + line * text_size + gap);  // panels stand on whole pixels
}

double row_width(const std::vector<Panel>& row) {
  double width = -gap;
  for (const Panel& panel : row)
    width += extent_of(panel).width + gap;
  return width;
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int n) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), n);
  return CAIRO_STATUS_SUCCESS;
}

struct Reader {
  const std::string* png = nullptr;
  std::size_t place = 0;
};

cairo_status_t take(void* reader, unsigned char* bytes, unsigned int n) {
  auto* from = static_cast<Reader*>(reader);
  if (from->png->size() - from->place < n) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(bytes, from->png->data() + from->place, n);
  from->place += n;
  return CAIRO_STATUS_SUCCESS;
}

/// What stands above and below the rows: title, small print, and at least one entry of the legend.
double head_and_foot_width(const Figure& figure) {
  double width =
      std::max(text_width(figure.title, title_style), text_width(figure.subtitle, small_print));
  for (const LegendEntry& entry : figure.legend)
    width = std::max(width, entry_width(entry));
  return width;
}

}  // namespace

std::string to_png(const Figure& figure) {
  double width = 0.0;
  double height = 0.0;
  for (const auto& row : figure.rows) {
    width = std::max(width, row_width(row));
    height += row_height(row);
  }
  width = std::max(width, std::ceil(head_and_foot_width(figure)));
  const double head = std::round(line * (title_size + text_size) + gap);
  const LegendLayout legend = lay_out(figure.legend, width);
  const double foot = figure.legend.empty()
                          ? 0.0
                          : std::round(line * swatch) * static_cast<double>(legend.n_rows) + gap;
  const double page_width = 2.0 * margin + width + (figure.bar ? bar_column : 0.0);
  const Canvas page = make_canvas(static_cast<int>(page_width),
                                  static_cast<int>(2.0 * margin + head + height + foot));
  const Pen pen(cairo_create(page.get()));
  choose_font(pen.get());
  cairo_set_source_rgb(pen.get(), 1.0, 1.0, 1.0);
  cairo_paint(pen.get());
  write(pen.get(), margin, margin + title_size, figure.title, Align::left, title_style);
  write(pen.get(), margin, margin + line * title_size + text_size, figure.subtitle, Align::left,
        small_print);

  double y = margin + head;
  for (const auto& row : figure.rows) {
    double x = margin;
    for (const Panel& panel : row) {
      const Extent extent = extent_of(panel);
      draw_panel(pen.get(), x + extent.left, y, panel);
      x += extent.width + gap;
    }
    y += row_height(row);
  }
  if (figure.mm_per_pixel > 0.0)
    draw_scale_bar(pen.get(), margin + width, y - gap, 240.0, figure.mm_per_pixel);
  if (figure.bar && !figure.rows.empty()) {
    const double last = row_height(figure.rows.back());
    draw_colour_bar(pen.get(), margin + width + 2.0 * gap, std::round(y - 0.9 * last), 0.7 * last,
                    *figure.bar);
  }
  draw_legend(pen.get(), margin, y + gap, figure.legend, legend);
  check(cairo_status(pen.get()));
  std::string png;
  check(cairo_surface_write_to_png_stream(page.get(), append, &png));
  return png;
}

Image read_png(const std::string& png, const std::string& where) {
  Reader reader{&png, 0};
  const Canvas canvas(cairo_image_surface_create_from_png_stream(take, &reader));
  if (cairo_surface_status(canvas.get()) != CAIRO_STATUS_SUCCESS)
    throw DataError({{where, "is not a PNG file", "", ""}});
  const unsigned char* rows = cairo_image_surface_get_data(canvas.get());
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(canvas.get());
  Image image{cairo_image_surface_get_width(canvas.get()),
              cairo_image_surface_get_height(canvas.get()),
              {}};
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, rows + row * stride + std::ptrdiff_t{4} * column, sizeof pixel);
      for (const unsigned shift : {16U, 8U, 0U})
        image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 0xFFU));
    }
  }
  return image;
}

}  // namespace facies::results
