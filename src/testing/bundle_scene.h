// SPDX-License-Identifier: BSD-3-Clause
// The places of cameras, and of points on the walls and on the ground that they pass.
#pragma once

#include <memory>
#include <vector>

#include "boxplus/manifold/se3.h"
#include "boxplus/testing/simulate_bundle.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// A point on a surface. It is visible only from the side to which the normal points.
struct SurfacePoint {
  Vector3 place, normal;
};

/// Lengths are in meters; z points up.
struct BundleScene {
  /// The largest distance from which a camera sees a point.
  static constexpr double kRange = 30;

  std::vector<SE3> cameras;  ///< T_world_camera of cameras that look along −z, in the order of time

  virtual ~BundleScene() = default;
  /// A random point near the path of the cameras.
  virtual SurfacePoint draw(RandomNumbers& random) const = 0;
};

/// A scene in which about `options.track_length` cameras see a point.
std::unique_ptr<BundleScene> make_bundle_scene(BundleWorld world, const BundleOptions& options);

}  // namespace boxplus
