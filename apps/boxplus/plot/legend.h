// SPDX-License-Identifier: BSD-3-Clause
// Explains the colors, in one strip below all panels.
#pragma once

#include <vector>

#include "plot/colors.h"
#include "plot/layout.h"

namespace boxplus::app {

/// Lists only the kinds of things that the scenes contain.
void draw_legend(const std::vector<Scene>& scenes, const ErrorColors& colors, const Layout& layout,
                 Canvas& canvas);

}  // namespace boxplus::app
