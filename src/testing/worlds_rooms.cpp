// SPDX-License-Identifier: BSD-3-Clause
// A drone that flies to and fro through a row of rooms, and sees planes or lines. The row is short, because
// an error in the direction of a line moves a far line a long way.
#include <algorithm>
#include <cmath>

#include "boxplus/types/slam3d.h"
#include "testing/simulator.h"
#include "testing/turned.h"
#include "testing/worlds.h"

namespace boxplus {
namespace {

/// Room k reaches from x = partition(k) to x = partition(k + 1).
constexpr int kRooms = 5;
constexpr double kLength = 8, kHalfWidth = 4, kFloor = -1.5, kCeiling = 2.5;

double partition(int k) {
  return (k - 0.5 * kRooms) * kLength;
}

/// Flies to the last room and back, again and again, and calls `arrive(room)` at each pose.
template <class Arrive>
void fly(Simulator<SE3>& simulator, const SimulationOptions& options, Arrive&& arrive) {
  constexpr double kMargin = 1, kDistance = kRooms * kLength - 2 * kMargin, kStep = 0.4;
  for (int k = 0; k < options.poses; ++k) {
    const double traveled = k * kStep, in_round = std::fmod(traveled, 2 * kDistance);
    const bool returns = in_round > kDistance;
    const double x = partition(0) + kMargin + (returns ? 2 * kDistance - in_round : in_round);
    const double sway = 2 * kPi * traveled / kLength;
    const Vector3 position(x, 1.5 * std::sin(sway / 2), 0.5 * std::sin(sway));
    const SE3 turn = turned(0, 0, returns ? kPi : 0) *
                     turned(0.3 * std::sin(sway), 0.3 * std::cos(1.3 * sway), 0.5 * std::sin(0.7 * sway));
    simulator.drive_to(SE3(position, turn.quaternion()));
    arrive(std::clamp(static_cast<int>((x - partition(0)) / kLength), 0, kRooms - 1));
  }
}

/// A number near 0, so that no two walls are parallel.
double tilt(RandomNumbers& random) {
  return random.uniform(-0.1, 0.1);
}

/// The plane through the point p, whose normal points along the axis or against it, but is tilted.
Plane3 wall(const Vector3& p, int axis, double sign, RandomNumbers& random) {
  Vector3 n(tilt(random), tilt(random), tilt(random));
  n[axis] = sign;
  n.normalize();
  return {Vector<double, 4>(n[0], n[1], n[2], -n.dot(p))};
}

Line3 edge(const Vector3& p, int axis, RandomNumbers& random) {
  Vector3 d(tilt(random), tilt(random), tilt(random));
  d[axis] = 1;
  return Line3::through(p, d.normalized());
}

/// Moves a point by independent steps with these standard deviations.
template <class T, int N>
T moved(const T& x, const Vector<double, N>& deviations, double factor, RandomNumbers& random) {
  Vector<double, N> step;
  for (int i = 0; i < N; ++i) step[i] = factor * deviations[i] * random.normal();
  return Manifold<T>::oplus(x, step.data());
}

/// The pose of the sensor on the drone.
const SE3& mounting() {
  static const SE3 pose(Vector3(0.2, 0.1, 0.3), turned(0.1, 0.2, -0.1).quaternion());
  return pose;
}

}  // namespace

/// The pose of the sensor is a vertex, too.
Simulation simulate_planes(const SimulationOptions& options) {
  const Vector3 deviations(0.01, 0.01, 0.03);  // azimuth, elevation, distance
  Simulator<SE3> simulator(options, {0.01, 0.002});
  RandomNumbers& random = simulator.random;
  Vector<double, 6> uncertain;
  uncertain << 0.05, 0.05, 0.05, 0.01, 0.01, 0.01;
  const Twin<SE3> sensor =
      simulator.add_vertex(mounting(), moved(mounting(), uncertain, options.noise, random));
  Landmarks<Plane3> planes;
  std::vector<std::array<int, 4>> sides;  // of each room
  std::vector<int> partitions;
  for (int k = 0; k <= kRooms; ++k)
    partitions.push_back(planes.add(wall({partition(k), 0, 0}, 0, -1, random)));
  for (int k = 0; k < kRooms; ++k) {
    const double x = partition(k) + 0.5 * kLength;
    sides.push_back({planes.add(wall({x, -kHalfWidth, 0}, 1, 1, random)),
                     planes.add(wall({x, kHalfWidth, 0}, 1, -1, random)),
                     planes.add(wall({x, 0, kFloor}, 2, 1, random)),
                     planes.add(wall({x, 0, kCeiling}, 2, -1, random))});
  }
  const auto observe = [&](int index) {
    const SE3 place = simulator.truth(simulator.size() - 1) * mounting();
    const Plane3 seen = moved(planes.truth(index).seen_from(place), deviations, options.noise, random);
    const Plane3 guess = seen.seen_from((simulator.last_guess() * simulator.guess(sensor)).inverse());
    simulator.observe(planes, index, PlaneObservation3(seen), deviations, guess, sensor);
  };
  fly(simulator, options, [&](int room) {
    const auto k = static_cast<std::size_t>(room);
    observe(partitions[k]);
    observe(partitions[k + 1]);
    for (const int side : sides[k]) observe(side);
  });
  return simulator.take();
}

/// The pose of the sensor is a parameter.
Simulation simulate_lines(const SimulationOptions& options) {
  const Vector<double, 4> deviations(0.005, 0.005, 0.005, 0.002);  // half angles, and φ
  Simulator<SE3> simulator(options, {0.01, 0.002});
  RandomNumbers& random = simulator.random;
  const Twin<SE3> sensor = simulator.add_parameter(mounting());
  Landmarks<Line3> lines;
  std::vector<std::array<int, 4>> partitions, rails;  // between rooms, and along each room
  for (int k = 0; k <= kRooms; ++k) {
    const double x = partition(k);
    partitions.push_back(
        {lines.add(edge({x, -kHalfWidth, 0}, 2, random)), lines.add(edge({x, kHalfWidth, 0}, 2, random)),
         lines.add(edge({x, 0, kFloor}, 1, random)), lines.add(edge({x, 0, kCeiling}, 1, random))});
  }
  for (int k = 0; k < kRooms; ++k) {
    const double x = partition(k) + 0.5 * kLength;
    rails.push_back({lines.add(edge({x, -kHalfWidth, kFloor}, 0, random)),
                     lines.add(edge({x, kHalfWidth, kFloor}, 0, random)),
                     lines.add(edge({x, -kHalfWidth, kCeiling}, 0, random)),
                     lines.add(edge({x, kHalfWidth, kCeiling}, 0, random))});
  }
  const auto observe = [&](int index) {
    const SE3 place = simulator.truth(simulator.size() - 1) * mounting();
    const Line3 seen = moved(lines.truth(index).seen_from(place), deviations, options.noise, random);
    const Line3 guess = seen.seen_from((simulator.last_guess() * mounting()).inverse());
    simulator.observe(lines, index, LineObservation3(seen), deviations, guess, sensor);
  };
  fly(simulator, options, [&](int room) {
    const auto k = static_cast<std::size_t>(room);
    for (const auto* edges : {&partitions[k], &partitions[k + 1], &rails[k]}) {
      for (const int line : *edges) observe(line);
    }
  });
  return simulator.take();
}

}  // namespace boxplus
