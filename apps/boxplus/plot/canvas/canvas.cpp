// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/canvas.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/printable.h"

namespace boxplus::app {

std::string hex(Rgb color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = printable_length(text, i);
    if (length > 0) {
      result += text.substr(i, length);
    } else if (static_cast<unsigned char>(text[i]) >= 0x80) {
      result += "\xEF\xBF\xBD";  // U+FFFD
    }
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

void Canvas::line(Point from, Point to, const Stroke& pen) {
  Path path;
  path.move_to(from);
  path.line_to(to);
  stroke(path, pen);
}

void Canvas::dot(Point at, double diameter, Rgb color) {
  Path path;
  path.move_to(at);
  stroke(path, {color, diameter});
}

}  // namespace boxplus::app
