// SPDX-License-Identifier: BSD-3-Clause
// Simulates problems of bundle adjustment with known true estimates, for tests, benchmarks and
// demonstrations.
//
// The same options give the same problem with every compiler, because the random number generator is part of
// the library. On another computer, values may differ by rounding errors. Cameras are of BAL's model
// (types/ba/camera_models.h), and their images have 1000 × 750 pixels. A camera observes a point if the point
// is in its image, no surface hides it, and the camera sees it from a similar direction and distance as other
// cameras. So the shape of the world determines which cameras share points.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/types/ba.h"

namespace boxplus {

enum class BundleShape : std::uint8_t {
  kRing,    ///< cameras on a ring around an object, which look at it; any two near cameras share points
  kStreet,  ///< a car that looks ahead, drives through the streets of a town, and never returns
  kCity,    ///< the same in a small town: it drives through each street about three times
  /// Photos of the sights around a square, without any order. Some sights are in far more photos than others.
  /// Most points have few observations, and a few points are in a large part of the photos. So almost half
  /// of all pairs of cameras share points.
  kCollection
};
inline constexpr std::array kBundleShapes{BundleShape::kRing, BundleShape::kStreet, BundleShape::kCity,
                                          BundleShape::kCollection};
std::string_view to_string(BundleShape shape);

/// The vertices that contain intrinsic parameters.
enum class BundleIntrinsics : std::uint8_t {
  kWithPose,  ///< each camera is one vertex Product<SE3, BalCamera>, as in BAL's files
  kSeparate,  ///< each camera has two vertices, SE3 and BalCamera
  kShared     ///< all cameras share one vertex BalCamera
};

struct BundleOptions {
  int cameras = 100;
  int points = 10'000;
  /// The average number of cameras that observe a point. It determines how many of the visible points a
  /// camera observes and, in the street and the city, the distance from one camera to the next (at most 5 m).
  /// Tracks are shorter if there are too few cameras for it.
  double track_length = 5;
  std::uint64_t seed = 1;
  double noise = 1;        ///< standard deviation of the coordinates of a pixel; edges are weighted as for 1
  double pose_noise = 1;   ///< errors of initial poses; 1: standard deviations of 0.1 m and 0.5° per axis
  double point_noise = 1;  ///< errors of initial points; 1: a standard deviation of 0.1 m per axis
  double intrinsics_noise = 1;  ///< errors of initial intrinsics; 1: 1 % of f, 0.01 of k1, 0.001 of k2
  /// The fraction of observations that are wrong: at a random pixel of the image, at least 20 pixels from the
  /// true one. All other measurements are the same as without outliers.
  double outliers = 0;
  BundleIntrinsics intrinsics = BundleIntrinsics::kWithPose;
};

/// The vertices of `graph` have the ids 0, 1, … in this order: the cameras (or their poses), separate
/// intrinsics, the points, which are marked to be eliminated. Every point has observations by at least two
/// cameras, from directions that differ by at least 3°. Edges are Reprojection<BalCamera> with the identity
/// as information, point by point. So without outliers, chi2 at the truth is about noise² times the number of
/// rows of all errors. No vertex is fixed.
struct BundleSimulation {
  Graph graph;
  BundleIntrinsics intrinsics = BundleIntrinsics::kWithPose;
  std::vector<SE3> true_poses;             ///< T_world_camera per camera, in meters
  std::vector<BalCamera> true_intrinsics;  ///< per camera, or of all cameras
  std::vector<Vector3> true_points;
  std::vector<bool> is_outlier;  ///< per edge, in the order of graph.all_edges()

  /// Sets all estimates of `any` to the truth. It must be `graph` or a copy. Takes time in proportion to the
  /// number of vertices, and no memory.
  void set_to_truth(Graph& any) const;
};

/// Takes time and memory in proportion to the number of observations: for 10 million, about 10 seconds
/// and 1.1 times the memory of the graph. (A collection also takes time in proportion to cameras times
/// points.) Throws InvalidArgument for fewer than 2 cameras, no points, a track length below 2, negative
/// noise, a fraction of outliers outside [0, 1], and if no two cameras see common points.
BundleSimulation simulate_bundle(BundleShape shape, const BundleOptions& options = {});

}  // namespace boxplus
