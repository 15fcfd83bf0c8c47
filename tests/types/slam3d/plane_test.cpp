// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/plane.h"

#include <gmock/gmock.h>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/check_manifold.h"
#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

Plane3 plane(double x, double y, double z, double distance) {
  return {Vector<double, 4>(x, y, z, -distance)};
}

double difference(const Plane3& a, const Plane3& b) {
  return (a.unit().coefficients - b.unit().coefficients).norm();
}

const SE3 kPose = pose(1, 2, 3, 0.3, -0.4, 0.9), kOffset = pose(0, 0.1, 0.2, 1, 1, 1);
const Plane3 kWall = plane(0.3, -0.4, 0.5, -2), kFloor = plane(0, 0, 1, 3), kCeiling = plane(0, 0, -2, 1);

TEST(Plane3, IsAManifoldAlsoIfTheNormalIsVertical) {
  const ManifoldCheck check =
      check_manifold<Plane3>({kWall, kFloor, plane(0.1, 0.2, 3, 1), kCeiling, Plane3{}});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(Plane3, TurnsItsNormalByAzimuthAndElevationAndKeepsItsColor) {
  const double step[3] = {kPi / 2, 0, 0.5};
  Plane3 wall;
  wall.color = {1, 0.5, 0};
  const Plane3 moved = Manifold<Plane3>::oplus(wall, step);
  EXPECT_LT(difference(moved, plane(0, 1, 0, 1.5)), 1e-15);
  EXPECT_EQ(moved.color[0], 1);
}

TEST(Plane3, MayHaveCoefficientsInAnyScale) {
  const Vector3 angles(0.1, 0.2, 0.3);
  const Plane3 scaled{7 * kWall.coefficients};
  EXPECT_LT(difference(Manifold<Plane3>::oplus(kWall, angles.data()),
                       Manifold<Plane3>::oplus(scaled, angles.data())),
            1e-14);
  const Vector3 a = PlaneObservation3(kWall).error(kPose, kFloor),
                b = PlaneObservation3(scaled).error(kPose, Plane3{3 * kFloor.coefficients});
  EXPECT_LT((a - b).norm(), 1e-14);
}

TEST(Plane3, ContainsTheSamePointsInEachFrame) {
  const Vector3 inside = kPose * Vector3(3, -1, 2);
  const Vector3 n = kWall.normal();
  const Plane3 through{Vector<double, 4>(n[0], n[1], n[2], -n.dot(inside))};
  const Plane3 seen = through.seen_from(kPose);
  EXPECT_NEAR(seen.normal().dot(Vector3(3, -1, 2)) + seen.coefficients[3], 0, 1e-14);
}

TEST(PlaneObservation3, MeasuresInTheFrameOfTheSensor) {
  const SE3 offset = pose(0.5, 0, 0, 0, 0, 0);
  const Plane3 seen = plane(std::cos(0.1), std::sin(0.1), 0, 1);
  const Vector3 e = PlaneObservation3(seen).error(SE3(), plane(1, 0, 0, 2), offset);
  EXPECT_LT((e - Vector3(0.1, 0, 0.5)).norm(), 1e-15);
  EXPECT_LT((PlaneObservation3(seen).error(offset, plane(1, 0, 0, 2)) - e).norm(), 1e-15);
}

TEST(PlaneDifference3, ComparesCoefficients) {
  const Vector<double, 4> e =
      PlaneDifference3(Vector<double, 4>(0, 0, 0, 3)).error(plane(1, 0, 0, 2), plane(0, 2, 0, 2));
  EXPECT_LT((e - Vector<double, 4>(-1, 1, 0, -2)).norm(), 1e-15);
}

TEST(PlaneEdges3, HaveCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const SE3 x = random_pose(random, 3), offset = random_pose(random, 1);
    const Plane3 a = random_plane(random), b = random_plane(random), z = random_plane(random);
    expect_correct_jacobians(PlaneObservation3(z), x, a, offset);
    expect_correct_jacobians(PlaneObservation3(z), x, a);
    expect_correct_jacobians(PlaneDifference3(Vector<double, 4>(1, 2, 3, 4)), a, b);
  }
}

// In the frame of the pose, the floor is vertical, so its azimuth is not defined. The measured normal is
// orthogonal to that of the wall, so its azimuth in the frame of the wall is not defined, either.
TEST(PlaneObservation3, HasFiniteJacobiansWhereAnAzimuthIsNotDefined) {
  for (const auto& [seen, measured] : {std::pair{kFloor, kFloor}, {kCeiling, kFloor}, {Plane3{}, kFloor}}) {
    Graph graph;
    const auto x = graph.add_vertex(SE3()), offset = graph.add_vertex(SE3());
    const auto p = graph.add_vertex(seen);
    graph.add_edge(PlaneObservation3(measured), x, p, offset);
    Options options;
    options.max_iterations = 1;
    const Report report = optimize(graph, options);
    EXPECT_TRUE(std::isfinite(report.chi2_final)) << report.message;
    EXPECT_NE(report.status, Report::Status::kFailed) << report.message;
  }
}

/// A room with a floor, a ceiling and walls, seen by a sensor whose pose on the body is unknown, too.
TEST(PlaneEdges3, EndAtAChi2ThatNoiseExplains) {
  SensorWorld world(5);
  std::vector<Plane3> truths{
      kFloor, kCeiling, plane(1, 0, 0, 9), plane(0.1, 1, 0, 8), plane(-1, 0.1, 0, 9), plane(0, -1, 0.2, 8)};
  const SE3 offset = pose(0.2, 0.1, 0.3, 0.1, 0.2, -0.1);
  const auto sensor = world.graph.add_vertex(offset * random_pose(world.random, 0.02));
  std::vector<VertexHandle<Plane3>> planes;
  for (const Plane3& truth : truths) {
    const Vector3 step = 0.05 * world.normal<3>();
    planes.push_back(world.graph.add_vertex(Manifold<Plane3>::oplus(truth, step.data())));
  }
  constexpr double kAngle = 0.01, kDistance = 0.03;
  const std::array<double, 3> weights{1 / (kAngle * kAngle), 1 / (kAngle * kAngle),
                                      1 / (kDistance * kDistance)};
  for (std::size_t i = 0; i < world.truths.size(); ++i) {
    for (std::size_t j = 0; j < truths.size(); ++j) {
      const Vector3 noise = world.normal<3>();
      const Vector3 step(kAngle * noise[0], kAngle * noise[1], -kDistance * noise[2]);
      const Plane3 seen = truths[j].seen_from(world.truths[i] * offset);
      world.graph.add_edge(PlaneObservation3(Manifold<Plane3>::oplus(seen, step.data())),
                           Information::diagonal(weights), world.poses[i], planes[j], sensor);
    }
  }
  for (std::size_t j = 1; j < truths.size(); ++j) {
    const Vector<double, 4> z = truths[j].unit().coefficients - truths[j - 1].unit().coefficients;
    world.graph.add_edge(PlaneDifference3(z + kDistance * world.normal<4>()), Information(weights[2]),
                         planes[j - 1], planes[j]);
  }
  expect_chi2_of_noise(world.graph);
  for (std::size_t j = 0; j < truths.size(); ++j)
    EXPECT_LT(difference(world.graph.estimate(planes[j]), truths[j]), 0.05) << j;
  EXPECT_LT((world.graph.estimate(sensor).vector() - offset.vector()).norm(), 0.05);
}

}  // namespace
}  // namespace boxplus
