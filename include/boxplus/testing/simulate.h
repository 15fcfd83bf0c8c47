// SPDX-License-Identifier: BSD-3-Clause
// Simulates graphs with known true estimates, for tests, benchmarks and demonstrations.
//
// The same options give the same graph with every compiler, because the random number generator is part of
// the library. The covariances of the noise are the inverses of the edges' information matrices. So without
// outliers, chi2 at the true estimates is about the number of rows of all errors. The first pose is fixed at
// its true place; the initial estimates of the other poses and of the landmarks come from the odometry.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

enum class World : std::uint8_t {
  kSphere,     ///< a spiral on a sphere from pole to pole, with loop closures to the places one lap before
  kTorus,      ///< laps around a torus, with loop closures as on the sphere; the last lap meets the first
  kGrid,       ///< a walk through all points of a cubic lattice, with loop closures to neighboring points
  kManhattan,  ///< a random walk through a plane grid of streets, with loop closures at crossings
  kStreets,    ///< a drive through every street of a town, 2 to 4 times, with at least 100 poses between
               ///< crossings and loop closures to places visited before; about 4 edges per pose
  kCity,       ///< a drive as in kStreets, but with short streets, and landmarks in place of loop closures
  kPlanes,     ///< flights to and fro through rooms; a sensor, whose pose on the robot is unknown, sees the
               ///< walls
  kLines       ///< the same flights; the sensor sees the edges of the rooms, and its pose is a parameter
};
inline constexpr std::array kWorlds{World::kSphere,  World::kTorus, World::kGrid,   World::kManhattan,
                                    World::kStreets, World::kCity,  World::kPlanes, World::kLines};
std::string_view to_string(World world);

struct SimulationOptions {
  int poses = 2500;  ///< approximate number, because sphere, torus and grid consist of whole laps
  std::uint64_t seed = 1;
  double noise = 1;  ///< factor on all standard deviations; 0: exact measurements, weighted as for factor 1
  /// The fraction of loop closures and observations that are wrong, because they mistake one place or
  /// landmark for another random one. Odometry is never wrong, and all other measurements are the same as
  /// without outliers.
  double outliers = 0;
};

enum class EdgeKind : std::uint8_t {
  kOdometry,     ///< odometry from a pose to the next pose
  kRecognition,  ///< a loop closure, an observed landmark, or an absolute measurement
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
