// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <iterator>

#include "plot/canvas/canvas.h"

namespace boxplus::app {
namespace {

std::string escaped_xml(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

const char* word(Anchor anchor) {
  return anchor == Anchor::kStart ? "start" : anchor == Anchor::kMiddle ? "middle" : "end";
}

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(double width, double height, std::string_view title) {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
        "height=\"{1:g}\" "
        "fill=\"none\" font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\" "
        "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        width, height);
    if (!title.empty()) add("<title>{}</title>\n", escaped_xml(title));
  }

  void stroke(const Path& path, const Stroke& stroke) override {
    if (path.empty()) return;
    add("<path d=\"");
    path.for_each_line([this](std::span<const Point> points) {
      add("M{:.1f} {:.1f}", points[0].x, points[0].y);
      if (points.size() == 1) add("h0");  // with round ends, this is a dot
      for (const Point& point : points.subspan(1)) add("L{:.1f} {:.1f}", point.x, point.y);
    });
    add("\" stroke=\"{}\" stroke-width=\"{:.3g}\"", hex(stroke.color), stroke.width);
    if (stroke.opacity < 1) add(" stroke-opacity=\"{:.2f}\"", stroke.opacity);
    add("/>\n");
  }

  void fill(const Box& box, double radius, Rgb color) override {
    add("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"{:.1f}\" fill=\"{}\"/>\n",
        box.left, box.top, box.width, box.height, radius, hex(color));
  }

  void text(Point point, const TextStyle& style, std::string_view words) override {
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.3g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
        point.x, point.y, style.size, hex(style.color), word(style.anchor),
        style.is_bold ? " font-weight=\"600\"" : "", escaped_xml(words));
  }

  std::string finish() override {
    add("</svg>\n");
    return std::move(text_);
  }

 private:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  std::string text_;
};

}  // namespace

std::unique_ptr<Canvas> make_svg_canvas(double width, double height, std::string_view title) {
  return std::make_unique<SvgCanvas>(width, height, title);
}

}  // namespace boxplus::app
