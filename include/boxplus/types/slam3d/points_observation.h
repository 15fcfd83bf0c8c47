// SPDX-License-Identifier: BSD-3-Clause
// Several points in space, seen at once from one pose, with correlated noise.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

/// Error: X⁻¹ p_k − z_k for any number of points, one after the other. Throws InvalidArgument if the
/// measurement has another number of points. The tag in g2o files is EDGE_SE3_LOTSOF_XYZ.
struct PointsObservation3 {
  static constexpr std::string_view kName = "PointsObservation3";
  Vector<double, kDynamic> measurement;  ///< x1, y1, z1, x2, …

  explicit PointsObservation3(Vector<double, kDynamic> z) : measurement(std::move(z)) {}

  template <class S, class Chart, class Point>
  Vector<S, kDynamic> error(const BasicSE3<S, Chart>& pose, std::span<const Point> points) const {
    if (measurement.size() != 3 * static_cast<Eigen::Index>(points.size())) {
      throw InvalidArgument("PointsObservation3: expected 3 numbers for each of " +
                            std::to_string(points.size()) + " points, the measurement has " +
                            std::to_string(measurement.size()));
    }
    Vector<S, kDynamic> e(measurement.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      e.template segment<3>(3 * static_cast<Eigen::Index>(k)) = pose.inverse_times(points[k]);
    }
    return e - measurement;
  }
};

}  // namespace boxplus
