// SPDX-License-Identifier: BSD-3-Clause
// The kernels in the library that linearize several reprojection edges at a time. reprojection.h includes
// this file, so that every pool of these edges uses them.
#pragma once

#include <array>

#include "boxplus/graph/typed_edge_pool.h"
#include "boxplus/types/ba/reprojection.h"

namespace boxplus::detail {

/// Whether the library has kernels for edges with this camera.
template <class Camera>
inline constexpr bool kHasReprojectionKernel = CameraList::place_of<Camera>() >= 0;

/// The arrays of an edge: the pixel, the pose of the camera, the point, and the parameters of the camera.
inline constexpr int kReprojectionSources = 4;
using ReprojectionSources = std::array<const double*, kReprojectionSources>;

/// The first column of the point and of the camera in the Jacobian. The columns of the pose come first. −1:
/// the parameters of the camera are constants.
struct ReprojectionColumns {
  int point, camera;
};

/// Computes errors and, unless `jacobian` is null, Jacobians in lanes (EdgeTile). `camera` is the place of
/// the camera in CameraList.
void linearize_reprojections(int camera, int count, const LaneSources<kReprojectionSources>& sources,
                             ReprojectionColumns columns, double* error, double* jacobian);

template <class Camera, int kPointColumn, int kCameraColumn>
struct ReprojectionKernel {
  static constexpr bool kExists = true;
  static constexpr int kSources = kReprojectionSources;
  static void linearize(int count, const LaneSources<kSources>& sources, double* error, double* jacobian) {
    linearize_reprojections(CameraList::place_of<Camera>(), count, sources, {kPointColumn, kCameraColumn},
                            error, jacobian);
  }
};

template <class Camera>
requires kHasReprojectionKernel<Camera>
struct LaneKernel<Reprojection<Camera>, SE3, Vector3, Camera> : ReprojectionKernel<Camera, 6, 9> {
  static ReprojectionSources sources(const Reprojection<Camera>& edge, const SE3& pose, const Vector3& point,
                                     const Camera& camera) {
    return {edge.measurement.data(), pose.data(), point.data(), camera.parameters.data()};
  }
};

template <class Camera>
requires kHasReprojectionKernel<Camera>
struct LaneKernel<Reprojection<Camera>, Product<SE3, Camera>, Vector3>
    : ReprojectionKernel<Camera, 6 + Camera::kSize, 6> {
  static ReprojectionSources sources(const Reprojection<Camera>& edge, const Product<SE3, Camera>& camera,
                                     const Vector3& point) {
    return {edge.measurement.data(), camera.template get<0>().data(), point.data(),
            camera.template get<1>().parameters.data()};
  }
};

template <class Camera>
requires kHasReprojectionKernel<Camera>
struct LaneKernel<CalibratedReprojection<Camera>, SE3, Vector3> : ReprojectionKernel<Camera, 6, -1> {
  static ReprojectionSources sources(const CalibratedReprojection<Camera>& edge, const SE3& pose,
                                     const Vector3& point) {
    return {edge.measurement.data(), pose.data(), point.data(), edge.camera.parameters.data()};
  }
};

}  // namespace boxplus::detail
