// SPDX-License-Identifier: BSD-3-Clause
// Draws the parts of a picture that show lengths and directions: ticks with their values, arrows along x, y
// and z, and the scale bar.
#pragma once

#include <optional>
#include <string>

#include "plot/canvas/canvas.h"
#include "plot/layout.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Maps meters of the picture plane to points on the canvas.
struct PlaneMap {
  Box plot;
  double scale = 1;  ///< the number of pixels per meter
  double center_x = 0, center_y = 0;

  Point operator()(double x, double y) const {
    return {plot.left + plot.width / 2 + scale * (x - center_x),
            plot.top + plot.height / 2 - scale * (y - center_y)};
  }
};

/// The names of the horizontal and the vertical axis of the picture. axis_names() returns nothing if these
/// are not axes of the world.
struct AxisNames {
  const char *across, *up;
};
std::optional<AxisNames> axis_names(bool is_spatial, const View& view);

void draw_ticks(const PlaneMap& map, const AxisNames& names, const Layout& layout, Canvas& canvas);
void draw_arrows(const Box& plot, const View& view, const Layout& layout, Canvas& canvas);
/// Draws the scale bar in the lower right corner of a panel whose right and bottom edges are at `right` and
/// `bottom`. The unit of length is empty in bundle adjustment, because images do not determine the scale.
void draw_scale_bar(double right, double bottom, double scale, const char* unit_of_length,
                    const Layout& layout, Canvas& canvas);

}  // namespace boxplus::app
