// SPDX-License-Identifier: BSD-3-Clause
// The world of a simulated problem of bundle adjustment: cameras, and surfaces that they see.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "boxplus/manifold/se3.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// A point of a surface, and the cameras that may recognize it.
struct SurfacePoint {
  Vector3 position;
  Vector3 view;           ///< unit vector, from the camera that found the point to the point
  double min_cosine;      ///< of the angle between `view` and the view of another camera
  double max_distance;    ///< from a camera to the point
  Vector2 search_center;  ///< all these cameras are within search_radius of this place, seen from above
  double search_radius;
  /// The probability that such a camera recognizes the point, in addition to BundleScene::chance().
  double chance = 1;
};

class BundleScene {
 public:
  virtual ~BundleScene() = default;

  /// Places the cameras. The greater `overlap` is (from 0 to 1), the more cameras see a point.
  virtual void place(int cameras, double overlap, RandomNumbers random) = 0;

  /// The point that a ray from a camera hits, or nothing if it hits no point that the camera recognizes.
  /// `direction` is a unit vector.
  virtual std::optional<SurfacePoint> hit(const Vector3& camera, const Vector3& direction,
                                          RandomNumbers& random) const = 0;

  /// Whether a surface is between a camera and a point.
  virtual bool is_hidden(const Vector3& point, const Vector3& camera) const = 0;

  /// The probability that a camera observes a point that it sees.
  virtual double chance() const { return 1; }

  const std::vector<SE3>& poses() const { return poses_; }  ///< T_world_camera

 protected:
  BundleScene() = default;
  BundleScene(const BundleScene&) = default;
  BundleScene& operator=(const BundleScene&) = default;

  std::vector<SE3> poses_;
};

/// A pose of a camera of BAL's model, which looks `forward`, not straight up or down, and holds its image
/// upright. Its direction has an error of about `deviation` radians per axis.
SE3 upright_pose(const Vector3& position, const Vector3& forward, double deviation, RandomNumbers& random);

/// A random number between `low` and `high`, whose logarithm is uniformly distributed.
double log_uniform(double low, double high, RandomNumbers& random);

std::unique_ptr<BundleScene> make_ring_scene();
std::unique_ptr<BundleScene> make_town_scene(bool returns);
std::unique_ptr<BundleScene> make_collection_scene();

}  // namespace boxplus
