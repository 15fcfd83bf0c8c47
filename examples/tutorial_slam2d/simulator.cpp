// SPDX-License-Identifier: BSD-3-Clause
#include "simulator.h"

#include <algorithm>
#include <cmath>

namespace g2o {
namespace tutorial {
namespace {

/// Returns poses of a robot that drives straight ahead and sometimes makes a random quarter turn. The robot
/// also turns if the next step would leave the world.
std::vector<SE2> drive(const SimulationOptions& options, Noise& noise) {
  const double quarter = const_pi() / 2;
  const auto stays_inside = [&](const SE2& pose) {
    return pose.translation().cwiseAbs().maxCoeff() < options.world + options.step / 2;
  };
  std::vector<SE2> poses = {SE2()};
  while (static_cast<int>(poses.size()) < options.poses) {
    const double chance = noise.uniform(0, 1);
    double turn = chance < 0.08 ? quarter : chance < 0.16 ? -quarter : 0;
    for (int tries = 0; tries < 4; ++tries, turn += quarter) {
      const SE2 next = poses.back() * SE2(0, 0, turn) * SE2(options.step, 0, 0);
      if (!stays_inside(next)) continue;
      poses.push_back(next);
      break;
    }
  }
  return poses;
}

bool sees(const SimulationOptions& options, const Vector2& point) {
  return point.norm() <= options.range && std::abs(std::atan2(point.y(), point.x())) <= options.opening;
}

}  // namespace

double Noise::uniform(double low, double high) {
  return low + (high - low) * (_engine() + 0.5) / 4294967296.0;
}

double Noise::normal(double standard_deviation) {
  const double radius = std::sqrt(-2 * std::log(uniform(0, 1)));
  return standard_deviation * radius * std::cos(uniform(0, 2 * const_pi()));
}

Simulation simulate(const SimulationOptions& options) {
  Noise noise(options.seed);
  Simulation world;
  world.poses = drive(options, noise);
  for (int i = 0; i < options.landmarks; ++i) {
    const double x = noise.uniform(-options.world, options.world);
    world.landmarks.emplace_back(x, noise.uniform(-options.world, options.world));
  }
  for (int i = 0; i + 1 < static_cast<int>(world.poses.size()); ++i) {
    const SE2 motion = world.poses[i].inverse() * world.poses[i + 1];
    const double x = noise.normal(options.odometry_noise), y = noise.normal(options.odometry_noise);
    world.odometry.push_back({i, i + 1, motion * SE2(x, y, noise.normal(options.turn_noise))});
  }
  for (int i = 0; i < static_cast<int>(world.poses.size()); ++i) {
    const SE2 sensor = world.poses[i] * options.sensor_offset;
    for (int l = 0; l < static_cast<int>(world.landmarks.size()); ++l) {
      const Vector2 seen = sensor.inverse() * world.landmarks[l];
      if (!sees(options, seen)) continue;
      const double x = noise.normal(options.landmark_noise), y = noise.normal(options.landmark_noise);
      world.observations.push_back({i, l, seen + Vector2(x, y)});
    }
  }
  const auto information = [](double deviation) { return 1 / square(std::max(deviation, 1e-3)); };
  world.odometry_information = Vector3(information(options.odometry_noise),
                                       information(options.odometry_noise), information(options.turn_noise))
                                   .asDiagonal();
  world.landmark_information = Matrix2::Identity() * information(options.landmark_noise);
  return world;
}

}  // namespace tutorial
}  // namespace g2o
