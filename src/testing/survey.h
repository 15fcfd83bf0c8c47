// SPDX-License-Identifier: BSD-3-Clause
// Finds points of a scene, and all cameras that see them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxplus/types/ba/camera_models.h"
#include "testing/bundle_scene.h"
#include "testing/plane_cells.h"

namespace boxplus {

/// An image of BAL's model: its center is 0.
struct BundleImage {
  static constexpr double kHalfWidth = 500, kHalfHeight = 375;  // pixels
  static bool contains(const Vector2& pixel) {
    return std::abs(pixel[0]) <= kHalfWidth && std::abs(pixel[1]) <= kHalfHeight;
  }
};

struct Observation {
  int camera;
  Vector2 pixel;  ///< without noise
};

/// A point, and its observations in the order of the cameras.
struct Track {
  Vector3 point;
  std::vector<Observation> observations;
};

class Survey {
 public:
  /// The cameras have the present poses of the scene. `intrinsics` are those of each camera, or of all
  /// cameras. Both must outlive the survey.
  Survey(const BundleScene& scene, std::span<const BalCamera> intrinsics);

  /// Sets `track` to a random point that at least two cameras observe, from directions that differ by at
  /// least 3°. The camera `finder` is one of them, unless there is no such point in its image. Throws
  /// InvalidArgument if the cameras see no such points.
  void find(int finder, RandomNumbers& random, Track& track) const;

  /// The mean number of observations of about `tracks` points, which all cameras find in equal parts.
  double mean_length(int tracks, RandomNumbers random) const;

 private:
  bool try_to_find(int finder, RandomNumbers& random, Track& track) const;
  /// Whether the directions from which `track` is seen determine the distance of its point.
  bool has_parallax(const SurfacePoint& point, const Track& track) const;
  std::optional<Vector2> pixel_of(int camera, const SurfacePoint& point) const;

  const BundleScene& scene_;
  std::span<const BalCamera> intrinsics_;
  PlaneCells cells_;
};

}  // namespace boxplus
