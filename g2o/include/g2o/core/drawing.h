// SPDX-License-Identifier: BSD-3-Clause
// The interface through which the action "draw" draws shapes. g2o::Viewer (g2o/viewer/viewer.h) shows them in
// a browser.
#pragma once
#ifndef G2O_DRAWING_H
#define G2O_DRAWING_H

#include <string>
#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// Red, green, blue and opacity, each in [0, 1].
struct Color {
  double red = 0, green = 0, blue = 0;
  double alpha = 1;
};

/// Receives shapes in world coordinates (meters). Shapes of planar graphs have z = 0.
class G2O_CORE_API Drawing {
 public:
  virtual ~Drawing();

  /// Draws straight lines from corner to corner. If `isClosed` is true, also draws a line from the last
  /// corner to the first corner. The width is in pixels.
  virtual void polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                        double width) = 0;
  /// Draws a dot. The diameter is in pixels.
  virtual void point(const Vector3& at, const Color& color, double diameter) = 0;
  /// Draws an arrowhead in the xy-plane of a pose. Its tip is at (length, 0), and its back corners are at
  /// (−length/2, ±width).
  virtual void pose(const Isometry3& pose, const Color& color, double length, double width) = 0;
  /// Draws text that begins at a point and is `height` meters high.
  virtual void text(const Vector3& at, const std::string& words, const Color& color, double height) = 0;

  void line(const Vector3& from, const Vector3& to, const Color& color, double width) {
    polyline({from, to}, false, color, width);
  }
  /// Draws the edges of a cube around the origin of a pose.
  void cube(const Isometry3& pose, const Color& color, double side, double width);
};

}  // namespace g2o

#endif  // G2O_DRAWING_H
