// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/types/constraint.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

Options exact_options() {
  return {.max_iterations = 200, .cost_tolerance = 1e-15, .noise_tolerance = 0, .step_tolerance = 0};
}

/// The largest entry of the gradient of F + λᵀc.
double gradient_of_lagrangian(const Graph& graph, const Report& report, VertexRef vertex) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(graph.tangent_dim(vertex));
  for (const EdgeRef edge : graph.edges(vertex)) {
    const auto vertices = graph.vertices(edge);
    const auto place = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
    const Eigen::MatrixXd J = graph.jacobian(edge)[static_cast<std::size_t>(place)];
    const auto constraint = std::ranges::find(report.constraints, edge, &Report::ConstraintResult::edge);
    if (constraint != report.constraints.end()) {
      sum += J.transpose() * Eigen::VectorXd::Map(constraint->multipliers.data(), J.rows());
    } else {
      const std::vector<double> e = graph.error(edge);
      sum += 2 * J.transpose() * graph.information(edge).matrix() * Eigen::VectorXd::Map(e.data(), J.rows());
    }
  }
  return sum.lpNorm<Eigen::Infinity>();
}

constexpr auto kRosenbrock = [](const auto& x) {
  using S = std::decay_t<decltype(x[0])>;
  return Vector<S, 2>(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]);
};

TEST(Constraint, HoldsExactlyAtTheNearestPointOfACircle) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(3, 0.5));
  graph.add_edge([](const auto& p) { return (p - Vector2(3, 4)).eval(); }, x);
  const auto circle = graph.add_edge(Constraint([](const auto& p) { return p.squaredNorm() - 4.0; }), x);
  const Report report = optimize(graph, exact_options());
  ASSERT_TRUE(report.converged()) << report;
  EXPECT_NEAR(graph.estimate(x)[0], 1.2, 1e-6);
  EXPECT_NEAR(graph.estimate(x)[1], 1.6, 1e-6);
  EXPECT_LE(report.constraint_violation, 1e-9);
  EXPECT_NEAR(report.chi2_final, 9, 1e-8);
  ASSERT_EQ(report.constraints.size(), 1u);
  EXPECT_EQ(report.constraints[0].edge, circle);
  EXPECT_NEAR(report.constraints[0].multipliers[0], 1.5, 1e-6) << "2 (p − z) + λ 2 p = 0";
  EXPECT_THAT(to_string(report), testing::HasSubstr("constraints"));
}

TEST(Constraint, HoldsIfTheStartSatisfiesItAndOtherEdgesAreHeavy) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(0.5, 0.5));
  graph.add_edge([](const auto& p) { return (p - Vector2(3, 4)).eval(); }, 1e6, x);
  graph.add_edge(Constraint([](const auto& p) { return p[0] + p[1] - 1.0; }), x);
  const Report report = optimize(graph);
  ASSERT_TRUE(report.converged()) << report;
  EXPECT_NEAR((graph.estimate(x) - Vector2(0, 1)).norm(), 0, 1e-8);
  EXPECT_NEAR(report.constraints[0].multipliers[0], 6e6, 1) << "2 · 1e6 (p − z) + λ = 0";
}

/// Hock and Schittkowski, "Test examples for nonlinear programming codes" (1981), problems 6, 42, 52 and 79.
TEST(Constraint, GivesTheOptimaOfHockAndSchittkowski) {
  {
    Graph graph;
    const auto x = graph.add_vertex(Vector2(-1.2, 1));
    graph.add_edge([](const auto& p) { return 1.0 - p[0]; }, x);
    graph.add_edge(Constraint([](const auto& p) { return 10.0 * (p[1] - p[0] * p[0]); }), x);
    const Report report = optimize(graph, exact_options());
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR((graph.estimate(x) - Vector2(1, 1)).norm(), 0, 1e-7);
  }
  {
    Graph graph;
    const auto x = graph.add_vertex(Vector<double, 4>(1, 1, 1, 1));
    graph.add_edge([](const auto& p) { return (p - Vector<double, 4>(1, 2, 3, 4)).eval(); }, x);
    graph.add_edge(Constraint([](const auto& p) { return p[0] - 2.0; }), x);
    graph.add_edge(Constraint([](const auto& p) { return p[2] * p[2] + p[3] * p[3] - 2.0; }), x);
    const Report report = optimize(graph, exact_options());
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, 28 - 10 * std::sqrt(2.0), 1e-8);
    EXPECT_LT(gradient_of_lagrangian(graph, report, x), 1e-3);
  }
  {
    Graph graph;
    const auto x = graph.add_vertex(Vector<double, 5>(2, 2, 2, 2, 2));
    graph.add_edge(
        [](const auto& p) {
          using S = std::decay_t<decltype(p[0])>;
          return Vector<S, 4>(4.0 * p[0] - p[1], p[1] + p[2] - 2.0, p[3] - 1.0, p[4] - 1.0);
        },
        x);
    graph.add_edge(Constraint([](const auto& p) {
                     using S = std::decay_t<decltype(p[0])>;
                     return Vector<S, 3>(p[0] + 3.0 * p[1], p[2] + p[3] - 2.0 * p[4], p[1] - p[4]);
                   }),
                   x);
    const Report report = optimize(graph, exact_options());
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, 1859.0 / 349, 1e-8);
    EXPECT_NEAR(graph.estimate(x)[0], -33.0 / 349, 1e-6);
  }
  {
    Graph graph;
    const auto x = graph.add_vertex(Vector<double, 5>(2, 2, 2, 2, 2));
    graph.add_edge(
        [](const auto& p) {
          using S = std::decay_t<decltype(p[0])>;
          const S a = p[2] - p[3], b = p[3] - p[4];
          return Vector<S, 5>(p[0] - 1.0, p[0] - p[1], p[1] - p[2], a * a, b * b);
        },
        x);
    graph.add_edge(Constraint([](const auto& p) {
                     using S = std::decay_t<decltype(p[0])>;
                     return Vector<S, 3>(
                         p[0] + p[1] * p[1] + p[2] * p[2] * p[2] - (2.0 + 3.0 * std::sqrt(2.0)),
                         p[1] - p[2] * p[2] + p[3] - (2.0 * std::sqrt(2.0) - 2.0), p[0] * p[4] - 2.0);
                   }),
                   x);
    const Report report = optimize(graph, exact_options());
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, 0.0787768209, 1e-8);
  }
}

/// Two robots that measure themselves poorly, and a constraint between their poses with several rows and
/// analytic Jacobians.
TEST(Constraint, HoldsBetweenPosesAndLeavesTheGraphAsItWas) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0.1 * k, 0.01 * k)));
    if (k > 0)
      graph.add_edge(Between(SE2(1, 0.05 * (k % 3), 0.02)), 10.0, poses[poses.size() - 2], poses.back());
  }
  graph.fix(poses[0]);
  const auto closure = graph.add_edge(Constraint(Between(SE2(18, 2, 0.3))), 3.0, poses[0], poses.back());
  Optimizer optimizer(graph, exact_options());
  const Report report = optimizer.run();
  ASSERT_TRUE(report.converged()) << report;
  EXPECT_GT(report.constraint_rounds, 1);
  for (const double error : graph.error(closure)) EXPECT_NEAR(error, 0, 1e-8);
  EXPECT_EQ(graph.information(closure)(0, 0), 3.0);
  EXPECT_NEAR(graph.chi2(), report.chi2_final, 1e-9);
  for (const VertexRef pose : poses) {
    if (graph.is_fixed(pose)) continue;
    EXPECT_LT(gradient_of_lagrangian(graph, report, pose), 1e-4);
  }
  const Report again = optimizer.run();
  EXPECT_TRUE(again.converged()) << again;
  EXPECT_TRUE(again.plan_reused);
  EXPECT_NEAR(again.chi2_final, report.chi2_final, 1e-7 * report.chi2_final);
}

TEST(Constraint, WorksTogetherWithBounds) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(0.2, 0.3));
  graph.add_edge(kRosenbrock, x);
  graph.add_edge(Constraint([](const auto& p) { return p[0] + p[1] - 1.0; }), x);
  graph.set_bounds(x, 0, 0, 0.5);
  const Report report = optimize(graph, exact_options());
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(graph.estimate(x)[0], 0.5);
  EXPECT_NEAR(graph.estimate(x)[1], 0.5, 1e-8);
  EXPECT_EQ(report.active_bounds.size(), 1u);
}

/// Without the constraint, chi2 would fall away from the limit.
TEST(Constraint, CountsInTheMultipliersOfBounds) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(0.5, 0.5));
  graph.add_edge([](const auto& p) { return (p - Vector2(0.2, 2)).eval(); }, x);
  graph.add_edge(Constraint([](const auto& p) { return p[0] + p[1] - 1.0; }), x);
  graph.set_bounds(x, 0, 0, 1);
  const Report report = optimize(graph);
  ASSERT_TRUE(report.converged()) << report;
  EXPECT_EQ(graph.estimate(x)[0], 0);
  ASSERT_EQ(report.active_bounds.size(), 1u) << report;
  EXPECT_NEAR(report.active_bounds[0].multiplier, 1.6, 1e-6) << "λ = 2 (2 − 1); 2 (0 − 0.2) + λ = 1.6";
  EXPECT_EQ(report.records.size(), static_cast<std::size_t>(report.iterations));
  EXPECT_GT(report.iterations, 0);
}

TEST(Constraint, IsReportedIfItCannotHoldHoweverFarTheStartIs) {
  for (const double start : {1e3, 1e6, 1e12}) {
    Graph graph;
    const auto x = graph.add_vertex(start);
    graph.add_edge(Constraint([](const auto& v) { return 1.0 * v; }), x);
    graph.add_edge(Constraint([](const auto& v) { return v - 1e-3; }), x);
    graph.add_edge([](const auto& v) { return v - 3.0; }, x);
    const Report report = optimize(graph);
    EXPECT_FALSE(report.converged()) << report;
    EXPECT_EQ(report.reason, Report::Reason::kConstraints);
    EXPECT_GE(report.constraint_violation, 5e-4 - 1e-9);
  }
}

TEST(Constraint, HoldsTo1e9HoweverFarTheStartIs) {
  for (const double start : {1e2, 1e5, 1e8}) {
    Graph graph;
    const auto x = graph.add_vertex(Vector2(start, 2));
    graph.add_edge(Constraint([](const auto& p) { return p[0] * p[1] - 1.0; }), x);
    graph.add_edge([](const auto& p) { return (p - Vector2(3, -2)).eval(); }, x);
    const Report report = optimize(graph, {.max_iterations = 500});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LE(report.constraint_violation, 1e-9);
    EXPECT_LE(std::abs(graph.estimate(x)[0] * graph.estimate(x)[1] - 1), 1e-9);
  }
}

/// At 1e9, numbers are rounded to 1e-7.
TEST(Constraint, HoldsToTheRoundingOfItsTermsIfThisIsMoreThan1e9) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(1e9, 0));
  graph.add_edge([](const auto& p) { return (p - Vector2(1e9, 1)).eval(); }, x);
  graph.add_edge(Constraint([](const auto& p) { return p[0] - 3.0 * p[1] - 7e8 / 3; }), x);
  const Report report = optimize(graph, exact_options());
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LE(report.constraint_violation, 4e-6);
}

TEST(Constraint, HasAMeasuredViolationAlsoIfTheRunIsStopped) {
  Graph graph;
  const auto x = graph.add_vertex(5.0);
  graph.add_edge([](const auto& v) { return v - 3.0; }, x);
  const auto constraint = graph.add_edge(Constraint([](const auto& v) { return v - 1.0; }), x);
  Optimizer optimizer(graph, {.max_iterations = 0});
  EXPECT_EQ(optimizer.run().constraint_violation, 4);
  optimizer.set_options({.time_limit_s = 0});
  EXPECT_EQ(optimizer.run().constraint_violation, 4) << "the plan is there, so it can be measured";
  graph.add_edge([](const auto& v) { return 2.0 * v; }, x);
  const Report report = optimizer.run();
  EXPECT_THAT(report.message, testing::HasSubstr("while planning"));
  EXPECT_TRUE(std::isnan(report.constraint_violation)) << report;
  graph.remove(constraint);
  EXPECT_EQ(optimizer.run().constraint_violation, 0);
}

TEST(Constraint, GivesTheSameResultInAnOptimizerAfterARemoval) {
  const auto distance = [](const auto& p, const auto& q) {
    using std::sqrt;
    return sqrt((p - q).squaredNorm()) - 1.5;
  };
  const auto compare = [](auto edge) {
    Graph graph;
    std::vector<VertexHandle<Vector2>> x;
    for (const Vector2& p : {Vector2(0, 0), Vector2(1, 0.1), Vector2(2, -0.1), Vector2(3, 0.2)})
      x.push_back(graph.add_vertex(p));
    graph.add_edge(Prior(Vector2(0, 0)), x[0]);
    for (std::size_t i = 0; i < 3; ++i) graph.add_edge(Between(Vector2(1, 0)), x[i], x[i + 1]);
    graph.add_edge(edge, x[3], x[0]);
    Optimizer optimizer(graph, {.threads = 1});
    EXPECT_TRUE(optimizer.run().converged());
    graph.remove(x[2]);
    Graph copy = graph;
    const Report report = optimizer.run(), of_copy = optimize(copy, {.threads = 1});
    EXPECT_EQ(report.status, of_copy.status) << report << of_copy;
    EXPECT_EQ(report.constraint_violation, of_copy.constraint_violation);
    EXPECT_EQ(report.chi2_final, of_copy.chi2_final);
    EXPECT_EQ(report.records.size(), of_copy.records.size()) << report << of_copy;
    for (const std::size_t i : {0u, 1u, 3u}) EXPECT_EQ(graph.estimate(x[i]), copy.estimate(x[i]));
  };
  compare(Constraint(distance));
  compare(distance);
}

TEST(Constraint, IsReportedIfItCannotHold) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  graph.add_edge(Constraint([](const auto& v) { return v - 1.0; }), x);
  graph.add_edge(Constraint([](const auto& v) { return v - 2.0; }), x);
  const Report report = optimize(graph);
  EXPECT_FALSE(report.converged()) << report;
  EXPECT_EQ(report.reason, Report::Reason::kConstraints);
  EXPECT_GT(report.constraint_violation, 0.1);
  EXPECT_THAT(report.message, testing::HasSubstr("has an error of"));
}

TEST(Constraint, TakesNoPartIfItIsDisabledOrOfAnotherLevel) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  graph.add_edge([](const auto& v) { return v - 3.0; }, x);
  const auto constraint = graph.add_edge(Constraint([](const auto& v) { return v - 1.0; }), x);
  graph.set_enabled(constraint, false);
  EXPECT_EQ(optimize(graph).constraint_rounds, 0);
  EXPECT_NEAR(graph.estimate(x), 3, 1e-9);
  graph.set_enabled(constraint, true);
  graph.set_level(constraint, 1);
  EXPECT_EQ(optimize(graph).constraint_rounds, 0);
  EXPECT_NEAR(graph.estimate(x), 3, 1e-9);
  graph.set_level(constraint, 0);
  EXPECT_GT(optimize(graph).constraint_rounds, 0);
  EXPECT_NEAR(graph.estimate(x), 1, 1e-9);
}

TEST(Constraint, WithARobustKernelIsRefused) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  const auto constraint = graph.add_edge(Constraint([](const auto& v) { return v - 1.0; }), x);
  graph.set_kernel(constraint, Huber(1.0));
  EXPECT_THROW(std::ignore = optimize(graph), InvalidArgument);
}

TEST(Constraint, KeepsTheKindOfJacobiansOfItsFunction) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0)), b = graph.add_vertex(SE2(1, 0, 0));
  const auto source = [&](auto edge) {
    const EdgeRef added = graph.add_edge(edge, a, b);
    return graph.edge_pools()[added.pool]->jacobian_source();
  };
  EXPECT_EQ(source(Constraint(Between(SE2()))), source(Between(SE2())));
  EXPECT_EQ(source(Constraint([](const SE2& x, const SE2& y) { return x.theta() - y.theta(); })),
            detail::JacobianSource::kNumeric);
}

}  // namespace
}  // namespace boxplus
