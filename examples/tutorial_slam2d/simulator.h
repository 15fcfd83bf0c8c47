// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "se2.h"

namespace g2o {
namespace tutorial {

// [simulation]
/// What to simulate; lengths in metres, angles in radians.
struct SimulationOptions {
  int poses = 300;
  int landmarks = 100;
  double world = 12;     ///< half the side of the square that the robot and the landmarks are in
  double step = 1;       ///< how far the robot drives from pose to pose
  double range = 5;      ///< how far the sensor sees,
  double opening = 1.5;  ///< and how far to each side
  double odometry_noise = 0.05, turn_noise = 0.02, landmark_noise = 0.05;  ///< standard deviations
  SE2 sensor_offset{0.2, 0.1, -0.1};
  unsigned seed = 1;
};

/// The truth, and what the robot measured of it.
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

/// The same world for the same options, on every machine.
Simulation simulate(const SimulationOptions& options);
// [/simulation]

/// Pseudo-random numbers with a normal distribution. The standard's own is not the same everywhere.
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
