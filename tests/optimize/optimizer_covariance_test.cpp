// SPDX-License-Identifier: BSD-3-Clause
// Optimizer::covariance() keeps its plan and its factor. It must never use them when they are out of date.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"
#include "linear/every_solver.h"
#include "linearize/bundle.h"
#include "optimize/dense_inverse.h"
#include "optimize/random_graph.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

struct Problem {
  std::string name;
  std::function<Graph()> make;
};

std::vector<Problem> ten_problems() {
  std::vector<Problem> problems;
  for (const World world : kWorlds) {
    problems.push_back(
        {std::string(to_string(world)), [world] { return std::move(simulate(world, {.poses = 40}).graph); }});
  }
  problems.push_back({"random", [] { return std::move(RandomGraph(5, false).graph); }});
  problems.push_back({"bundle", [] { return std::move(make_bundle(4, 20, false).graph); }});
  return problems;
}

/// Eliminates as many vertices as possible, in the order of their ids.
void eliminate_some(Graph& graph) {
  std::set<VertexRef> kept;
  for (const VertexRef& vertex : graph.all_vertices()) {
    if (kept.contains(vertex) || graph.is_fixed(vertex)) continue;
    graph.set_eliminated(vertex, true);
    for (const EdgeRef& edge : graph.edges(vertex)) {
      for (const VertexRef& neighbor : graph.vertices(edge)) {
        if (neighbor != vertex) kept.insert(neighbor);
      }
    }
  }
}

std::vector<VertexRef> moving_vertices(const Graph& graph, const std::vector<VertexRef>& held) {
  std::vector<VertexRef> moving;
  for (const auto& list : {graph.all_vertices(), graph.all_parameters()}) {
    for (const VertexRef& vertex : list) {
      const bool is_held = std::find(held.begin(), held.end(), vertex) != held.end();
      if (!graph.is_fixed(vertex) && !is_held) moving.push_back(vertex);
    }
  }
  return moving;
}

void expect_close(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double tolerance) {
  ASSERT_EQ(actual.rows(), expected.rows());
  ASSERT_EQ(actual.cols(), expected.cols());
  ASSERT_TRUE(expected.allFinite());
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), tolerance * expected.cwiseAbs().maxCoeff())
      << actual << "\n\n"
      << expected;
}

/// Compares three joint covariances and all marginal covariances with the dense inverse.
void expect_equal_to_dense(const Graph& graph, const Optimizer& optimizer) {
  const std::vector<VertexRef> all = graph.all_vertices();
  const Covariance marginal = optimizer.marginal_covariances(all);
  ASSERT_TRUE(marginal.ok()) << marginal.message();
  const DenseInverse dense(graph, moving_vertices(graph, marginal.held()));
  double scale = 0;
  for (const VertexRef& v : all) scale = std::max(scale, dense.of(graph, v, v).cwiseAbs().maxCoeff());
  const auto expect_equal = [&](const Covariance& covariance, VertexRef a, VertexRef b) {
    const Eigen::MatrixXd difference = covariance.of(a, b) - dense.of(graph, a, b);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-8 * scale) << graph.id(a) << " " << graph.id(b);
  };
  for (const VertexRef& v : all) expect_equal(marginal, v, v);
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexRef some[] = {all[k], all[all.size() / 2 + k], all[all.size() - 1 - k]};
    const Covariance joint = optimizer.covariance(some);
    ASSERT_TRUE(joint.ok()) << joint.message();
    for (const VertexRef& a : some) {
      for (const VertexRef& b : some) expect_equal(joint, a, b);
    }
  }
}

TEST(OptimizerCovariance, EqualsADenseInverseForTenProblemsEverySolverAndElimination) {
  for (const Problem& problem : ten_problems()) {
    for (const detail::LinearSolverEntry& solver : detail::linear_solver_table()) {
      for (const bool eliminates : {false, true}) {
        SCOPED_TRACE(problem.name + ", " + std::string(solver.name) + (eliminates ? ", eliminates" : ""));
        Graph graph = problem.make();
        if (eliminates) eliminate_some(graph);
        Optimizer optimizer(graph, {.linear_solver = solver.kind, .max_iterations = 3});
        std::ignore = optimizer.run();
        expect_equal_to_dense(graph, optimizer);
      }
    }
  }
}

/// A circle with a landmark, a disabled edge and, if wanted, an edge with a kernel.
struct Circle {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses = add_noisy_circle(graph, 12);
  VertexHandle<Vector2> landmark = graph.add_vertex(Vector2(2, 3));
  EdgeHandle<PointObservation2> seen =
      graph.add_edge(PointObservation2(Vector2(1, 1)), 4.0, poses[2], landmark);
  EdgeHandle<PointObservation2> again =
      graph.add_edge(PointObservation2(Vector2(3, 2)), 4.0, poses[7], landmark);
  EdgeHandle<Between<SE2>> disabled = graph.add_edge(Between(SE2(1, 2, 3)), 9.0, poses[1], poses[6]);
  explicit Circle(bool has_kernel) {
    if (has_kernel) graph.set_kernel(again, Huber(0.5));
    graph.set_enabled(disabled, false);
  }
  std::vector<VertexRef> asked() const { return {poses[5], landmark, poses[10]}; }
};

struct Change {
  std::string name;
  std::function<void(Circle&, Optimizer&)> apply;
};

std::vector<Change> changes() {
  return {
      {"an estimate", [](Circle& c, Optimizer&) { c.graph.set_estimate(c.landmark, Vector2(9, 4)); }},
      {"a pose", [](Circle& c, Optimizer&) { c.graph.set_estimate(c.poses[4], SE2(5, 1, 2)); }},
      {"a popped estimate",
       [](Circle& c, Optimizer&) {
         c.graph.push();
         c.graph.set_estimate(c.landmark, Vector2(9, 4));
         c.graph.pop();
         c.graph.set_estimate(c.landmark, Vector2(8, 4));
         c.graph.push();
         c.graph.set_estimate(c.landmark, Vector2(9, 4));
         c.graph.pop();
       }},
      {"a measurement",
       [](Circle& c, Optimizer&) { c.graph.set_measurement(c.again, PointObservation2(Vector2(30, 20))); }},
      {"an information", [](Circle& c, Optimizer&) { c.graph.set_information(c.seen, 400.0); }},
      {"a kernel", [](Circle& c, Optimizer&) { c.graph.set_kernel(c.again, Huber(0.01)); }},
      {"a removed kernel", [](Circle& c, Optimizer&) { c.graph.set_kernel(c.again, nullptr); }},
      {"an enabled edge", [](Circle& c, Optimizer&) { c.graph.set_enabled(c.disabled, true); }},
      {"a disabled edge", [](Circle& c, Optimizer&) { c.graph.set_enabled(c.again, false); }},
      {"a level", [](Circle& c, Optimizer&) { c.graph.set_level(c.again, 1); }},
      {"a fixed vertex", [](Circle& c, Optimizer&) { c.graph.fix(c.poses[4]); }},
      {"a fixed direction",
       [](Circle& c, Optimizer&) {
         c.graph.fix(c.poses[0]);
         c.graph.fix_directions(c.poses[5], {2});
       }},
      {"an eliminated vertex",
       [](Circle& c, Optimizer&) {
         c.graph.set_eliminated(c.landmark, true);
         c.graph.set_information(c.seen, 5.0);
       }},
      {"a new edge",
       [](Circle& c, Optimizer&) { c.graph.add_edge(Between(SE2(1, 0, 1)), 90.0, c.poses[3], c.poses[9]); }},
      {"a removed edge", [](Circle& c, Optimizer&) { c.graph.remove(c.disabled), c.graph.remove(c.again); }},
      {"a new vertex",
       [](Circle& c, Optimizer&) {
         const auto added = c.graph.add_vertex(Vector2(1, 1));
         c.graph.add_edge(PointObservation2(Vector2(1, 0)), c.poses[3], added);
         c.graph.add_edge(PointObservation2(Vector2(1, 2)), c.poses[8], added);
       }},
      {"a removed vertex", [](Circle& c, Optimizer&) { c.graph.remove(c.poses[4]); }},
      {"another run",
       [](Circle& c, Optimizer& optimizer) {
         c.graph.set_measurement(c.seen, PointObservation2(Vector2(5, 4)));
         std::ignore = optimizer.run();
       }},
      {"a run that plans again",
       [](Circle& c, Optimizer& optimizer) {
         c.graph.add_edge(Between(SE2(1, 0, 1)), 90.0, c.poses[3], c.poses[9]);
         std::ignore = optimizer.run();
       }},
      {"a run of another optimizer",
       [](Circle& c, Optimizer&) {
         c.graph.set_measurement(c.seen, PointObservation2(Vector2(5, 4)));
         std::ignore = optimize(c.graph);
       }},
      {"the options",
       [](Circle& c, Optimizer& optimizer) {
         Options options = optimizer.options();
         options.vertices = {c.poses[5], c.landmark, c.poses[10], c.poses[11]};
         optimizer.set_options(options);
       }},
      {"the correction of Triggs",
       [](Circle& c, Optimizer& optimizer) {
         c.graph.set_measurement(c.again, PointObservation2(Vector2(30, 20)));
         Options options = optimizer.options();
         options.triggs_correction = true;
         optimizer.set_options(options);
       }},
  };
}

TEST(OptimizerCovariance, NoticesEveryChange) {
  for (const Change& change : changes()) {
    // Without kernels, the inputs of H are compared; with kernels, H itself. Without kernels, three of the
    // changes leave the covariances as they are.
    for (int k = 0; k < 4; ++k) {
      const bool runs_before = k % 2 == 0, has_kernel = k < 2;
      SCOPED_TRACE(change.name + (runs_before ? " after a run" : " without a run") +
                   (has_kernel ? ", with a kernel" : ""));
      Circle circle(has_kernel);
      Optimizer optimizer(circle.graph);
      if (runs_before) std::ignore = optimizer.run();
      const Eigen::MatrixXd before = optimizer.covariance(circle.asked()).joint();
      expect_close(before, covariance(circle.graph, circle.asked()).joint(), 1e-10);
      change.apply(circle, optimizer);
      for (int query = 0; query < 2; ++query) {
        const Eigen::MatrixXd after = optimizer.covariance(circle.asked()).joint();
        expect_close(after, covariance(circle.graph, circle.asked(), optimizer.options()).joint(), 1e-10);
        if (has_kernel) {
          EXPECT_GT((after - before).cwiseAbs().maxCoeff(), 1e-6 * before.cwiseAbs().maxCoeff());
        }
      }
    }
  }
}

TEST(OptimizerCovariance, NoticesChangesOfWhatAnErrorFunctionRefersTo) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  double factor = 2;
  graph.fix(a);
  graph.add_edge([&factor](const auto& x, const auto& y) { return factor * (y - x); }, a, b);
  Optimizer optimizer(graph);
  std::ignore = optimizer.run();
  EXPECT_DOUBLE_EQ(optimizer.covariance(b, b)(0, 0), 1.0 / 4);
  factor = 4;
  EXPECT_DOUBLE_EQ(optimizer.covariance(b, b)(0, 0), 1.0 / 16);
}

TEST(OptimizerCovariance, TakesAListOfVerticesInBraces) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  graph.add_edge(Prior(1.0), 4.0, a);
  graph.add_edge(Between(1.0), 4.0, a, b);
  const Optimizer optimizer(graph);
  EXPECT_NEAR(optimizer.covariance({a}).of(a, a)(0, 0), 0.25, 1e-12);
  EXPECT_NEAR(optimizer.covariance({a, b}).of(b, b)(0, 0), 0.5, 1e-12);
}

/// The errors vanish before and after the change, and all values of the errors are the same.
TEST(OptimizerCovariance, NoticesAnEstimateThatChangesNoError) {
  Graph graph;
  const auto p = graph.add_vertex(Vector2(3, 4));
  graph.add_edge([](const auto& x) { return x.squaredNorm() - 25; }, p);
  graph.add_edge([](const auto& x) { return 0.0 * x[0]; }, p);
  graph.add_edge([](const auto& x) { return x[0] * x[1] - 12; }, p);
  Optimizer optimizer(graph);
  const Eigen::MatrixXd before = optimizer.covariance(p, p);
  graph.set_estimate(p, Vector2(4, 3));
  const Eigen::MatrixXd after = optimizer.covariance(p, p);
  EXPECT_NEAR(after(0, 0), before(1, 1), 1e-12);
  EXPECT_GT(std::abs(after(0, 0) - before(0, 0)), 1e-3);
}

/// Nothing fixes the scale, and which motions are free depends on the estimates.
TEST(OptimizerCovariance, FindsTheGaugeOfTheCurrentEstimates) {
  Bundle bundle = make_bundle(4, 30, true);
  Graph& graph = bundle.graph;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (graph.vertices(edge)[1].pool == bundle.cameras[0].pool) graph.remove(edge);
  }
  graph.unfix(bundle.cameras[0]);
  Optimizer optimizer(graph);
  std::ignore = optimizer.run();
  for (int k = 0; k < 2; ++k) {
    const std::vector<VertexRef> cameras(bundle.cameras.begin(), bundle.cameras.end());
    const Covariance expected = covariance(graph, cameras), actual = optimizer.covariance(cameras);
    ASSERT_TRUE(expected.ok() && actual.ok()) << actual.message();
    EXPECT_EQ(actual.held(), expected.held());
    expect_close(actual.joint(), expected.joint(), 1e-8);
    graph.set_estimate(bundle.points[3], Vector3(1, 2, 9));
  }
}

TEST(OptimizerCovariance, IsRefusedAndGivenAgainAsTheGraphChanges) {
  Circle circle(true);
  Optimizer optimizer(circle.graph);
  std::ignore = optimizer.run();
  circle.graph.set_enabled(circle.seen, false);
  circle.graph.set_enabled(circle.again, false);
  for (int query = 0; query < 2; ++query) {
    const Covariance refused = optimizer.covariance(circle.asked());
    EXPECT_EQ(refused.status(), Covariance::Status::kSingular);
    EXPECT_EQ(refused.failed_vertex(), VertexRef(circle.landmark));
  }
  circle.graph.set_enabled(circle.again, true);
  EXPECT_TRUE(optimizer.covariance(circle.asked()).ok());
  circle.graph.set_estimate(circle.landmark, Vector2(std::nan(""), 1));
  EXPECT_EQ(optimizer.covariance(circle.asked()).status(), Covariance::Status::kNotFinite);
  circle.graph.set_estimate(circle.landmark, Vector2(2, 1));
  expect_close(optimizer.covariance(circle.asked()).joint(), covariance(circle.graph, circle.asked()).joint(),
               1e-10);
}

TEST(OptimizerCovariance, IsComputedAfterAStoppedOrThrowingQuery) {
  Circle circle(true);
  circle.graph.fix(circle.poses[0]);
  std::atomic<bool> stop = false;
  bool throws = false;
  circle.graph.add_edge(
      [&throws](const auto& x) {
        if (throws) throw std::runtime_error("thrown by the error function");
        return x;
      },
      circle.landmark);
  Optimizer optimizer(circle.graph, {.stop = &stop});
  std::ignore = optimizer.run();
  const Eigen::MatrixXd expected = covariance(circle.graph, circle.asked()).joint();
  stop = true;
  EXPECT_EQ(optimizer.covariance(circle.asked()).status(), Covariance::Status::kStopped);
  stop = false;
  expect_close(optimizer.covariance(circle.asked()).joint(), expected, 1e-10);
  throws = true;
  EXPECT_THROW((void)optimizer.covariance(circle.asked()), std::runtime_error);
  throws = false;
  expect_close(optimizer.covariance(circle.asked()).joint(), expected, 1e-10);
  EXPECT_THROW((void)optimizer.covariance(std::vector<VertexRef>{{}}), InvalidArgument);
  expect_close(optimizer.covariance(circle.asked()).joint(), expected, 1e-10);
}

TEST(OptimizerCovariance, ChangesNoBitOfLaterRuns) {
  Circle asked(true), silent(true);
  Optimizer one(asked.graph), other(silent.graph);
  for (int run = 0; run < 3; ++run) {
    std::ignore = one.run();
    std::ignore = one.covariance(asked.asked());
    std::ignore = other.run();
    EXPECT_EQ(asked.graph.estimate(asked.poses[5]).vector(), silent.graph.estimate(silent.poses[5]).vector());
    asked.graph.set_estimate(asked.landmark, Vector2(run, 1));
    silent.graph.set_estimate(silent.landmark, Vector2(run, 1));
  }
}

}  // namespace
}  // namespace boxplus
