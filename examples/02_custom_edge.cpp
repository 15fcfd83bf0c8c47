// SPDX-License-Identifier: BSD-3-Clause
// A custom edge type: a robot measures its distance from three beacons, and the program estimates the
// position of the robot.
//
// An edge is an object whose function error(…) computes the error from the estimates of its vertices. If this
// function is a template over the types of its arguments, boxplus differentiates it automatically and
// exactly, so you need not write Jacobians.
#include <boxplus/boxplus.h>
#include <boxplus/testing/check_jacobians.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

// [edge]
/// The distance (meters) of a point from a beacon at a known position.
struct BeaconRange {
  Vector2 beacon;
  double measurement;

  template <class Point>
  auto error(const Point& point) const {
    return (point - beacon).norm() - measurement;
  }
};
// [/edge]

bool jacobians_are_right() {
  // [check_jacobians]
  const JacobianCheck check = check_jacobians(BeaconRange{Vector2(10, 0), 8}, Vector2(1, 2));
  if (!check.ok) std::printf("%s\n", check.message.c_str());
  // [/check_jacobians]
  return check.ok;
}

int main() {
  // [graph]
  Graph graph;
  const auto robot = graph.add_vertex(Vector2(0, 0));  // a rough initial guess is good enough

  const double sigma = 0.05;                       // the standard deviation of the measurements, in meters
  const double information = 1 / (sigma * sigma);  // the inverse of the variance of the measurements
  graph.add_edge(BeaconRange{Vector2(10, 0), 8.02}, information, robot);
  graph.add_edge(BeaconRange{Vector2(0, 10), 9.26}, information, robot);
  graph.add_edge(BeaconRange{Vector2(-5, -5), 9.21}, information, robot);

  const Report report = optimize(graph);
  const Vector2 found = graph.estimate(robot);
  std::printf("%s: the robot is at (%.3f, %.3f), chi2 %.3f\n", report.converged() ? "converged" : "stopped",
              found.x(), found.y(), report.chi2_final);
  // [/graph]

  // [lambda]
  // The robot stands on the road y = x / 2.
  graph.add_edge([](const auto& point) { return point.y() - 0.5 * point.x(); }, 1e6, robot);
  if (!optimize(graph).converged()) return 1;
  // [/lambda]
  const Vector2 on_road = graph.estimate(robot);
  std::printf("on the road it is at (%.3f, %.3f)\n", on_road.x(), on_road.y());

  const bool is_near_the_truth = (found - Vector2(2, 1)).norm() < 0.1;
  const bool is_on_the_road = std::abs(on_road.y() - 0.5 * on_road.x()) < 1e-4;
  return report.converged() && is_near_the_truth && is_on_the_road && jacobians_are_right() ? 0 : 1;
}
