// SPDX-License-Identifier: BSD-3-Clause
// A drone flies through rooms, and a sensor on it sees the walls, or the edges where walls meet. Nobody
// measured how the sensor is mounted: its pose on the drone is estimated along with the flight and the map.
#include <boxplus/boxplus.h>
#include <boxplus/testing/simulate.h>
#include <boxplus/types/slam3d.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

/// The sensor is the third vertex of what it observes.
VertexHandle<SE3> find_sensor(const Graph& graph, const Simulation& simulation,
                              const std::vector<EdgeRef>& edges) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (simulation.kinds[k] == EdgeKind::kRecognition) return graph.typed<SE3>(graph.vertices(edges[k])[2]);
  }
  throw InvalidArgument("the simulated sensor sees nothing");
}

/// Maps the rooms with an unknown sensor pose. Says whether the result is as near to the truth as its
/// covariance says.
bool calibrate(World world, const char* landmarks) {
  Simulation simulation = simulate(world, {.poses = 300, .seed = 3});
  Graph& graph = simulation.graph;
  const auto sensor = find_sensor(graph, simulation, simulation.edges);
  const SE3 truth =
      simulation.truth.estimate(find_sensor(simulation.truth, simulation, simulation.truth_edges));

  graph.unfix(sensor);  // in the world of lines, it is a parameter, which is fixed at first
  graph.set_estimate(sensor, SE3());
  const Report report = optimize(graph);

  Vector<double, 6> error;  // the position, and the vector part of a quaternion, which is half the angle
  Manifold<SE3>::ominus(graph.estimate(sensor), truth, error.data());
  const double distance = error.head<3>().norm(), degrees = 2 * error.tail<3>().norm() * 180 / kPi;
  const Vector3 place = graph.estimate(sensor).translation();
  std::printf(
      "%s: the sensor is at (%.3f, %.3f, %.3f) m; error %.1f mm (%.0f mm at the start), %.3f degrees\n",
      landmarks, place.x(), place.y(), place.z(), 1000 * distance, 1000 * truth.translation().norm(),
      degrees);

  const Eigen::MatrixXd covariance_of_sensor = covariance(graph, {sensor}).of(sensor);
  const double distance2 = error.dot(covariance_of_sensor.ldlt().solve(error));
  std::printf(
      "  %u edges, chi2 per degree of freedom %.3f; squared error in standard deviations %.1f (6 expected)\n",
      report.edges, report.chi2_per_degree(), distance2);
  const double surely_below = 22.5;  // chi2 of 6 degrees of freedom is larger in one of 1000 cases
  return report.converged() && distance < 0.05 && degrees < 0.3 &&
         std::abs(report.chi2_per_degree() - 1) < 0.1 && distance2 < surely_below;
}

int main() {
  const bool planes = calibrate(World::kPlanes, "planes");
  const bool lines = calibrate(World::kLines, "lines");
  return planes && lines ? 0 : 1;
}
