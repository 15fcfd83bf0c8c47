// SPDX-License-Identifier: BSD-3-Clause
// Draws pictures for PDF and PNG files with Cairo. If Liberation Sans is not installed, fontconfig selects
// another font; on a machine without fonts, Cairo draws the letters of ASCII itself, and others as boxes.
#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <optional>

#include "boxplus/base/error.h"
#include "plot/canvas/canvas.h"

namespace boxplus::app {
namespace {

/// Its letters have the widths of Helvetica, which the layout of legends expects.
constexpr const char* kFont = "Liberation Sans";

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("Cairo cannot draw the picture: {}", cairo_status_to_string(status)));
}

/// Cairo calls it with the next bytes of a file.
cairo_status_t append(void* file, const unsigned char* bytes, unsigned size) {
  try {
    static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

/// Returns the part of a line that is in the picture or near it, because Cairo cannot draw lines to points
/// that are some 100000 pixels away.
std::optional<std::array<Point, 2>> near_part(Point from, Point to) {
  constexpr double kFarthest = 2e4;  // no picture is larger, and a PNG file has up to 10 pixels per unit
  const auto is_near = [](Point point) {
    return std::max(std::abs(point.x), std::abs(point.y)) <= kFarthest;
  };
  if (is_near(from) && is_near(to)) return {{from, to}};
  double begin = 0, end = 1;
  for (const auto axis : {&Point::x, &Point::y}) {
    const double step = to.*axis - from.*axis, low = (-kFarthest - from.*axis) / step,
                 high = (kFarthest - from.*axis) / step;
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  if (begin > end) return std::nullopt;
  const auto at = [&](double t) { return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}; };
  return {{at(begin), at(end)}};
}

class CairoCanvas : public Canvas {
 public:
  void stroke(const Path& path, const Stroke& stroke) override {
    path.for_each_line([this](std::span<const Point> points) {
      // A single point becomes a line without length, which is a dot, because ends are round.
      add(points.front(), points[points.size() == 1 ? 0 : 1], true);
      for (std::size_t i = 2; i < points.size(); ++i) add(points[i - 1], points[i], false);
    });
    select(stroke.color, stroke.opacity);
    cairo_set_line_width(cairo_.get(), stroke.width);
    cairo_stroke(cairo_.get());
  }

  void fill(const Box& box, double radius, Rgb color) override {
    constexpr double kQuarter = std::numbers::pi / 2;
    const double left = box.left + radius, right = box.right() - radius, top = box.top + radius,
                 bottom = box.bottom() - radius;
    cairo_arc(cairo_.get(), left, top, radius, 2 * kQuarter, 3 * kQuarter);
    cairo_arc(cairo_.get(), right, top, radius, 3 * kQuarter, 4 * kQuarter);
    cairo_arc(cairo_.get(), right, bottom, radius, 0, kQuarter);
    cairo_arc(cairo_.get(), left, bottom, radius, kQuarter, 2 * kQuarter);
    select(color, 1);
    cairo_fill(cairo_.get());
  }

  void text(Point point, const TextStyle& style, std::string_view words) override {
    const std::string shown = printable(words);
    cairo_select_font_face(cairo_.get(), kFont, CAIRO_FONT_SLANT_NORMAL,
                           style.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), style.size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), shown.c_str(), &extents);
    const double part = style.anchor == Anchor::kStart ? 0 : style.anchor == Anchor::kMiddle ? 0.5 : 1;
    cairo_move_to(cairo_.get(), point.x - part * extents.x_advance, point.y);
    select(style.color, 1);
    cairo_show_text(cairo_.get(), shown.c_str());
    cairo_new_path(cairo_.get());  // forgets the end of the text
  }

  std::string finish() override {
    check(cairo_status(cairo_.get()));
    cairo_surface_t* surface = cairo_get_target(cairo_.get());
    if (cairo_surface_get_type(surface) == CAIRO_SURFACE_TYPE_IMAGE)
      check(cairo_surface_write_to_png_stream(surface, append, &file_));
    cairo_surface_finish(surface);
    check(cairo_surface_status(surface));
    return std::move(file_);
  }

 protected:
  /// Draws on `surface` from now on, and takes its reference.
  void begin(cairo_surface_t* surface) {
    cairo_.reset(cairo_create(surface));
    cairo_surface_destroy(surface);
    cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    // Text does not depend on the user's settings for screens.
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), cairo_font_options_destroy);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo_.get(), options.get());
  }

  /// Adds a line to Cairo's path. If it is not the first line, it begins where the last one ended.
  void add(Point from, Point to, bool is_first) {
    const auto part = near_part(from, to);
    if (!part) return;
    const auto [begin, end] = *part;
    if (is_first || begin != from) cairo_move_to(cairo_.get(), begin.x, begin.y);
    cairo_line_to(cairo_.get(), end.x, end.y);
  }

  void select(Rgb color, double opacity) {
    constexpr double kMost = 255;
    cairo_set_source_rgba(cairo_.get(), color.red / kMost, color.green / kMost, color.blue / kMost, opacity);
  }

  std::string file_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_{nullptr, cairo_destroy};
};

class PdfCanvas final : public CairoCanvas {
 public:
  PdfCanvas(double width, double height, std::string_view title) {
    cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &file_, width, height);
    cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, printable(title).c_str());
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "boxplus");
    // Without a date, equal graphs give equal files.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    begin(surface);
  }
};

class PngCanvas final : public CairoCanvas {
 public:
  PngCanvas(double width, double height, double resolution) {
    const auto pixels = [resolution](double length) {
      return std::max(1, static_cast<int>(std::lround(length * resolution)));
    };
    begin(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
    select({255, 255, 255}, 1);
    cairo_paint(cairo_.get());
    cairo_scale(cairo_.get(), resolution, resolution);
  }
};

}  // namespace

std::unique_ptr<Canvas> make_pdf_canvas(double width, double height, std::string_view title) {
  return std::make_unique<PdfCanvas>(width, height, title);
}

std::unique_ptr<Canvas> make_png_canvas(double width, double height, double resolution) {
  return std::make_unique<PngCanvas>(width, height, resolution);
}

}  // namespace boxplus::app
