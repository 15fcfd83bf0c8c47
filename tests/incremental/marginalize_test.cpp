// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/marginalize.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "boxplus/incremental/smoother.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

/// Two chains of poses that see the same landmarks.
struct Plane {
  explicit Plane(unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<> noise(0, 0.02);
    const auto noisy = [&](const SE2& x) { return x * SE2(noise(random), noise(random), noise(random)); };
    for (int k = 0; k < 8; ++k)
      points.push_back(graph.add_vertex(Vector2(k + noise(random), 3 + noise(random))));
    for (int k = 0; k < 10; ++k) {
      poses.push_back(graph.add_vertex(noisy(SE2(k, 0, 0))));
      if (k == 0) graph.add_edge(Prior(SE2()), 1e4, poses[0]);
      if (k > 0) graph.add_edge(Between(noisy(SE2(1, 0, 0))), 2500.0, poses[poses.size() - 2], poses.back());
      for (int p = std::max(0, k - 1); p < std::min(8, k + 2); ++p) {
        const auto edge = graph.add_edge(PointObservation2(Vector2(p - k + noise(random), 3 + noise(random))),
                                         400.0, poses.back(), points[static_cast<std::size_t>(p)]);
        if (p % 3 == 0) graph.set_kernel(edge, Huber(1.0));
      }
    }
  }
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> points;
};

Options exact() {
  Options options{.threads = 1};
  options.noise_tolerance = 0;
  options.cost_tolerance = 1e-14;
  return options;
}

TEST(Marginalize, KeepsTheOptimumAndTheCovarianceOfTheOtherVertices) {
  Plane all, rest;
  EXPECT_TRUE(optimize(all.graph, exact()).converged());
  EXPECT_TRUE(optimize(rest.graph, exact()).converged());
  const auto prior = marginalize(rest.graph, {rest.poses[0], rest.poses[1], rest.points[0]});
  ASSERT_TRUE(prior.has_value());
  EXPECT_FALSE(rest.graph.contains(rest.poses[1]));
  EXPECT_EQ(rest.graph.vertex_count(), all.graph.vertex_count() - 3);
  const Report report = optimize(rest.graph, exact());
  EXPECT_TRUE(report.converged());
  EXPECT_TRUE(report.gauge.held.empty());
  Optimizer of_all(all.graph, exact()), of_rest(rest.graph, exact());
  EXPECT_TRUE(of_all.run().converged());
  EXPECT_TRUE(of_rest.run().converged());
  for (std::size_t k = 2; k < all.poses.size(); ++k) {
    const SE2 difference = all.graph.estimate(all.poses[k]).inverse() * rest.graph.estimate(rest.poses[k]);
    EXPECT_LT(difference.translation().norm(), 1e-6) << k;
    const Eigen::MatrixXd expected = of_all.covariance(std::vector<VertexRef>{all.poses[k]}).of(all.poses[k]);
    const Eigen::MatrixXd actual =
        of_rest.covariance(std::vector<VertexRef>{rest.poses[k]}).of(rest.poses[k]);
    EXPECT_LT((expected - actual).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff()) << k;
  }
}

TEST(Marginalize, GivesAPriorWhoseJacobianIsTheDerivativeOfItsError) {
  Graph graph;
  const auto a = graph.add_vertex(SE3()), b = graph.add_vertex(SE3(Eigen::Vector3d(1, 2, 3), SO3())),
             c = graph.add_vertex(SE3(Eigen::Vector3d(2, 2, 2), SO3()));
  graph.fix(c);
  graph.add_edge(Between(SE3(Eigen::Vector3d(1, 2, 3), SO3())), 1.0, a, b);
  graph.add_edge(Between(SE3(Eigen::Vector3d(2, 2, 2), SO3())), 1.0, a, c);
  const auto prior = marginalize(graph, {a});
  ASSERT_TRUE(prior.has_value());
  const double delta[6] = {0.3, -0.2, 0.1, 0.2, 0.1, -0.3};
  graph.set_estimate(b, Manifold<SE3>::oplus(graph.estimate(b), delta));
  const Eigen::MatrixXd jacobian = graph.jacobian(*prior)[0];
  const SE3 here = graph.estimate(b);
  for (int i = 0; i < 6; ++i) {
    constexpr double kStep = 1e-6;
    double step[6] = {};
    step[i] = kStep;
    graph.set_estimate(b, Manifold<SE3>::oplus(here, step));
    const std::vector<double> plus = graph.error(*prior);
    step[i] = -kStep;
    graph.set_estimate(b, Manifold<SE3>::oplus(here, step));
    const std::vector<double> minus = graph.error(*prior);
    for (std::size_t r = 0; r < plus.size(); ++r)
      EXPECT_NEAR(jacobian(static_cast<Eigen::Index>(r), i), (plus[r] - minus[r]) / (2 * kStep), 1e-6);
  }
}

TEST(Marginalize, LeavesACopyOfTheGraphAlone) {
  Plane plane;
  EXPECT_TRUE(optimize(plane.graph, exact()).converged());
  ASSERT_TRUE(marginalize(plane.graph, {plane.poses[0]}).has_value());
  const Graph copy = plane.graph;
  const double chi2 = copy.chi2();
  ASSERT_TRUE(marginalize(plane.graph, {plane.poses[1]}).has_value());
  plane.graph.set_estimate(plane.poses[2], SE2(9, 9, 1));
  EXPECT_DOUBLE_EQ(copy.chi2(), chi2);
}

TEST(Marginalize, RefusesFixedAndRepeatedVerticesAndErrorsThatAreNotFinite) {
  Plane plane;
  plane.graph.fix(plane.poses[3]);
  EXPECT_THROW(marginalize(plane.graph, {plane.poses[3]}), InvalidArgument);
  EXPECT_THROW(marginalize(plane.graph, {plane.poses[2], plane.poses[2]}), InvalidArgument);
  EXPECT_TRUE(plane.graph.contains(plane.poses[2]));
  const std::size_t edges = plane.graph.edge_count();
  plane.graph.set_estimate(plane.points[2], Vector2(std::nan(""), 0));
  EXPECT_THROW(marginalize(plane.graph, {plane.poses[2]}), InvalidArgument);
  EXPECT_EQ(plane.graph.edge_count(), edges);
}

TEST(Marginalize, SaysNothingAboutDirectionsThatWereNotDetermined) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(1, 0));
  const auto along = [](const Vector2& x, const Vector2& y) { return y[0] - x[0] - 1.5; };
  graph.add_edge(along, 1.0, a, b);
  EXPECT_TRUE(marginalize(graph, {a}).has_value());
  EXPECT_EQ(graph.chi2(), 0);
}

TEST(Smoother, KeepsAFixedLagOfPosesWithTheLandmarksThatTheySee) {
  std::mt19937 random(5);
  std::normal_distribution<> noise(0, 0.02);
  Graph graph, all;
  Smoother smoother(graph, {.lag = 6});
  std::vector<VertexHandle<SE2>> poses, all_poses;
  std::vector<VertexHandle<Vector2>> points, all_points;
  for (int k = 0; k < 60; ++k) {
    const SE2 measured = SE2(1, 0, 0) * SE2(noise(random), noise(random), noise(random));
    const SE2 guess = k == 0 ? SE2() : graph.estimate(poses.back()) * measured;
    poses.push_back(graph.add_vertex(guess));
    all_poses.push_back(all.add_vertex(guess));
    if (k > 0) {
      graph.add_edge(Between(measured), 2500.0, poses[poses.size() - 2], poses.back());
      all.add_edge(Between(measured), 2500.0, all_poses[all_poses.size() - 2], all_poses.back());
    }
    points.push_back(graph.add_vertex(Vector2(k, 3)));
    all_points.push_back(all.add_vertex(Vector2(k, 3)));
    for (int p = std::max(0, k - 3); p <= k; ++p) {
      const PointObservation2 seen(Vector2(p - k + noise(random), 3 + noise(random)));
      graph.add_edge(seen, 2500.0, poses.back(), points[static_cast<std::size_t>(p)]);
      all.add_edge(seen, 2500.0, all_poses.back(), all_points[static_cast<std::size_t>(p)]);
    }
    const SmootherReport report = smoother.update();
    ASSERT_TRUE(report.converged()) << report.message;
    ASSERT_EQ(report.marginalized > 0, k >= 6) << k;
  }
  EXPECT_LE(graph.vertex_count(), 6u + 10u);
  EXPECT_FALSE(graph.contains(poses[53]));
  EXPECT_TRUE(graph.contains(poses[54]));
  EXPECT_TRUE(optimize(all, exact()).converged());
  const SE2 apart = all.estimate(all_poses.back()).inverse() * graph.estimate(poses.back());
  const Eigen::MatrixXd lagged = smoother.covariance({poses.back()});
  Optimizer batch(all, exact());
  EXPECT_TRUE(batch.run().converged());
  const Eigen::MatrixXd full =
      batch.covariance(std::vector<VertexRef>{all_poses.back()}).of(all_poses.back());
  EXPECT_LT((lagged - full).cwiseAbs().maxCoeff(), 0.03 * full.cwiseAbs().maxCoeff());
  const Eigen::Vector2d distance(apart.translation()[0], apart.translation()[1]);
  EXPECT_LT(distance.dot(full.topLeftCorner<2, 2>().ldlt().solve(distance)), 0.05);  // a fifth of a σ
}

TEST(Smoother, KeepsALagOfSecondsAndTakesLatePoses) {
  Graph graph;
  Smoother smoother(graph, {.lag_s = 2.5});
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 10; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    smoother.set_time(poses.back(), k);
    if (k > 0) graph.add_edge(Between(SE2(1, 0, 0)), 1.0, poses[poses.size() - 2], poses.back());
    ASSERT_TRUE(smoother.update().converged());
  }
  EXPECT_EQ(graph.vertex_count(), 3u);
  const auto late = graph.add_vertex(SE2(7.5, 0, 0));
  smoother.set_time(late, 7.5);
  graph.add_edge(Between(SE2(0.5, 0, 0)), 1.0, poses[7], late);
  graph.add_edge(Between(SE2(0.5, 0, 0)), 1.0, late, poses[8]);
  EXPECT_TRUE(smoother.update().converged());
  EXPECT_TRUE(graph.contains(late));
  const auto next = graph.add_vertex(SE2(10, 0, 0));
  smoother.set_time(next, 10);
  graph.add_edge(Between(SE2(1, 0, 0)), 1.0, poses[9], next);
  EXPECT_TRUE(smoother.update().converged());
  EXPECT_FALSE(graph.contains(poses[7]));
  EXPECT_FALSE(graph.contains(late) && graph.vertex_count() > 4);
  EXPECT_NEAR(graph.estimate(next).translation()[0], 10, 1e-6);
}

TEST(Marginalize, KeepsInformationOfAnyUnits) {
  Graph graph;
  const auto a = graph.add_vertex(Vector<double, 1>(0.0)), b = graph.add_vertex(Vector<double, 1>(0.0)),
             c = graph.add_vertex(Vector<double, 1>(0.0));
  const auto difference = [](const Vector<double, 1>& x, const Vector<double, 1>& y) { return y[0] - x[0]; };
  graph.add_edge([](const Vector<double, 1>& x) { return x[0]; }, 1e6, a);
  graph.add_edge(difference, 1e6, a, b);
  graph.add_edge(difference, 1e-8, a, c);
  const auto prior = marginalize(graph, {a});
  ASSERT_TRUE(prior.has_value());
  EXPECT_EQ(graph.error(*prior).size(), 2u);
}

TEST(Smoother, MarginalizesAtTheLinearizationPointsAlsoIfAnUpdateEndsEarly) {
  Graph graph;
  SmootherOptions options{.lag = 2};
  Smoother smoother(graph, options);
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 3; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    if (k == 0) graph.add_edge(Prior(SE2()), 1.0, poses[0]);
    if (k > 0) graph.add_edge(Between(SE2(1, 0, 0)), 1e4, poses[poses.size() - 2], poses.back());
    if (k == 2) break;
    ASSERT_TRUE(smoother.update().converged());
  }
  const std::vector<double> weights{0, 1, 0};
  graph.add_edge(Prior(SE2(0, 5, 0)), Information::diagonal(weights), poses[2]);
  Graph all = graph;
  options.max_iterations = 1;
  smoother.set_options(options);
  EXPECT_EQ(smoother.update().marginalized, 1u);
  (void)smoother.finish();
  EXPECT_TRUE(optimize(all, exact()).converged());
  EXPECT_NEAR(graph.estimate(poses[2]).translation()[1], all.estimate(poses[2]).translation()[1], 0.05);
}

TEST(Smoother, LetsVelocitiesWithoutTimesLeaveTheLag) {
  Graph graph;
  Smoother smoother(graph, {.lag = 10});
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> velocities;
  const auto moves = [](const SE2& x, const Vector2& v, const SE2& y, const Vector2& w) {
    return Vector<double, 4>(y.translation()[0] - x.translation()[0] - v[0],
                             y.translation()[1] - x.translation()[1] - v[1], w[0] - v[0], w[1] - v[1]);
  };
  for (int k = 0; k < 60; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    velocities.push_back(graph.add_vertex(Vector2(1, 0)));
    if (k == 0) graph.add_edge(Prior(SE2()), 1.0, poses[0]);
    if (k > 0) {
      const std::size_t last = poses.size() - 2;
      graph.add_edge(moves, 1.0, poses[last], velocities[last], poses.back(), velocities.back());
      graph.add_edge(Between(SE2(1, 0, 0)), 1.0, poses[last], poses.back());
    }
    ASSERT_TRUE(smoother.update().converged()) << k;
  }
  EXPECT_LE(graph.vertex_count(), 22u);
}

}  // namespace
}  // namespace boxplus
