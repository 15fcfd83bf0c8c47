// SPDX-License-Identifier: BSD-3-Clause
// Draws one scene in its panel.
#pragma once

#include "plot/axes.h"
#include "plot/colors.h"
#include "plot/layout.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Returns the pixels per meter at which the scene fills a box.
double fitting_scale(const Scene& scene, const Box& box);
/// Returns true if the scene shows things at more than one position.
bool has_extent(const Scene& scene);

/// Draws the card behind a panel, with its title and a line of facts.
void draw_card_with_header(const std::string& title, const std::string& facts, const Box& frame,
                           const Layout& layout, Canvas& canvas);

struct PanelStyle {
  const PictureOptions& options;
  const Layout& layout;
  const ErrorColors& colors;
  const View& view;
};
/// Draws the scene with `scale` pixels per meter. Also draws the frame, the header, the axes and the scale
/// bar, if the options ask for them.
void draw_panel(const Scene& scene, const PanelLayout& place, double scale, const PanelStyle& style,
                Canvas& canvas);

}  // namespace boxplus::app
