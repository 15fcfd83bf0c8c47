// SPDX-License-Identifier: BSD-3-Clause
// optimize() on many kinds of problems.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

std::ptrdiff_t count_numeric(const Report& report) {
  return std::count_if(
      report.jacobians.begin(), report.jacobians.end(),
      [](const Report::EdgeJacobians& edge) { return edge.source == detail::JacobianSource::kNumeric; });
}

TEST(Optimize, OfAnEmptyGraphHasNothingToDo) {
  Graph graph;
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.reason, Report::Reason::kNothingToOptimize);
}

TEST(Optimize, WithEverythingFixedReportsTheChi2) {
  Graph graph;
  for (const auto& pose : add_noisy_circle(graph, 5)) graph.fix(pose);
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Report::Reason::kNothingToOptimize);
  EXPECT_GT(report.chi2_final, 0);
}

TEST(Optimize, ReportsTheTranslationThatNothingMeasures) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0));
  const auto b = graph.add_vertex(Vector2(1, 1), 77);
  graph.fix(a);
  graph.add_edge([](const auto& x, const auto& y) { return y[0] - x[0] - 1.5; }, a, b);
  for (int edges = 1; edges <= 2; ++edges) {  // a second edge along x still does not measure y
    const Report report = optimize(graph, {.algorithm = AlgorithmKind::kGaussNewton});
    EXPECT_TRUE(report.converged()) << report;
    ASSERT_EQ(report.gauge.free.size(), 1u);
    EXPECT_EQ(to_string(report.gauge.free[0]), "translation");
    EXPECT_EQ(report.gauge.free[0].id, 77);
    EXPECT_EQ(graph.estimate(b)[1], 1);
    graph.add_edge([](const auto& y) { return y[0] - 2.0; }, b);
  }
}

TEST(Optimize, NamesAVertexWithADirectionThatNothingMeasures) {
  Graph graph;
  using Bias = Vector<double, 4>;
  const auto a = graph.add_vertex(Bias(0, 0, 0, 0));
  const auto b = graph.add_vertex(Bias(1, 1, 1, 1), 77);
  graph.fix(a);
  graph.add_edge([](const auto& x, const auto& y) { return y[0] - x[0] - 1.5; }, a, b);
  graph.add_edge([](const auto& y) { return y[0] - 2.0; }, b);
  Options options;
  options.algorithm = AlgorithmKind::kGaussNewton;
  const Report singular = optimize(graph, options);
  EXPECT_EQ(singular.status, Report::Status::kFailed);
  EXPECT_EQ(singular.reason, Report::Reason::kNotPositiveDefinite);
  EXPECT_THAT(singular.message, HasSubstr("vertex 77"));
  // Dogleg damps H and reports it.
  options.algorithm = AlgorithmKind::kDogleg;
  const Report damped = optimize(graph, options);
  EXPECT_TRUE(damped.converged()) << damped;
  EXPECT_GT(damped.regularized_steps, 0);
  EXPECT_NEAR(graph.estimate(b)[0], 1.75, 1e-6);
  EXPECT_EQ(graph.estimate(b)[1], 1);
}

TEST(Optimize, RefusesInvalidOptions) {
  Graph graph;
  add_noisy_circle(graph, 5);
  const auto with = [](auto set) {
    Options options;
    set(options);
    return options;
  };
  EXPECT_THROW((void)optimize(graph, with([](Options& o) { o.max_iterations = -1; })), InvalidArgument);
  EXPECT_THROW((void)optimize(graph, with([](Options& o) { o.threads = -1; })), InvalidArgument);
  EXPECT_THROW((void)optimize(graph, with([](Options& o) { o.cost_tolerance = std::nan(""); })),
               InvalidArgument);
  EXPECT_THROW((void)optimize(graph, with([](Options& o) { o.linear_tolerance = -1; })), InvalidArgument);
  EXPECT_THROW((void)optimize(graph, with([](Options& o) {
                                o.vertices = {VertexRef{7, 7, 7}};
                              })),
               InvalidArgument);
}

TEST(Optimize, RefusesOptionsThatAreNotValuesOfTheirEnum) {
  Graph graph;
  add_noisy_circle(graph, 5);
  const auto refusal = [&](auto set) -> std::string {
    Options options;
    set(options);
    try {
      (void)optimize(graph, options);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "accepted";
  };
  using DampingScale = Options::DampingScale;
  EXPECT_EQ(refusal([](Options& o) { o.gauge = static_cast<GaugePolicy>(3); }),
            "Options: expected one of the values of GaugePolicy, got 3");
  EXPECT_EQ(refusal([](Options& o) { o.precision = static_cast<Precision>(3); }),
            "Options: expected one of the values of Precision, got 3");
  EXPECT_EQ(refusal([](Options& o) { o.schur = static_cast<SchurMode>(77); }),
            "Options: expected one of the values of SchurMode, got 77");
  EXPECT_EQ(refusal([](Options& o) { o.damping = static_cast<DampingScale>(2); }),
            "Options: expected one of the values of DampingScale, got 2");
}

TEST(Optimize, OfASubsetMovesOnlyItsVertices) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  Options options;
  options.vertices = {poses[3], poses[4]};
  const SE2 outside = graph.estimate(poses[5]), inside = graph.estimate(poses[4]);
  graph.set_estimate(poses[4], inside * SE2(0.5, -0.3, 0.2));
  const Report report = optimize(graph, options);
  EXPECT_EQ(report.vertices, 2u);
  EXPECT_EQ(report.edges, 3u);
  EXPECT_EQ(graph.estimate(poses[5]).vector(), outside.vector());
  EXPECT_LT((inside.inverse() * graph.estimate(poses[4])).vector().norm(), 1e-6) << "odometry puts it back";
  options.vertices.clear();
  options.edges = {graph.all_edges()[0], graph.all_edges()[1]};
  EXPECT_EQ(optimize(graph, options).edges, 2u);
}

TEST(Optimize, UsesTheEdgesOfOneLevel) {
  Graph graph;
  const auto x = graph.add_vertex(Vector<double, 1>(0.0));
  graph.add_edge([](const auto& v) { return v[0] - 1.0; }, x);
  const auto other = graph.add_edge([](const auto& v) { return v[0] - 5.0; }, x);
  graph.set_level(other, 1);
  std::ignore = optimize(graph);
  EXPECT_NEAR(graph.estimate(x)[0], 1, 1e-12);
  Options options;
  options.level = 1;
  std::ignore = optimize(graph, options);
  EXPECT_NEAR(graph.estimate(x)[0], 5, 1e-12);
  options.level = -1;
  std::ignore = optimize(graph, options);
  EXPECT_NEAR(graph.estimate(x)[0], 3, 1e-12);
}

TEST(Optimize, DifferentiatesFunctionsOfPlainEigenVectorsNumerically) {
  struct Plain {
    Eigen::Vector2d error(const Eigen::Vector2d& x) const { return x - Eigen::Vector2d(1, 2); }
  };
  Graph graph;
  const auto x = graph.add_vertex(Eigen::Vector2d(0, 0));
  graph.add_edge([](const Eigen::Vector2d& v) { return v[0] - 4; }, x);
  graph.add_edge(std::function<double(const Eigen::Vector2d&)>([](const auto& v) { return v[1]; }), x);
  graph.add_edge(Plain{}, x);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(count_numeric(report), 3);
  EXPECT_NEAR(graph.estimate(x)[0], 2.5, 1e-9);
  EXPECT_NEAR(graph.estimate(x)[1], 1, 1e-9);
}

TEST(Optimize, ReportsWhichEdgesAreDifferentiatedNumerically) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 5);
  EXPECT_EQ(count_numeric(optimize(graph)), 0);
  graph.add_edge([](const SE2& p) { return p.x(); }, poses[0]);
  EXPECT_EQ(count_numeric(optimize(graph)), 1);
  Options options;
  options.numeric_jacobians = true;
  EXPECT_EQ(count_numeric(optimize(graph, options)), 2);
}

struct East {
  static constexpr std::string_view kName = "East";
  double error(const SE2& p) const { return p.x() - 1; }
};

struct North {
  static constexpr std::string_view kName = "North";
  template <class Pose>
  auto error(const Pose& p) const {
    return p.y() - 1.0;
  }
};

TEST(Optimize, ReportsTheSourceOfTheJacobiansOfEachEdgeType) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 5);
  graph.add_edge(East{}, poses[0]);
  graph.add_edge(North{}, poses[0]);
  EXPECT_THAT(to_string(optimize(graph)),
              HasSubstr("  Jacobians       analytic: Between<SE2>; exact: North; numeric: East\n"));
}

TEST(Optimize, WithDynamicCovarianceScalingReachesAMeasurementFarAway) {
  Graph graph;
  const auto x = graph.add_vertex(0.0);
  graph.set_kernel(graph.add_edge([](const auto& v) { return v - 10.0; }, x), DCS(1));
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_NEAR(graph.estimate(x), 10, 1e-6);
}

TEST(Optimize, RejectsAnOutlierUnderARobustKernel) {
  Graph graph;
  const auto x = graph.add_vertex(Vector<double, 1>(3.0));
  for (int i = 0; i < 10; ++i) graph.add_edge([i](const auto& v) { return v[0] - (1.0 + 0.01 * i); }, x);
  const auto outlier = graph.add_edge([](const auto& v) { return v[0] - 100.0; }, x);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Cauchy(0.1));
  Optimizer optimizer(graph);
  EXPECT_TRUE(optimizer.run().converged());
  EXPECT_NEAR(graph.estimate(x)[0], 1.045, 0.01);
  graph.set_enabled(outlier, false);
  const Report report = optimizer.run();
  EXPECT_EQ(report.disabled_edges, 1u);
  EXPECT_TRUE(report.plan_reused);
}

}  // namespace
}  // namespace boxplus
