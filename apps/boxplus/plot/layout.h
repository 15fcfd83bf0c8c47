// SPDX-License-Identifier: BSD-3-Clause
// Where the parts of a picture lie.
#pragma once

#include <cstddef>
#include <string>

#include "plot/canvas/canvas.h"

namespace boxplus::app {

struct PictureOptions {
  std::string title;             ///< empty: none
  double width = 0, height = 0;  ///< of the picture; 0: 620 per panel, and 666
  double font_size = 0;          ///< of most text; 0: in proportion to the panels
  bool is_bare = false;          ///< the graphs alone: no frame, header, scale bar, legend or background
  bool has_axes = false;         ///< ticks with their values, or arrows if no axis lies in the picture
  bool has_one_scale = false;    ///< for all panels, even if that makes one of them tiny
};

/// One panel of a picture.
struct PanelLayout {
  Box frame;  ///< the card behind it
  Box plot;   ///< where the graph is drawn; what axes enclose
  Box fit;    ///< within it: what the graph must fit into
};

class Layout {
 public:
  /// `has_ticks`: room for the values at axes is left.
  Layout(const PictureOptions& options, std::size_t panels, bool has_ticks);

  double width() const { return width_; }
  double height() const { return height_; }
  /// What lengths of lines and margins are multiplied by: 1 in a panel of the usual size.
  double unit() const { return unit_; }
  /// What sizes of text are multiplied by.
  double text() const { return text_; }
  /// The strip for the title above all panels; 0 if there is none.
  double title_height() const { return title_height_; }
  double legend_top() const { return height_ - legend_height_; }
  PanelLayout panel(std::size_t index) const;

 private:
  bool is_bare_, has_ticks_;
  double width_, height_, panel_width_, unit_, text_, title_height_ = 0, legend_height_ = 0;
};

}  // namespace boxplus::app
