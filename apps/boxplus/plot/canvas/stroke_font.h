// SPDX-License-Identifier: BSD-3-Clause
// A font of lines, so that pictures in pixels need no font file: what it draws is stroked like any path.
#pragma once

#include <string_view>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

/// The lines of `words`, and the width of the pen to draw them with. ASCII and a few signs more; a box stands
/// for any other letter.
struct StrokedText {
  Path path;
  double pen = 1;
};
StrokedText stroked_text(Point point, const TextStyle& style, std::string_view words);

}  // namespace boxplus::app
