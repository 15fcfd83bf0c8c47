// SPDX-License-Identifier: BSD-3-Clause
// Scenes as an SVG picture.
#pragma once

#include <string>
#include <vector>

#include "plot/scene.h"

namespace boxplus::app {

/// One panel per scene, side by side, each with title, chi2 and a scale bar; one scale for all, unless that
/// would make one of them tiny. Below, the legend with the one scale of colours. At most a few megabytes.
std::string svg_of(std::vector<Scene> scenes);

}  // namespace boxplus::app
