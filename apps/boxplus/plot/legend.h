// SPDX-License-Identifier: BSD-3-Clause
// Draws the legend: one strip below all panels that explains the colors.
#pragma once

#include <vector>

#include "plot/colors.h"
#include "plot/layout.h"

namespace boxplus::app {

/// Draws the legend. It explains only the kinds of things that the scenes contain.
void draw_legend(const std::vector<Scene>& scenes, const ErrorColors& colors, const Layout& layout,
                 Canvas& canvas);

}  // namespace boxplus::app
