// SPDX-License-Identifier: BSD-3-Clause
#include "plot/layout.h"

#include <algorithm>

namespace boxplus::app {
namespace {

constexpr double kPanelWidth = 620, kHeight = 666, kFontSize = 15;

}  // namespace

Layout::Layout(const PictureOptions& options, std::size_t panels, bool has_ticks)
    : is_bare_(options.is_bare), has_ticks_(has_ticks) {
  const auto count = static_cast<double>(panels);
  width_ = options.width > 0 ? options.width : kPanelWidth * count;
  height_ = options.height > 0 ? options.height : kHeight;
  panel_width_ = width_ / count;
  unit_ = std::min(panel_width_ / kPanelWidth, height_ / kHeight);
  text_ = options.font_size > 0 ? options.font_size / kFontSize : unit_;
  if (is_bare_) return;
  if (!options.title.empty() && panels > 1) title_height_ = 46 * text_;
  legend_height_ = 74 * text_;
}

PanelLayout Layout::panel(std::size_t index) const {
  const double left = panel_width_ * static_cast<double>(index), right = left + panel_width_;
  const double gap = 8 * unit_;
  PanelLayout panel;
  panel.frame = {left + gap, title_height_ + gap, panel_width_ - 2 * gap, legend_top() - title_height_ - gap};
  // In a bare picture, the space around the graph is as wide as half a drawn vertex. In other pictures, it
  // contains the margin, the header and the scale bar, and the values at the ticks.
  const double margin = is_bare_ ? gap : 30 * unit_;
  double plot_left = left + margin, plot_right = right - margin;
  double top = is_bare_ ? gap : panel.frame.top + 84 * text_,
         bottom = legend_top() - (is_bare_ ? gap : 50 * text_);
  if (has_ticks_) {
    plot_left += 44 * text_;
    plot_right -= 8 * text_;
    top += 16 * text_;
    bottom = legend_top() - (is_bare_ ? gap : 14 * unit_) - 30 * text_;
  }
  constexpr double kLeast = 1;
  panel.plot = {plot_left, top, std::max(kLeast, plot_right - plot_left), std::max(kLeast, bottom - top)};
  const double inset = has_ticks_ ? std::min({12 * unit_, panel.plot.width / 4, panel.plot.height / 4}) : 0;
  panel.fit = {plot_left + inset, top + inset, panel.plot.width - 2 * inset, panel.plot.height - 2 * inset};
  return panel;
}

}  // namespace boxplus::app
