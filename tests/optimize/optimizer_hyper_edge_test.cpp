// SPDX-License-Identifier: BSD-3-Clause
// Edges over three vertices, edges over any number of vertices, and vertices of run-time size.
#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

/// A robot that drives arcs. Its wheel factors are estimated along with its trajectory.
struct Calibration {
  Graph graph;
  VertexHandle<DifferentialDrive> wheels;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<SE2> truth;

  Calibration(const DifferentialDrive& true_wheels, const DifferentialDrive& guess) {
    wheels = graph.add_vertex(guess);
    truth.push_back(SE2());
    poses.push_back(graph.add_vertex(SE2()));
    graph.fix(poses[0]);
    for (int i = 0; i < 40; ++i) {
      const WheelOdometry odometry(
          WheelSpeeds{1 + 0.3 * std::sin(0.7 * i), 1 + 0.3 * std::cos(0.4 * i), 0.5});
      truth.push_back(truth.back() * odometry.motion(true_wheels));
      poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * odometry.motion(guess)));
      graph.add_edge(odometry, 100.0, poses[poses.size() - 2], poses.back(), wheels);
      graph.add_edge(Between(truth[truth.size() - 2].inverse() * truth.back()), 100.0,
                     poses[poses.size() - 2], poses.back());
    }
  }
};

TEST(HyperEdge, FindsTheWheelCalibrationAlongWithTheTrajectory) {
  const DifferentialDrive true_wheels{1.05, 0.97, 0.52};
  Calibration problem(true_wheels, DifferentialDrive{1, 1, 0.5});
  const Report report = optimize(problem.graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LT(report.chi2_final, 1e-18);
  const DifferentialDrive found = problem.graph.estimate(problem.wheels);
  EXPECT_NEAR(found.left_factor, true_wheels.left_factor, 1e-9);
  EXPECT_NEAR(found.right_factor, true_wheels.right_factor, 1e-9);
  EXPECT_NEAR(found.baseline, true_wheels.baseline, 1e-9);
}

/// Measures the mean of any number of scalars.
struct MeanOf {
  double z;
  template <class S>
  S error(std::span<const Vector<S, 1>> x) const {
    S sum(0.0);
    for (const auto& v : x) sum += v[0];
    return sum / static_cast<double>(x.size()) - z;
  }
};

TEST(HyperEdge, OverARangeConnectsAnyNumberOfVertices) {
  Graph graph;
  std::vector<VertexHandle<Vector<double, 1>>> all;
  for (int i = 0; i < 50; ++i) {
    all.push_back(graph.add_vertex(Vector<double, 1>(i)));
    graph.add_edge([i](const auto& x) { return x[0] - static_cast<double>(i); }, all.back());
  }
  graph.add_edge(MeanOf{30}, 1e6, all);
  graph.add_edge(MeanOf{7}, 1e6, std::vector{all[3], all[4]});
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  double mean = 0;
  for (const auto& v : all) mean += graph.estimate(v)[0] / 50;
  EXPECT_NEAR(mean, 30, 1e-2);
  EXPECT_NEAR(graph.estimate(all[3])[0] + graph.estimate(all[4])[0], 14, 1e-4);
}

/// A sample y of a polynomial at t. The coefficients of the polynomial are one vertex of run-time size.
struct PolynomialSample {
  double t, y;
  template <class S>
  S error(const Vector<S, kDynamic>& coefficients) const {
    S value(0.0);
    for (auto k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
    return value - y;
  }
};

TEST(RunTimeSizeVertex, FindsThePolynomialThatFitsTheSamples) {
  for (int degree = 1; degree < 7; ++degree) {
    Graph graph;
    const auto polynomial = graph.add_vertex(Vector<double, kDynamic>(Eigen::VectorXd::Zero(degree + 1)));
    for (int i = 0; i < 30; ++i) {
      const double t = -1 + i / 15.0;
      double y = 0;
      for (int k = degree; k >= 0; --k) y = y * t + (k + 1);
      graph.add_edge(PolynomialSample{t, y}, polynomial);
    }
    const Report report = optimize(graph);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_TRUE(report.gauge.held.empty());
    for (int k = 0; k <= degree; ++k) EXPECT_NEAR(graph.estimate(polynomial)[k], k + 1, 1e-8);
  }
}

TEST(HyperEdge, ObservesARangeOfManyLandmarksFromOnePose) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2(0.1, -0.2, 0.1));
  const SE2 truth(0.5, 0.3, -0.4);
  std::vector<VertexHandle<Vector2>> landmarks;
  Vector<double, kDynamic> seen(24);
  for (int i = 0; i < 12; ++i) {
    const Vector2 at(std::cos(i), 2 * std::sin(2 * i));
    landmarks.push_back(graph.add_vertex(at));
    graph.fix(landmarks.back());
    seen.segment<2>(2 * i) = truth.inverse() * at;
  }
  graph.add_edge(PointsObservation2(seen), pose, landmarks);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LT((graph.estimate(pose).vector() - truth.vector()).norm(), 1e-9);
}

}  // namespace
}  // namespace boxplus
