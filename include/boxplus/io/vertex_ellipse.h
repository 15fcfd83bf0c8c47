// SPDX-License-Identifier: BSD-3-Clause
// The uncertainty of a pose in the plane, which .g2o files list after the pose (io/data.h).
#pragma once

#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/io/field_reader.h"

namespace boxplus {

/// A line VERTEX_ELLIPSE of a .g2o file.
struct VertexEllipse {
  static constexpr std::string_view kTag = "VERTEX_ELLIPSE";

  /// Of (x, y, θ), in meters and radians, in the frame of the pose; symmetric.
  Matrix<double, 3, 3> covariance = Matrix<double, 3, 3>::Zero();
  /// The positions of vertices that may match this one, in meters, in the frame of the pose.
  std::vector<Vector<double, 2>> matching_vertices;

  /// Reads the fields after the tag: the upper triangle of the covariance by rows, and a list of points with
  /// its size. Throws InputError if a field is missing or no finite number, if the position has no covariance
  /// (a negative variance), or if there are more fields. The memory is proportional to the length of the
  /// line.
  static VertexEllipse read(FieldReader& in);
  /// Writes the fields after the tag. Throws InvalidArgument if a number is not finite.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
