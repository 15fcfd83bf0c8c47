// SPDX-License-Identifier: BSD-3-Clause
// Several points in the plane, seen at once from one pose, with correlated noise.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

/// Error: (X⁻¹ p1 − z1, X⁻¹ p2 − z2), with z = (x1, y1, x2, y2). The tag in g2o files is
/// EDGE_SE2_TWOPOINTSXY.
struct TwoPointsObservation2 {
  static constexpr std::string_view kName = "TwoPointsObservation2";
  Vector<double, 4> measurement;

  explicit TwoPointsObservation2(const Vector<double, 4>& z) : measurement(z) {}

  template <class S, class Point>
  Vector<S, 4> error(const BasicSE2<S>& pose, const Point& p1, const Point& p2) const {
    Vector<S, 4> e;
    e << pose.inverse_times(p1), pose.inverse_times(p2);
    return e - measurement;
  }
};

/// Error: X⁻¹ p_k − z_k for any number of points, one after the other. Throws InvalidArgument if the
/// measurement has another number of points. The tag in g2o files is EDGE_SE2_LOTSOFXY.
struct PointsObservation2 {
  static constexpr std::string_view kName = "PointsObservation2";
  Vector<double, kDynamic> measurement;  ///< x1, y1, x2, y2, …

  explicit PointsObservation2(Vector<double, kDynamic> z) : measurement(std::move(z)) {}

  template <class S, class Point>
  Vector<S, kDynamic> error(const BasicSE2<S>& pose, std::span<const Point> points) const {
    if (measurement.size() != 2 * static_cast<Eigen::Index>(points.size())) {
      throw InvalidArgument("PointsObservation2: expected 2 numbers for each of " +
                            std::to_string(points.size()) + " points, the measurement has " +
                            std::to_string(measurement.size()));
    }
    Vector<S, kDynamic> e(measurement.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      e.template segment<2>(2 * static_cast<Eigen::Index>(k)) = pose.inverse_times(points[k]);
    }
    return e - measurement;
  }
};

}  // namespace boxplus
