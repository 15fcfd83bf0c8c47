// SPDX-License-Identifier: BSD-3-Clause
// What the colors mean, in one strip below all panels.
#pragma once

#include <vector>

#include "plot/colors.h"
#include "plot/layout.h"

namespace boxplus::app {

/// Names only what the scenes have.
void draw_legend(const std::vector<Scene>& scenes, const ErrorColors& colors, const Layout& layout,
                 Canvas& canvas);

}  // namespace boxplus::app
