// SPDX-License-Identifier: BSD-3-Clause
// Scenes side by side, as one file.
#pragma once

#include <string>
#include <vector>

#include "plot/layout.h"
#include "plot/scene.h"

namespace boxplus::app {

enum class PictureFormat : std::uint8_t { kSvg, kPdf, kPng };

/// Draws one panel per scene, with title, chi2 and a scale bar. All panels have one scale, unless that would
/// make one of them tiny. The legend with the common color scale is below. The file has at most a few
/// megabytes. PNG files have `resolution` pixels per pixel of the picture; throws InvalidArgument if that
/// makes more than 50 million.
std::string draw_picture(std::vector<Scene> scenes, const View& view, const PictureOptions& options,
                         PictureFormat format, double resolution);

}  // namespace boxplus::app
