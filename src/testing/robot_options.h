// SPDX-License-Identifier: BSD-3-Clause
// What the options of all simulated robots have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "boxplus/base/error.h"
#include "boxplus/testing/simulate_robot.h"
#include "testing/random_numbers.h"

namespace boxplus {

inline void require_option(bool holds, const char* expected, double came) {
  if (!holds)
    throw InvalidArgument("simulate_robot: expected " + std::string(expected) + ", got " +
                          std::to_string(came));
}

template <class Options>
void check_robot(const Options& options) {
  require_option(options.poses >= 2, "at least 2 poses", options.poses);
  require_option(options.world_size >= 4 && std::isfinite(options.world_size), "a world of at least 4 m",
                 options.world_size);
  require_option(options.landmarks >= 0, "a number of landmarks ≥ 0", options.landmarks);
  require_option(options.noise >= 0 && std::isfinite(options.noise), "a noise factor ≥ 0", options.noise);
  require_option(options.outliers >= 0 && options.outliers <= 1, "a fraction of outliers in [0, 1]",
                 options.outliers);
}

template <class Options, class Sensor>
bool has(const Options& options, Sensor sensor) {
  return std::find(options.sensors.begin(), options.sensors.end(), sensor) != options.sensors.end();
}

/// The seed of the world, which differs from that of the noise.
inline std::uint64_t world_seed(std::uint64_t seed) {
  return seed ^ 0x9E3779B97F4A7C15u;
}

template <class Options>
SimulationOptions simulation_options(const Options& options) {
  return {.poses = options.poses, .seed = options.seed, .noise = options.noise, .outliers = options.outliers};
}

/// z + n, where n has these standard deviations.
template <int N>
Vector<double, N> noisy(const Vector<double, N>& z, const Vector<double, N>& deviations, double factor,
                        RandomNumbers& random) {
  Vector<double, N> result = z;
  for (int i = 0; i < N; ++i) result[i] += factor * deviations[i] * random.normal();
  return result;
}

}  // namespace boxplus
