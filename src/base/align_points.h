// SPDX-License-Identifier: BSD-3-Clause
// Finds the rigid motion or similarity that fits two sets of corresponding points best.
#pragma once

#include <Eigen/Core>

namespace boxplus {

/// A matrix with one point per column.
using Points = Eigen::Ref<const Eigen::MatrixXd>;

/// The motion y = scale · rotation · x + translation.
struct PointAlignment {
  double scale = 1;
  Eigen::MatrixXd rotation;
  Eigen::VectorXd translation;
};

/// The motion that brings the points x in `from` closest to the points y in `to`. It minimizes the sum of the
/// squared distances (Umeyama, Least-squares estimation of transformation parameters between two point
/// patterns, 1991, eq. 40–43). The points are in the plane or in space. Both sets have the same number of
/// points, which is at least one. The scale stays 1 unless `with_scale` is true.
PointAlignment align_points(const Points& from, const Points& to, bool with_scale);

}  // namespace boxplus
