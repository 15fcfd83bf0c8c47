// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "boxplus/types/slam3d.h"
#include "testing/robot_options.h"
#include "testing/simulator.h"
#include "testing/turned.h"

namespace boxplus {
namespace {

SE3 pose_on_sphere(const SphereOptions& options, int k) {
  const double count = static_cast<double>(options.laps) * options.poses_per_lap;
  const double longitude = 2 * kPi * (k % options.poses_per_lap) / options.poses_per_lap - kPi;
  const double latitude = kPi * (k / count - 0.5);
  const SE3 turn = turned(Vector3(0, 0, 1), longitude) * turned(Vector3(0, 1, 0), latitude);
  return turn * SE3(Vector3(options.radius, 0, 0), detail::Quaternion<double>::identity());
}

}  // namespace

Simulation simulate_laps(const SphereOptions& options) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  require_option(options.laps >= 1, "at least one lap", options.laps);
  require_option(options.poses_per_lap >= 2, "at least two poses per lap", options.poses_per_lap);
  require_option(positive(options.radius), "a radius > 0", options.radius);
  RowNoise<6> noise;
  noise.deviations << options.translation_noise, options.rotation_noise;
  for (const double deviation : noise.deviations)
    require_option(positive(deviation), "standard deviations > 0", deviation);

  const int per_lap = options.poses_per_lap, count = options.laps * per_lap;
  Simulator<SE3> simulator({.poses = count, .seed = options.seed}, noise);
  for (int k = 0; k < count; ++k) {
    simulator.drive_to(pose_on_sphere(options, k));
    // The neighbor after it is the previous pose of this pose's lap if there are only two poses per lap.
    for (const int neighbor : {k - per_lap - 1, k - per_lap, k - per_lap + 1}) {
      if (neighbor >= 0 && neighbor < k - 1) simulator.recognize(neighbor, k);
    }
  }
  return simulator.take();
}

}  // namespace boxplus
