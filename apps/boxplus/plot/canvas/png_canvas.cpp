// SPDX-License-Identifier: BSD-3-Clause
// Draws pictures in pixels. The part of a pixel that a line covers is computed from the distance between the
// line and the center of the pixel, as with a box filter that is one pixel wide. The coverages of all lines
// of a path are combined before the path is blended with the picture.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plot/canvas/canvas.h"
#include "plot/canvas/deflate.h"
#include "plot/canvas/stroke_font.h"

namespace boxplus::app {
namespace {

class PngCanvas final : public Canvas {
 public:
  PngCanvas(double width, double height, double resolution)
      : resolution_(resolution),
        columns_(pixels(width)),
        rows_(pixels(height)),
        colors_(size(), Rgb{255, 255, 255}),
        coverage_(size(), 0) {}

  void stroke(const Path& path, const Stroke& stroke) override {
    path.for_each_line([&](std::span<const Point> points) {
      if (points.size() == 1) cover(points[0], points[0], stroke.width);
      for (std::size_t i = 1; i < points.size(); ++i) cover(points[i - 1], points[i], stroke.width);
    });
    for (const std::size_t index : touched_) {
      blend(index, stroke.color, stroke.opacity * coverage_[index]);
      coverage_[index] = 0;
    }
    touched_.clear();
  }

  void fill(const Box& box, double radius, Rgb color) override {
    const double half_width = box.width / 2 * resolution_, half_height = box.height / 2 * resolution_,
                 r = radius * resolution_, x = (box.left + box.width / 2) * resolution_,
                 y = (box.top + box.height / 2) * resolution_;
    for (int row = first(y - half_height); row < last(y + half_height, rows_); ++row) {
      for (int column = first(x - half_width); column < last(x + half_width, columns_); ++column) {
        const double dx = std::abs(column + 0.5 - x) - half_width + r,
                     dy = std::abs(row + 0.5 - y) - half_height + r;
        const double distance =
            std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0) - r;
        blend(index(row, column), color, std::clamp(0.5 - distance, 0.0, 1.0));
      }
    }
  }

  void text(Point point, const TextStyle& style, std::string_view words) override {
    const StrokedText text = stroked_text(point, style, words);
    stroke(text.path, {style.color, text.pen});
  }

  std::string finish() override {
    std::string file = "\x89PNG\r\n\x1a\n";
    constexpr char kTrueColor[] = {8, 2, 0, 0, 0};  // 8 bits, RGB, deflate, usual filters, no interlacing
    chunk(file, "IHDR", number(columns_) + number(rows_) + std::string(kTrueColor, sizeof kTrueColor));
    chunk(file, "IDAT", zlib_compressed(image()));
    chunk(file, "IEND", "");
    return file;
  }

 private:
  int pixels(double length) const { return std::max(1, static_cast<int>(std::lround(length * resolution_))); }
  std::size_t size() const { return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_); }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  static int first(double at) { return static_cast<int>(std::clamp(std::floor(at - 1), 0.0, 1e9)); }
  static int last(double at, int end) {
    return static_cast<int>(std::clamp(std::ceil(at + 1), 0.0, double(end)));
  }

  /// Adds the coverage of a line between two points, whose coordinates are in pixels of the picture.
  void cover(Point from, Point to, double width) {
    const Point a{from.x * resolution_, from.y * resolution_}, b{to.x * resolution_, to.y * resolution_};
    const double half = width * resolution_ / 2, reach = half + 0.5,
                 length = std::hypot(b.x - a.x, b.y - a.y);
    const Point along = length > 0 ? Point{(b.x - a.x) / length, (b.y - a.y) / length} : Point{1, 0};
    for (int row = first(std::min(a.y, b.y) - reach); row < last(std::max(a.y, b.y) + reach, rows_); ++row) {
      const double y = row + 0.5 - a.y;
      double low = std::min(a.x, b.x) - reach, high = std::max(a.x, b.x) + reach;
      if (std::abs(along.y) > 1e-6) {  // only the part of the row that is inside the strip around the line
        const double middle = a.x + y * along.x / along.y, half_crossing = reach / std::abs(along.y);
        low = std::max(low, middle - half_crossing);
        high = std::min(high, middle + half_crossing);
      }
      for (int column = first(low); column < last(high, columns_); ++column) {
        const double x = column + 0.5 - a.x, t = std::clamp(x * along.x + y * along.y, 0.0, length);
        const double distance = std::hypot(x - t * along.x, y - t * along.y);
        mark(index(row, column), std::clamp(reach - distance, 0.0, std::min(1.0, 2 * half)));
      }
    }
  }

  void mark(std::size_t at, double coverage) {
    if (coverage <= coverage_[at]) return;
    if (coverage_[at] == 0) touched_.push_back(at);
    coverage_[at] = static_cast<float>(coverage);
  }

  void blend(std::size_t at, Rgb color, double part) {
    const auto mix = [part](std::uint8_t& below, std::uint8_t above) {
      below = static_cast<std::uint8_t>(std::lround(below + part * (above - below)));
    };
    mix(colors_[at].red, color.red);
    mix(colors_[at].green, color.green);
    mix(colors_[at].blue, color.blue);
  }

  /// Returns the bytes of the image. Each row begins with the type of its filter, which is 0 (none).
  std::string image() const {
    std::string bytes;
    bytes.reserve(size() * 3 + static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row) {
      bytes.push_back(0);
      for (int column = 0; column < columns_; ++column) {
        const Rgb& color = colors_[index(row, column)];
        for (const std::uint8_t value : {color.red, color.green, color.blue})
          bytes.push_back(static_cast<char>(value));
      }
    }
    return bytes;
  }

  static std::string number(std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
    return bytes;
  }
  static std::string number(int value) { return number(static_cast<std::size_t>(value)); }

  static void chunk(std::string& file, std::string_view type, const std::string& data) {
    const std::string body = std::string(type) + data;
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    file += number(data.size()) + body + number(std::size_t{checksum});
  }

  double resolution_;
  int columns_, rows_;
  std::vector<Rgb> colors_;
  std::vector<float> coverage_;  ///< the coverage of each pixel by the path that is being drawn
  std::vector<std::size_t> touched_;
};

}  // namespace

std::unique_ptr<Canvas> make_png_canvas(double width, double height, double resolution) {
  return std::make_unique<PngCanvas>(width, height, resolution);
}

}  // namespace boxplus::app
