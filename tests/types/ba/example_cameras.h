// SPDX-License-Identifier: BSD-3-Clause
// A camera of every model with all of its terms, and points that it sees.
#pragma once

#include <map>
#include <string_view>
#include <type_traits>
#include <vector>

#include "boxplus/types/ba/camera_models.h"

namespace boxplus {

/// A camera with a value for each parameter, by its name.
template <class Camera>
Camera example_camera() {
  static const std::map<std::string_view, double> values{
      {"f", 500},     {"fx", 500},    {"fy", 510},    {"cx", 320},   {"cy", 240},
      {"k", -0.1},    {"k1", -0.1},   {"k2", 0.03},   {"k3", 0.01},  {"k4", 0.02},
      {"k5", 0.05},   {"k6", -0.01},  {"p1", 2e-3},   {"p2", -3e-3}, {"sx1", 1e-3},
      {"sy1", -2e-3}, {"omega", 0.9}, {"alpha", 0.6}, {"beta", 1.1}};
  Camera camera;
  for (int i = 0; i < Camera::kSize; ++i)
    camera.parameters[i] = values.at(Camera::Model::kParameters[static_cast<std::size_t>(i)]);
  return camera;
}

/// Moderate also behind the camera, where θ¹² is 9e5.
template <>
inline RadTanThinPrismFisheyeCamera example_camera() {
  return RadTanThinPrismFisheyeCamera(500, 510, 320, 240, 0.04, -0.01, 1e-3, 1e-4, -1e-5, 1e-6, 2e-3, -3e-3,
                                      1e-3, -2e-4, 3e-3, 1e-4);
}

/// Calls f(camera) with an example of every camera.
template <class F>
void for_each_camera(F&& f) {
  detail::CameraList::for_each([&]<class Camera>() { f(example_camera<Camera>()); });
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
