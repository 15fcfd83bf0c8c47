// SPDX-License-Identifier: BSD-3-Clause
// The layout of a picture: the positions of its parts.
#pragma once

#include <cstddef>
#include <string>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

struct PictureOptions {
  std::string title;             ///< the title; empty if there is none
  double width = 0, height = 0;  ///< the size of the picture; by default (0), 620 wide per panel and 666 high
  double font_size = 0;   ///< the size of most text; by default (0), proportional to the size of the panels
  bool is_bare = false;   ///< draws only the graphs: no frame, header, scale bar, legend or background
  bool has_axes = false;  ///< draws ticks with their values, or arrows if the view is not along an axis
  bool has_one_scale = false;  ///< uses one scale for all panels, even if that makes one of the graphs tiny
};

/// One panel of a picture.
struct PanelLayout {
  Box frame;  ///< the card behind the panel
  Box plot;   ///< the area for the graph, inside of the axes
  Box fit;    ///< the area inside of `plot` that the graph must fit into
};

class Layout {
 public:
  /// If `has_ticks` is true, the layout has space for the values at the axes.
  Layout(const PictureOptions& options, std::size_t panels, bool has_ticks);

  double width() const { return width_; }
  double height() const { return height_; }
  /// The factor for line widths and margins; 1 in a panel of the default size.
  double unit() const { return unit_; }
  /// The factor for text sizes.
  double text() const { return text_; }
  /// The height of the strip for the title above all panels; 0 if there is no title.
  double title_height() const { return title_height_; }
  double legend_top() const { return height_ - legend_height_; }
  PanelLayout panel(std::size_t index) const;

 private:
  bool is_bare_, has_ticks_;
  double width_, height_, panel_width_, unit_, text_, title_height_ = 0, legend_height_ = 0;
};

}  // namespace boxplus::app
