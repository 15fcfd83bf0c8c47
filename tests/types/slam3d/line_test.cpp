// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/line.h"

#include <gmock/gmock.h>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/check_manifold.h"
#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

const SE3 kPose = pose(1, 2, 3, 0.3, -0.4, 0.9);
const Line3 kLine = Line3::through(Vector3(1, -2, 0.5), Vector3(0.4, 0.2, 2));

/// The length of b ⊟ a.
double distance(const Line3& a, const Line3& b) {
  Vector<double, 4> delta;
  Manifold<Line3>::ominus(b, a, delta.data());
  return delta.norm();
}

// A line beyond 10 m would pass through infinity, because the check takes steps of 0.1 in φ.
TEST(Line3, IsAManifold) {
  const ManifoldCheck check =
      check_manifold<Line3>({kLine, Line3::through(Vector3(0, 0, 5), Vector3(1, 0, 0)),
                             Line3::through(Vector3(2, 3, 1), Vector3(0, 0, -0.5))});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(Line3, KnowsItsPointNearTheOrigin) {
  const Line3 line = Line3::through(Vector3(7, 3, 0), Vector3(2, 0, 0));
  EXPECT_LT((line.nearest_point() - Vector3(0, 3, 0)).norm(), 1e-15);
}

// The last direction changes the distance from the origin, which is cot φ.
TEST(Line3, MovesAwayFromTheOriginByTheAnglePhi) {
  const Line3 line = Line3::through(Vector3(0, 3, 0), Vector3(2, 0, 0));
  const double step[4] = {0, 0, 0, std::atan(1 / 5.0) - std::atan(1 / 3.0)};
  const Line3 moved = Manifold<Line3>::oplus(line, step);
  EXPECT_LT((moved.nearest_point() - Vector3(0, 5, 0)).norm(), 1e-13);
  EXPECT_LT((moved.direction - Vector3(1, 0, 0)).norm(), 1e-15);
}

// A turn about the second column of U, which is the direction, moves the line around the origin.
TEST(Line3, TurnsByTheVectorPartOfAQuaternion) {
  const Line3 line = Line3::through(Vector3(0, 3, 0), Vector3(2, 0, 0));
  const double step[4] = {0, std::sin(kPi / 4), 0, 0};
  EXPECT_LT((Manifold<Line3>::oplus(line, step).nearest_point() - Vector3(0, 0, 3)).norm(), 1e-14);
}

TEST(Line3, MayMeetTheOrigin) {
  const Line3 line{Vector3(0, 0, 0), Vector3(0, 0, 3)};
  const Vector<double, 4> step(0.1, -0.2, 0.1, 0.3);
  const Line3 moved = Manifold<Line3>::oplus(line, step.data());
  EXPECT_NEAR(moved.nearest_point().norm(), std::tan(0.3), 1e-14);
  EXPECT_NEAR(distance(line, line), 0, 1e-15);
  EXPECT_LT(distance(Manifold<Line3>::oplus(line, Vector<double, 4>(0, 0, 0, 0).data()), line), 1e-15);
}

TEST(Line3, IgnoresAPartOfTheMomentAlongTheDirection) {
  const Line3 inexact{kLine.moment + 0.01 * kLine.direction, 5 * kLine.direction},
      exact{kLine.moment, 5 * kLine.direction};
  EXPECT_LT(distance(inexact, exact), 1e-14);
}

TEST(Line3, ContainsTheSamePointsInEachFrame) {
  const Vector3 p(3, -1, 2), d(1, 2, 2);
  const Line3 line = Line3::through(kPose * p, kPose.so3() * d);
  EXPECT_LT(distance(line.seen_from(kPose), Line3::through(p, d)), 1e-14);
}

TEST(LineObservation3, MeasuresInTheFrameOfTheSensor) {
  const SE3 body = pose(0, 1, 0, 0, 0, 0), offset = pose(0, 1, 0, 0, 0, 0);
  const Line3 line = Line3::through(Vector3(0, 3, 0), Vector3(1, 0, 0));
  const Line3 measured = Line3::through(Vector3(0, 2, 0), Vector3(1, 0, 0));
  const Vector<double, 4> e = LineObservation3(measured).error(body, line, offset);
  EXPECT_LT((e - Vector<double, 4>(0, 0, 0, std::atan(0.5) - kPi / 4)).norm(), 1e-15);
  EXPECT_LT(LineObservation3(measured).error(body, line).norm(), 1e-15);
}

TEST(LineObservation3, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const SE3 x = random_pose(random, 3), offset = random_pose(random, 1);
    const auto line = [&] { return Line3::through(2 * random_vector(random), random_vector(random)); };
    const Line3 a = line();
    // The rotation between the lines is less than π, where the sign of the quaternion changes.
    const Vector<double, 4> step(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                                 random.uniform(-0.4, 0.4), random.uniform(-0.1, 0.1));
    const LineObservation3 edge(Manifold<Line3>::oplus(a.seen_from(x * offset), step.data()));
    expect_correct_jacobians(edge, x, a, offset);
    const LineObservation3 plain(Manifold<Line3>::oplus(a.seen_from(x), step.data()));
    expect_correct_jacobians(plain, x, a);
  }
}

TEST(LineObservation3, HasFiniteJacobiansIfTheLineMeetsTheSensor) {
  Graph graph;
  const auto x = graph.add_vertex(SE3());
  const auto line = graph.add_vertex(Line3{});
  graph.add_edge(LineObservation3(kLine), x, line);
  Options options;
  options.max_iterations = 1;
  const Report report = optimize(graph, options);
  EXPECT_NE(report.status, Report::Status::kFailed) << report.message;
  EXPECT_TRUE(std::isfinite(report.chi2_final));
}

/// Lines along the walls of a hall. None meets a pose or the origin.
TEST(LineObservation3, EndsAtAChi2ThatNoiseExplains) {
  SensorWorld world(6);
  const SE3 offset = pose(0.2, 0.1, 0.3, 0.1, 0.2, -0.1);
  const auto sensor = world.graph.add_parameter(offset);
  constexpr double kHalfAngle = 0.005, kPhi = 0.004;
  const std::array<double, 4> weights{1 / (kHalfAngle * kHalfAngle), 1 / (kHalfAngle * kHalfAngle),
                                      1 / (kHalfAngle * kHalfAngle), 1 / (kPhi * kPhi)};
  std::vector<Line3> truths;
  std::vector<VertexHandle<Line3>> lines;
  for (int j = 0; j < 12; ++j) {
    const double angle = 2 * kPi * j / 12;
    const Vector3 at(9 * std::cos(angle), 9 * std::sin(angle), world.random.uniform(-2, 2));
    truths.push_back(Line3::through(at, random_vector(world.random)));
    const Vector<double, 4> step = 0.03 * world.normal<4>();
    lines.push_back(world.graph.add_vertex(Manifold<Line3>::oplus(truths.back(), step.data())));
  }
  for (std::size_t i = 0; i < world.truths.size(); ++i) {
    for (std::size_t j = 0; j < truths.size(); ++j) {
      Vector<double, 4> noise = world.normal<4>();
      noise.head<3>() *= kHalfAngle;
      noise[3] *= kPhi;
      const Line3 seen = truths[j].seen_from(world.truths[i] * offset);
      world.graph.add_edge(LineObservation3(Manifold<Line3>::oplus(seen, noise.data())),
                           Information::diagonal(weights), world.poses[i], lines[j], sensor);
    }
  }
  expect_chi2_of_noise(world.graph);
  for (std::size_t j = 0; j < truths.size(); ++j)
    EXPECT_LT(distance(world.graph.estimate(lines[j]), truths[j]), 0.02) << j;
}

}  // namespace
}  // namespace boxplus
