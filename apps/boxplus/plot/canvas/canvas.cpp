// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/canvas.h"

#include <fmt/format.h>

namespace boxplus::app {

std::string hex(Rgb color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
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
