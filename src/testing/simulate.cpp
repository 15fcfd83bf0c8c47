// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate.h"

#include <cmath>
#include <string>

#include "boxplus/base/error.h"
#include "testing/worlds.h"

namespace boxplus {

std::string_view to_string(World world) {
  switch (world) {
    case World::kSphere:
      return "sphere";
    case World::kTorus:
      return "torus";
    case World::kGrid:
      return "grid";
    case World::kManhattan:
      return "manhattan";
    case World::kStreets:
      return "streets";
    case World::kCity:
      return "city";
    case World::kPlanes:
      return "planes";
    default:
      return "lines";
  }
}

Simulation simulate(World world, const SimulationOptions& options) {
  if (options.poses < 2)
    throw InvalidArgument("simulate: expected at least 2 poses, got " + std::to_string(options.poses));
  if (!(options.noise >= 0) || !std::isfinite(options.noise)) {
    throw InvalidArgument("simulate: expected a noise factor ≥ 0, got " + std::to_string(options.noise));
  }
  if (!(options.outliers >= 0 && options.outliers <= 1)) {
    throw InvalidArgument("simulate: expected a fraction of outliers in [0, 1], got " +
                          std::to_string(options.outliers));
  }
  switch (world) {
    case World::kSphere:
      return simulate_sphere(options);
    case World::kTorus:
      return simulate_torus(options);
    case World::kGrid:
      return simulate_grid(options);
    case World::kManhattan:
      return simulate_manhattan(options);
    case World::kStreets:
      return simulate_streets(options);
    case World::kCity:
      return simulate_city(options);
    case World::kPlanes:
      return simulate_planes(options);
    default:
      return simulate_lines(options);
  }
}

}  // namespace boxplus
