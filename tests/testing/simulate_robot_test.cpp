// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_robot.h"

#include <gmock/gmock.h>

#include <set>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

/// The rows of the errors that have a weight, over the edges with a vertex that may move. Sensors such as a
/// compass weight only some of their rows.
double weighted_rows(const Graph& graph) {
  double rows = 0;
  for (const EdgeRef& edge : graph.all_edges()) {
    bool is_active = false;
    for (const VertexRef& vertex : graph.vertices(edge)) is_active = is_active || !graph.is_fixed(vertex);
    if (!is_active) continue;
    const Eigen::MatrixXd omega = graph.information(edge).matrix();
    for (Eigen::Index i = 0; i < omega.rows(); ++i) rows += omega(i, i) > 0;
  }
  return rows;
}

/// Requires that chi2 at the optimum is that of a χ² variable: its mean is the number of degrees of freedom,
/// n, and its standard deviation is √(2n).
void expect_chi2_in_its_band(Graph& graph, const std::string& what) {
  const Report report = optimize(graph, {.start = Start::kAutomatic});
  EXPECT_TRUE(report.converged()) << what << ": " << report.message;
  const double freedom = weighted_rows(graph) - report.scalars;
  EXPECT_GT(freedom, 30) << what;
  EXPECT_NEAR(report.chi2_final, freedom, 5 * std::sqrt(2 * freedom)) << what;
}

/// The options for a sensor, with enough of what it sees.
PlaneRobotOptions with(std::vector<PlaneSensor> sensors) {
  return {.poses = 300, .world_size = 15, .sensors = std::move(sensors), .landmarks = 60, .seed = 3};
}
SpaceRobotOptions with(std::vector<SpaceSensor> sensors) {
  return {.poses = 300, .world_size = 15, .sensors = std::move(sensors), .landmarks = 150, .seed = 3};
}

template <class Sensors>
void expect_that_each_sensor_is_consistent(const Sensors& all) {
  using Sensor = typename Sensors::value_type;
  for (const Sensor sensor : all) {
    Simulation simulation = simulate_robot(with(std::vector<Sensor>{sensor}));
    const std::size_t odometry = 299;
    EXPECT_GT(simulation.edges.size(), odometry + 90) << to_string(sensor);
    expect_chi2_in_its_band(simulation.graph, std::string(to_string(sensor)));
  }
  Simulation simulation = simulate_robot(with(std::vector<Sensor>(all.begin(), all.end())));
  expect_chi2_in_its_band(simulation.graph, "all sensors");
}

TEST(SimulateRobot, EachSensorInThePlaneReachesAChi2InItsBand) {
  expect_that_each_sensor_is_consistent(kPlaneSensors);
}

TEST(SimulateRobot, EachSensorInSpaceReachesAChi2InItsBand) {
  expect_that_each_sensor_is_consistent(kSpaceSensors);
}

template <class Sensors>
void expect_the_truth_without_noise(const Sensors& all) {
  using Sensor = typename Sensors::value_type;
  auto options = with(std::vector<Sensor>(all.begin(), all.end()));
  options.noise = 0;
  const Simulation simulation = simulate_robot(options);
  EXPECT_LT(simulation.truth.chi2(), 1e-9);
  EXPECT_LT(simulation.graph.chi2(), 1e-9);
}

TEST(SimulateRobot, WithoutNoiseTheEstimatesAreTheTruth) {
  expect_the_truth_without_noise(kPlaneSensors);
  expect_the_truth_without_noise(kSpaceSensors);
}

TEST(SimulateRobot, SegmentsInPartHaveTheirOwnEdges) {
  const Simulation simulation = simulate_robot(with({PlaneSensor::kSegments}));
  std::set<std::string_view> types;
  for (const auto& pool : simulation.graph.edge_pools()) types.insert(pool->type_name());
  for (const char* type : {"SegmentObservation2", "SegmentEndObservation2", "SegmentLineObservation2"})
    EXPECT_EQ(types.count(type), 1u) << type;
}

TEST(SimulateRobot, TheSameOptionsGiveTheSameGraphAndAnotherSeedAnotherOne) {
  auto options = with({PlaneSensor::kPoints, PlaneSensor::kBearings, PlaneSensor::kSegments});
  const auto text = [&] { return format_graph(simulate_robot(options).graph); };
  const std::string first = text();
  EXPECT_EQ(first, text());
  options.seed = 4;
  EXPECT_NE(first, text());
}

TEST(SimulateRobot, TheWorldDoesNotDependOnTheSensors) {
  const Simulation a = simulate_robot(with({SpaceSensor::kGps})),
                   b = simulate_robot(with({SpaceSensor::kPoints, SpaceSensor::kPoses}));
  const auto poses = [](const Graph& graph) {
    std::vector<Vector3> places;
    for (const VertexRef& vertex : graph.all_vertices()) {
      if (graph.tangent_dim(vertex) == 6)
        places.push_back(graph.estimate(graph.typed<SE3>(vertex)).translation());
    }
    return places;
  };
  EXPECT_EQ(poses(a.truth), poses(b.truth));
}

TEST(SimulateRobot, WithoutOdometryOnlyItsEdgesAreMissing) {
  auto options = with({PlaneSensor::kPoints});
  const Simulation with_odometry = simulate_robot(options);
  options.has_odometry = false;
  const Simulation without = simulate_robot(options);
  EXPECT_EQ(without.edges.size() + 299, with_odometry.edges.size());
  EXPECT_THAT(without.kinds, testing::Each(EdgeKind::kRecognition));
}

TEST(SimulateRobot, OutliersAreFarFromTheTruthAndOdometryIsNever) {
  auto options = with({PlaneSensor::kPoints, PlaneSensor::kSegments, PlaneSensor::kPoses});
  options.outliers = 0.2;
  const Simulation simulation = simulate_robot(options);
  double outliers = 0, recognitions = 0;
  for (std::size_t k = 0; k < simulation.edges.size(); ++k) {
    recognitions += simulation.kinds[k] != EdgeKind::kOdometry;
    if (simulation.kinds[k] != EdgeKind::kOutlier) continue;
    ++outliers;
    EXPECT_GT(simulation.truth.chi2(simulation.truth_edges[k]), 100);
  }
  EXPECT_NEAR(outliers, 0.2 * recognitions, 0.05 * recognitions);
}

TEST(SimulateRobot, RefusesInvalidOptions) {
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.poses = 1}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.world_size = 3}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.landmarks = -1}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.segments = -1}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.segment_grid = 0}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.min_segment_length = 0}), InvalidArgument);
  EXPECT_THROW(simulate_robot(PlaneRobotOptions{.max_segment_length = 0.1}), InvalidArgument);
  EXPECT_THROW(simulate_robot(SpaceRobotOptions{.outliers = 1.5}), InvalidArgument);
  EXPECT_THROW(simulate_robot(SpaceRobotOptions{.noise = std::nan("")}), InvalidArgument);
  EXPECT_THROW(simulate_laps({.laps = 0}), InvalidArgument);
  EXPECT_THROW(simulate_laps({.poses_per_lap = 1}), InvalidArgument);
  EXPECT_THROW(simulate_laps({.radius = 0}), InvalidArgument);
  EXPECT_THROW(simulate_laps({.rotation_noise = Vector3(0.1, 0, 0.1)}), InvalidArgument);
}

TEST(SimulateLaps, PosesAreOnASphereWithThreeClosuresEach) {
  Simulation simulation = simulate_laps({.laps = 12, .poses_per_lap = 15, .radius = 20});
  EXPECT_EQ(simulation.graph.vertex_count(), 180u);
  for (const VertexRef& vertex : simulation.truth.all_vertices())
    EXPECT_NEAR(simulation.truth.estimate(simulation.truth.typed<SE3>(vertex)).translation().norm(), 20,
                1e-12);
  EXPECT_EQ(simulation.edges.size(), 179u + 3u * 165u);
  expect_chi2_in_its_band(simulation.graph, "laps");
}

TEST(SimulateLaps, NoiseIsPerAxis) {
  const Simulation simulation = simulate_laps({.laps = 4,
                                               .poses_per_lap = 10,
                                               .translation_noise = {0.1, 0.2, 0.5},
                                               .rotation_noise = {0.01, 0.02, 0.04}});
  const Eigen::VectorXd weights = simulation.graph.information(simulation.edges[0]).matrix().diagonal();
  const std::array<double, 6> deviations{0.1, 0.2, 0.5, 0.01, 0.02, 0.04};
  for (int i = 0; i < 6; ++i) {
    const double deviation = deviations[static_cast<std::size_t>(i)];
    EXPECT_NEAR(weights[i] * deviation * deviation, 1, 1e-12);
  }
}

}  // namespace
}  // namespace boxplus
