// SPDX-License-Identifier: BSD-3-Clause
// Scenes as an SVG picture.
#pragma once

#include <span>
#include <string>

#include "scene.h"

namespace boxplus::app {

/// One panel per scene, side by side, each with title, chi2 and a scale bar; one scale for all, unless that
/// would make one of them tiny.
std::string svg_of(std::span<const Scene> scenes);

}  // namespace boxplus::app
