// SPDX-License-Identifier: BSD-3-Clause
#include "testing/bundle_scene.h"

#include <Eigen/Geometry>
#include <cmath>

namespace boxplus {

SE3 upright_pose(const Vector3& position, const Vector3& forward, double deviation, RandomNumbers& random) {
  const Vector3 right = forward.cross(Vector3(0, 0, 1)).normalized();
  Matrix<double, 3, 3> R_world_camera;
  R_world_camera << right, right.cross(forward).normalized(), -forward.normalized();
  Vector3 error;
  for (double& angle : error) angle = deviation * random.normal();
  return {position, SO3(R_world_camera) * SO3::from_rotation_vector(error)};
}

double log_uniform(double low, double high, RandomNumbers& random) {
  return low * std::exp(random.uniform(0, std::log(high / low)));
}

}  // namespace boxplus
