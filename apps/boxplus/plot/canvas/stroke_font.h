// SPDX-License-Identifier: BSD-3-Clause
// A font made of lines, so that pictures in pixels need no font file: letters are stroked like any path.
#pragma once

#include <string_view>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

/// The lines of `words`, and the width of the pen that draws them. The font has ASCII and a few more
/// characters; any other character becomes a box.
struct StrokedText {
  Path path;
  double pen = 1;
};
StrokedText stroked_text(Point point, const TextStyle& style, std::string_view words);

}  // namespace boxplus::app
