// SPDX-License-Identifier: BSD-3-Clause
// Scenes side by side, as a file.
#pragma once

#include <string>
#include <vector>

#include "plot/layout.h"
#include "plot/scene.h"

namespace boxplus::app {

enum class PictureFormat : std::uint8_t { kSvg, kPdf, kPng };

/// One panel per scene, with title, chi2 and a scale bar; one scale for all, unless that would make one of
/// them tiny. Below, the legend with the one scale of colors. At most a few megabytes. PNG files have
/// `resolution` pixels per pixel of the picture; InvalidArgument is thrown if that makes more than 50
/// million.
std::string draw_picture(std::vector<Scene> scenes, const View& view, const PictureOptions& options,
                         PictureFormat format, double resolution);

}  // namespace boxplus::app
