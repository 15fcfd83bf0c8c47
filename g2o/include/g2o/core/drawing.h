// SPDX-License-Identifier: BSD-3-Clause
// What the action "draw" draws into. SvgDrawing writes files; a viewer implements the same four functions.
#pragma once
#ifndef G2O_DRAWING_H
#define G2O_DRAWING_H

#include <string>
#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// Each part is in [0, 1].
struct Color {
  double red = 0, green = 0, blue = 0;
  double alpha = 1;
};

/// Takes shapes in world coordinates (metres). What is drawn in a plane has z = 0.
class G2O_CORE_API Drawing {
 public:
  virtual ~Drawing();

  /// Straight lines from corner to corner; `isClosed`: and back to the first. The width is in pixels.
  virtual void polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                        double width) = 0;
  /// A dot with a diameter in pixels.
  virtual void point(const Vector3& at, const Color& color, double diameter) = 0;
  /// An arrowhead in the xy-plane of a pose: its tip is at (length, 0), its back at (−length/2, ±width).
  virtual void pose(const Isometry3& pose, const Color& color, double length, double width) = 0;
  /// Words that begin at a place, `height` metres high.
  virtual void text(const Vector3& at, const std::string& words, const Color& color, double height) = 0;

  void line(const Vector3& from, const Vector3& to, const Color& color, double width) {
    polyline({from, to}, false, color, width);
  }
  /// The edges of a cube around the origin of a pose.
  void cube(const Isometry3& pose, const Color& color, double side, double width);
};

}  // namespace g2o

#endif  // G2O_DRAWING_H
