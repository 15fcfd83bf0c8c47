// SPDX-License-Identifier: BSD-3-Clause
// What the colours mean, in one strip below all panels.
#pragma once

#include <vector>

#include "plot/colours.h"
#include "plot/svg_writer.h"

namespace boxplus::app {

/// Names only what the scenes have. `width` is that of the picture.
void draw_legend(const std::vector<Scene>& scenes, const ErrorColours& colours, double width, SvgWriter& svg);

}  // namespace boxplus::app
