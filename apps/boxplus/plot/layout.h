// SPDX-License-Identifier: BSD-3-Clause
// The positions of the parts of a picture.
#pragma once

#include <cstddef>
#include <string>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

struct PictureOptions {
  std::string title;             ///< empty: none
  double width = 0, height = 0;  ///< of the picture; 0: 620 wide per panel, 666 high
  double font_size = 0;          ///< of most text; 0: proportional to the panels
  bool is_bare = false;          ///< only the graphs: no frame, header, scale bar, legend or background
  bool has_axes = false;         ///< ticks with their values, or arrows if no axis lies in the picture plane
  bool has_one_scale = false;    ///< one scale for all panels, even if that makes one of them tiny
};

/// One panel of a picture.
struct PanelLayout {
  Box frame;  ///< the card behind it
  Box plot;   ///< the area of the graph, inside the axes
  Box fit;    ///< inside `plot`: the area that the graph must fit into
};

class Layout {
 public:
  /// `has_ticks`: leaves space for the values at the axes.
  Layout(const PictureOptions& options, std::size_t panels, bool has_ticks);

  double width() const { return width_; }
  double height() const { return height_; }
  /// The factor for line widths and margins: 1 in a panel of the usual size.
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
