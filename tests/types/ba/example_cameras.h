// SPDX-License-Identifier: BSD-3-Clause
// A camera of every model with all of its terms, and points that they see.
#pragma once

#include <tuple>
#include <vector>

#include "boxplus/types/ba/camera_models.h"

namespace boxplus {

inline const auto kExampleCameras = std::tuple(
    BalCamera(500, -0.1, 0.03), SimplePinholeCamera(500, 320, 240), PinholeCamera(500, 510, 320, 240),
    SimpleRadialCamera(500, 320, 240, -0.1), RadialCamera(500, 320, 240, -0.1, 0.03),
    OpenCvCamera(500, 510, 320, 240, -0.1, 0.03, 0.002, -0.003),
    OpenCvFisheyeCamera(300, 310, 320, 240, 0.05, -0.01, 0.004, -0.001),
    FullOpenCvCamera(500, 510, 320, 240, -0.1, 0.03, 0.002, -0.003, 0.01, 0.2, 0.05, -0.01),
    SimpleRadialFisheyeCamera(300, 320, 240, 0.05), RadialFisheyeCamera(300, 320, 240, 0.05, -0.01),
    FovCamera(300, 310, 320, 240, 0.9),
    ThinPrismFisheyeCamera(300, 310, 320, 240, 0.05, -0.01, 0.002, -0.003, 0.004, -0.001, 0.001, -0.002));

/// Calls f(camera) for each of them.
template <class F>
void for_each_camera(F&& f) {
  std::apply([&](const auto&... camera) { (f(camera), ...); }, kExampleCameras);
}

/// The axis along which a camera looks: 1 for z, −1 for −z.
template <class Camera>
inline constexpr double kForward = std::is_same_v<typename Camera::Model, detail::BalModel> ? -1 : 1;

/// Points in front of the camera, on and off the axis.
template <class Camera>
std::vector<Vector3> points_seen_by(const Camera& /*camera*/) {
  const double z = kForward<Camera>;
  return {Vector3(0.3, -0.2, 2 * z),  Vector3(-1, 0.7, 1.5 * z), Vector3(0, 0, z), Vector3(1e-7, 2e-7, z),
          Vector3(1e-5, 2e-5, 3 * z), Vector3(0.01, 0, z),       Vector3(0, -1, z)};
}

}  // namespace boxplus
