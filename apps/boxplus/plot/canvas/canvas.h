// SPDX-License-Identifier: BSD-3-Clause
// The drawing surface for pictures in each file format. It draws lines, boxes and text. Coordinates are in
// pixels (in PDF, points); x points to the right and y points down.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxplus::app {

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};
/// Returns the color as "#rrggbb".
std::string hex(Rgb color);

/// Returns the text as XML and Cairo accept it: without control characters, and with U+FFFD instead of bytes
/// that are not valid UTF-8.
std::string printable(std::string_view text);

struct Point {
  double x = 0, y = 0;
  bool operator==(const Point&) const = default;
};

struct Box {
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct Stroke {
  Rgb color;
  double width = 1, opacity = 1;
};

/// A set of polylines. A polyline with a single point is drawn as a round dot.
class Path {
 public:
  void move_to(Point point) {
    starts_.push_back(points_.size());
    points_.push_back(point);
  }
  void line_to(Point point) { points_.push_back(point); }
  bool empty() const { return points_.empty(); }

  /// Calls f(points) for each polyline.
  template <class F>
  void for_each_line(F&& f) const {
    for (std::size_t k = 0; k < starts_.size(); ++k) {
      const std::size_t end = k + 1 < starts_.size() ? starts_[k + 1] : points_.size();
      f(std::span<const Point>(points_).subspan(starts_[k], end - starts_[k]));
    }
  }

 private:
  std::vector<Point> points_;
  std::vector<std::size_t> starts_;
};

enum class Anchor { kStart, kMiddle, kEnd };

inline constexpr Rgb kInk{0x1f, 0x29, 0x37}, kFaintInk{0x6b, 0x72, 0x80};

struct TextStyle {
  double size = 15;
  Rgb color = kFaintInk;
  Anchor anchor = Anchor::kStart;
  bool is_bold = false;
};

class Canvas {
 public:
  virtual ~Canvas() = default;
  /// Draws a path with round ends and joins. The color does not become darker at points at which the path
  /// crosses itself.
  virtual void stroke(const Path& path, const Stroke& stroke) = 0;
  /// Draws a filled rectangle with round corners.
  virtual void fill(const Box& box, double radius, Rgb color) = 0;
  /// Draws one line of UTF-8 text. The anchor of the style says whether the point is the start, the middle or
  /// the end of the baseline.
  virtual void text(Point point, const TextStyle& style, std::string_view words) = 0;
  /// Returns the bytes of the file. Nothing can be drawn afterwards.
  virtual std::string finish() = 0;

  void line(Point from, Point to, const Stroke& stroke);
  void dot(Point at, double diameter, Rgb color);
};

/// `title` is the name of the picture for programs that show the file. It is not drawn.
std::unique_ptr<Canvas> make_svg_canvas(double width, double height, std::string_view title);
std::unique_ptr<Canvas> make_pdf_canvas(double width, double height, std::string_view title);
/// Makes a PNG canvas with a white background. The file has `resolution` pixels per pixel of the picture.
std::unique_ptr<Canvas> make_png_canvas(double width, double height, double resolution);

}  // namespace boxplus::app
