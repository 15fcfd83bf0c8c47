// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "boxplus/types/slam3d.h"
#include "testing/simulator.h"
#include "testing/turned.h"
#include "testing/worlds.h"

namespace boxplus {
namespace {

/// The number of laps for about `poses` poses, if a lap has as many poses as there are laps.
int laps_for(int poses) {
  return std::max(2, static_cast<int>(std::lround(std::sqrt(static_cast<double>(poses)))));
}

}  // namespace

Simulation simulate_sphere(const SimulationOptions& options) {
  constexpr double kRadius = 50;
  const int laps = laps_for(options.poses), per_lap = laps, count = laps * per_lap;
  Simulator<SE3> simulator(options, {0.05, 0.02});
  for (int k = 0; k < count; ++k) {
    const double longitude = 2 * kPi * k / per_lap, latitude = kPi * ((k + 0.5) / count - 0.5);
    const SE3 turn = turned(Vector3(0, 0, 1), longitude) * turned(Vector3(0, 1, 0), -latitude);
    simulator.drive_to(turn * SE3(Vector3(kRadius, 0, 0), detail::Quaternion<double>::identity()));
    if (k >= per_lap) simulator.recognize(k - per_lap, k);
  }
  return simulator.take();
}

Simulation simulate_torus(const SimulationOptions& options) {
  constexpr double kMajorRadius = 40, kMinorRadius = 15;
  const int laps = laps_for(options.poses), per_lap = laps, count = laps * per_lap;
  Simulator<SE3> simulator(options, {0.05, 0.02});
  for (int k = 0; k < count; ++k) {
    const double around = 2 * kPi * k / count, tube = 2 * kPi * k / per_lap;
    const SE3 ring = turned(Vector3(0, 0, 1), around) *
                     SE3(Vector3(kMajorRadius, 0, 0), detail::Quaternion<double>::identity());
    simulator.drive_to(ring * turned(Vector3(0, 1, 0), tube) *
                       SE3(Vector3(kMinorRadius, 0, 0), detail::Quaternion<double>::identity()));
    if (k >= per_lap) simulator.recognize(k - per_lap, k);
    if (k >= count - per_lap) simulator.recognize(k - (count - per_lap), k);
  }
  return simulator.take();
}

Simulation simulate_grid(const SimulationOptions& options) {
  const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(options.poses)))));
  Simulator<SE3> simulator(options, {0.03, 0.02});
  std::vector<int> pose_at(static_cast<std::size_t>(side * side * side), -1);
  const auto at = [&](int x, int y, int z) -> int& { return pose_at[(z * side + y) * side + x]; };
  for (int k = 0; k < side * side * side; ++k) {  // there and back, line by line and floor by floor
    const int line = k / side, z = k / (side * side);
    const int y = z % 2 == 0 ? line % side : side - 1 - line % side;
    const int x = line % 2 == 0 ? k % side : side - 1 - k % side;
    const double heading = line % 2 == 0 ? 0 : kPi;
    simulator.drive_to(SE3(Vector3(x, y, z), turned(Vector3(0, 0, 1), heading).quaternion()));
    at(x, y, z) = k;
    if (y > 0 && at(x, y - 1, z) >= 0 && at(x, y - 1, z) != k - 1) simulator.recognize(at(x, y - 1, z), k);
    if (y + 1 < side && at(x, y + 1, z) >= 0 && at(x, y + 1, z) != k - 1)
      simulator.recognize(at(x, y + 1, z), k);
    if (z > 0 && at(x, y, z - 1) != k - 1) simulator.recognize(at(x, y, z - 1), k);
  }
  return simulator.take();
}

}  // namespace boxplus
