// SPDX-License-Identifier: BSD-3-Clause
// Draws scenes side by side in one picture file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plot/layout.h"
#include "plot/scene.h"

namespace boxplus::app {

enum class PictureFormat : std::uint8_t { kSvg, kPdf, kPng };

/// Makes a canvas with the background and, if the layout has space for it, the title. Throws InvalidArgument
/// if a PNG file would have more than 50 million pixels, or more than 32767 in a row or column.
std::unique_ptr<Canvas> begin_picture(const Layout& layout, const PictureOptions& options,
                                      PictureFormat format, double resolution);

/// Draws one panel per scene, with title, chi2 and a scale bar. All panels have one scale, unless that would
/// make one of the graphs tiny. The legend is below the panels, and explains the color scale that all panels
/// share. The file has at most a few megabytes. PNG files have `resolution` pixels per pixel of the picture.
/// Throws what begin_picture() throws.
std::string draw_picture(std::vector<Scene> scenes, const View& view, const PictureOptions& options,
                         PictureFormat format, double resolution);

}  // namespace boxplus::app
