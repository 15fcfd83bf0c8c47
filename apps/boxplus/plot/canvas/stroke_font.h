// SPDX-License-Identifier: BSD-3-Clause
// A font made of lines. Its letters are drawn like any other path, so that PNG pictures need no font file.
#pragma once

#include <string_view>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

/// Text as lines, and the width of the pen that draws them. The font contains ASCII and a few more
/// characters. All other characters become boxes.
struct StrokedText {
  Path path;
  double pen = 1;
};
StrokedText stroked_text(Point point, const TextStyle& style, std::string_view words);

}  // namespace boxplus::app
