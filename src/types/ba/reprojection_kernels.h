// SPDX-License-Identifier: BSD-3-Clause
// Errors and Jacobians of reprojection edges, several at a time. Compiled once per instruction set.
#pragma once

namespace boxplus::dense {

/// Reprojection edges of one shape: for each edge, pointers to its pixel, the pose of its camera, its point,
/// and the parameters of its camera.
struct Reprojections {
  int count;
  const double *const *pixel, *const *pose, *const *point, *const *camera;
  /// The first column of the Jacobian that belongs to the point and to the camera. The pose has the first
  /// columns. Without a column for the camera (−1), its parameters are constants.
  int point_column, camera_column;
};

/// Writes the errors and, unless `jacobian` is null, the Jacobians in lanes (kernels/kernel_table.h).
using Reproject = void (*)(const Reprojections& edges, double* error, double* jacobian);

/// The kernels for the instruction set of kernels(): one for each camera of CameraList, in its order.
const Reproject* reprojection_kernels();

namespace baseline {
extern const Reproject* const kReprojectionKernels;
}
namespace avx2 {
extern const Reproject* const kReprojectionKernels;
}
namespace avx512 {
extern const Reproject* const kReprojectionKernels;
}
namespace neon {
extern const Reproject* const kReprojectionKernels;
}

}  // namespace boxplus::dense
