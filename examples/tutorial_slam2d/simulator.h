// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "se2.h"

namespace g2o {
namespace tutorial {

// [simulation]
/// The options of a simulation. Lengths are in meters, and angles are in radians.
struct SimulationOptions {
  int poses = 300;
  int landmarks = 100;
  double world = 12;     ///< half the side of the square that contains the robot and the landmarks
  double step = 1;       ///< distance between consecutive poses
  double range = 5;      ///< largest distance at which the sensor sees landmarks
  double opening = 1.5;  ///< largest angle between the sensor's axis and a landmark that it sees
  double odometry_noise = 0.05, turn_noise = 0.02, landmark_noise = 0.05;  ///< standard deviations
  SE2 sensor_offset{0.2, 0.1, -0.1};
  unsigned seed = 1;
};

/// A simulated world: the true poses and landmarks, and the measurements of the robot.
struct Simulation {
  struct Motion {
    int from, to;
    SE2 measured;
  };
  struct Observation {
    int pose, landmark;
    Vector2 measured;
  };

  std::vector<SE2> poses;
  std::vector<Vector2> landmarks;
  std::vector<Motion> odometry;
  std::vector<Observation> observations;
  Matrix3 odometry_information;
  Matrix2 landmark_information;
};

/// Simulates a world. The result depends only on the options, not on the platform.
Simulation simulate(const SimulationOptions& options);
// [/simulation]

/// Generates pseudo-random numbers that are the same on all platforms. The distributions of the standard
/// library do not guarantee this.
class Noise {
 public:
  explicit Noise(unsigned seed) : _engine(seed) {}
  double uniform(double low, double high);
  double normal(double standard_deviation);

 private:
  std::mt19937 _engine;
};

}  // namespace tutorial
}  // namespace g2o
