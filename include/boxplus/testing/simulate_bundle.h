// SPDX-License-Identifier: BSD-3-Clause
// Simulates problems of bundle adjustment with known true estimates, for tests, benchmarks and
// demonstrations.
//
// The graph is like that of a BAL file: cameras are vertices Product<SE3, BalCamera> with the ids 0, 1, …,
// points are vertices Vector3 after them, which are marked to be eliminated, and each edge is a
// Reprojection<BalCamera> with Ω = I. The noise of a pixel has the standard deviation 1 in both coordinates.
// So without outliers, chi2 at the true estimates is about the number of rows of all errors.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/ba.h"

namespace boxplus {

enum class BundleWorld : std::uint8_t {
  kRing,    ///< cameras look at a round building while they move around it once, so that the ring closes
  kStreet,  ///< a camera looks ahead while it moves through a winding street, without any loop
  kCity     ///< a camera looks ahead while it moves through all streets of a town, through some of them twice
};
inline constexpr std::array kBundleWorlds{BundleWorld::kRing, BundleWorld::kStreet, BundleWorld::kCity};
std::string_view to_string(BundleWorld world);

struct BundleOptions {
  int cameras = 100;
  int points = 10'000;
  /// The approximate mean number of cameras that see a point. It determines the distance between cameras.
  double track_length = 5;
  std::uint64_t seed = 1;
  /// Factor on the standard deviations of pixels (1 pixel) and of the initial estimates (0.1 m and 0.3° for
  /// poses, 0.5 % for focal lengths, 0.1 m for points). 0: exact pixels, and the truth as initial estimates.
  double noise = 1;
  double outliers = 0;  ///< the fraction of observations whose pixel is anywhere in the image
};

struct BundleSimulation {
  using Camera = Product<SE3, BalCamera>;

  Graph graph;
  std::vector<VertexHandle<Camera>> cameras;
  std::vector<VertexHandle<Vector3>> points;
  std::vector<Camera> true_cameras;
  std::vector<Vector3> true_points;
  std::vector<EdgeRef> edges;   ///< in the order of the points
  std::vector<EdgeKind> kinds;  ///< of each edge: kRecognition or kOutlier

  /// Moves all vertices of the graph to their true places.
  void set_to_truth();
};

/// Every point is seen by at least two cameras, from directions that differ by at least 3°. The same options
/// give the same graph with every compiler. Takes time in proportion to the number of observations, and
/// little more memory than the graph. Throws InvalidArgument for fewer than 2 cameras, no points, a track
/// length outside [2, 1000] or above the number of cameras, negative noise, a fraction of outliers
/// outside [0, 1], and if cameras are too far apart to see common places.
BundleSimulation simulate_bundle(BundleWorld world, const BundleOptions& options = {});

}  // namespace boxplus
