// SPDX-License-Identifier: BSD-3-Clause
// Simulated graphs with known true estimates, for tests, benchmarks and demonstrations.
//
// The same options give the same graph with every compiler, because the random number generator is part of
// the library. Noise is drawn according to the information matrices of the edges. So without outliers, chi2
// at the true estimates is about the number of rows of all errors. The first pose is fixed at its true place;
// the other estimates start at the odometry.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

enum class World : std::uint8_t {
  kSphere,     ///< a robot winds around a sphere from pole to pole, and sees its places of one lap ago
  kTorus,      ///< the same around a torus; the last lap meets the first
  kGrid,       ///< it visits all points of a cubic lattice, and sees the neighbors of each
  kManhattan,  ///< it walks at random through the streets of a plane, and recognizes crossings
  kStreets,  ///< it drives every street of a town 2 to 4 times, at least 100 poses from crossing to crossing,
             ///< and recognizes places that it has visited: about 4 edges per pose
  kCity      ///< the same in short streets, where it sees lampposts and corners of houses instead
};
inline constexpr std::array kWorlds{World::kSphere,    World::kTorus,   World::kGrid,
                                    World::kManhattan, World::kStreets, World::kCity};
std::string_view to_string(World world);

struct SimulationOptions {
  int poses = 2500;  ///< approximate number; sphere, torus and grid round to whole laps
  std::uint64_t seed = 1;
  double noise =
      1;  ///< factor on all standard deviations; 0: exact measurements, with the weights of factor 1
  /// The fraction of loop closures and observations that mistake one place (landmark) for another one, at
  /// random. Odometry is never wrong, and all other measurements are the same as without outliers.
  double outliers = 0;
};

enum class EdgeKind : std::uint8_t {
  kOdometry,     ///< from a pose to the next
  kRecognition,  ///< a loop closure, or an observed landmark
  kOutlier       ///< a loop closure or observation of a wrong place
};

struct Simulation {
  Graph graph;
  Graph truth;                              ///< the same vertices at their true places, with the same edges
  std::vector<EdgeRef> edges, truth_edges;  ///< in the order of creation
  std::vector<EdgeKind> kinds;              ///< kind of each edge
};

/// Takes time and memory in proportion to the number of poses. Throws InvalidArgument for fewer than 2 poses,
/// negative noise, and a fraction of outliers outside [0, 1].
Simulation simulate(World world, const SimulationOptions& options = {});

}  // namespace boxplus
