// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <type_traits>

#include "boxplus/testing/simulate.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

class EveryAlgorithm : public testing::TestWithParam<AlgorithmKind> {
 protected:
  Options options_{.algorithm = GetParam()};
};

TEST_P(EveryAlgorithm, ReachesTheSameOptimum) {
  Graph graph;
  add_noisy_grid(graph, 4);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  Graph reference;
  add_noisy_grid(reference, 4);
  EXPECT_NEAR(report.chi2_final, optimize(reference).chi2_final, 1e-9 * report.chi2_final);
  // The orders of summation differ, so the sums are equal only up to rounding.
  EXPECT_NEAR(report.chi2_final, graph.chi2(), 1e-14 * graph.chi2());
}

TEST_P(EveryAlgorithm, StopsAtTheIterationLimit) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.max_iterations = 1;
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Report::Status::kNotConverged);
  EXPECT_EQ(report.reason, Report::Reason::kMaxIterations);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.records.size(), 1u);
  options_.max_iterations = 0;
  EXPECT_EQ(optimize(graph, options_).iterations, 0);
}

TEST_P(EveryAlgorithm, StopsWhenTheFlagIsSetAndKeepsTheEstimates) {
  Graph graph;
  add_noisy_grid(graph, 3);
  std::atomic<bool> stop = true;
  options_.stop = &stop;
  const double before = graph.chi2();
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.reason, Report::Reason::kStopFlag);
  EXPECT_EQ(graph.chi2(), before);
}

TEST_P(EveryAlgorithm, StopsWhenTheCallbackReturnsFalse) {
  Graph graph;
  add_noisy_grid(graph, 3);
  int calls = 0;
  options_.cost_tolerance = options_.gradient_tolerance = 0;
  options_.callback = [&](const IterationRecord& record) {
    EXPECT_EQ(record.iteration, ++calls);
    return calls < 2;
  };
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.reason, Report::Reason::kCallback);
  EXPECT_EQ(calls, 2);
}

TEST_P(EveryAlgorithm, RefusesACallbackThatChangesTheGraph) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.callback = [&](const IterationRecord&) {
    graph.clear();
    return true;
  };
  EXPECT_THROW((void)optimize(graph, options_), InvalidArgument);
}

TEST_P(EveryAlgorithm, DoesNotDependOnTheUnitsOfTheInformation) {
  double chi2 = 0;
  for (const double unit : {1.0, 1e-16, 1e16}) {
    Graph graph;
    add_noisy_grid(graph, 3);
    for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 2500 * unit);
    const Report report = optimize(graph, options_);
    EXPECT_TRUE(report.converged()) << report;
    if (chi2 == 0) chi2 = report.chi2_final;
    EXPECT_NEAR(report.chi2_final / unit, chi2, 1e-8 * chi2);
  }
}

TEST_P(EveryAlgorithm, StopsAtTheTimeLimit) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.time_limit_s = 0;
  EXPECT_EQ(optimize(graph, options_).reason, Report::Reason::kTimeLimit);
}

TEST_P(EveryAlgorithm, MakesNoGuessAfterAStopWasRequested) {
  for (const Start start : every_start()) {
    Graph graph;
    add_noisy_circle(graph, 30);
    const double before = graph.chi2();
    options_.start = start;
    const std::atomic<bool> stop = true;
    options_.stop = &stop;
    EXPECT_EQ(optimize(graph, options_).reason, Report::Reason::kStopFlag);
    EXPECT_EQ(graph.chi2(), before);
    options_.stop = nullptr;
    options_.time_limit_s = 0;
    EXPECT_EQ(optimize(graph, options_).reason, Report::Reason::kTimeLimit);
    EXPECT_EQ(graph.chi2(), before);
    options_.time_limit_s = 1e9;
  }
}

TEST_P(EveryAlgorithm, CanBeStoppedBetweenTheLinearizationAndTheStep) {
  for (const LinearSolverKind solver : {LinearSolverKind::kBlockCholesky, LinearSolverKind::kPcg}) {
    Graph graph;
    const auto poses = add_noisy_circle(graph, 10);
    std::atomic<bool> stop = false;
    graph.add_edge(
        [&stop]<class Pose>(const Pose& pose) {
          if constexpr (!std::is_same_v<Pose, SE2>) stop = true;  // called with dual numbers
          return pose.x();
        },
        poses[4]);
    const double before = graph.chi2();
    options_.stop = &stop;
    options_.linear_solver = solver;
    const Report report = optimize(graph, options_);
    EXPECT_EQ(report.status, Report::Status::kNotConverged);
    EXPECT_EQ(report.reason, Report::Reason::kStopFlag);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(graph.chi2(), before);
  }
}

TEST_P(EveryAlgorithm, CallsTheCallbackAfterTheLastIterationTooButThenIgnoresItsResult) {
  Graph graph;
  add_noisy_grid(graph, 3);
  int calls = 0;
  options_.callback = [&](const IterationRecord&) { return ++calls > 0; };
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(calls, report.iterations);
  options_.cost_tolerance = 1e30;
  options_.callback = [](const IterationRecord&) { return false; };
  EXPECT_EQ(optimize(graph, options_).status, Report::Status::kConverged);
}

TEST_P(EveryAlgorithm, UsesPcgIfTheFactorDoesNotFitIntoMemory) {
  for (const Start start : {Start::kCurrent, Start::kChordal}) {
    Graph direct, iterative;
    add_noisy_grid(direct, 4);
    add_noisy_grid(iterative, 4);
    options_.start = start;
    options_.max_factor_bytes = 0;
    const Report expected = optimize(direct, options_);
    EXPECT_EQ(expected.linear_solver, "block_cholesky");
    options_.max_factor_bytes = 1000;
    const Report report = optimize(iterative, options_);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, expected.chi2_final, 1e-6 * expected.chi2_final);
    EXPECT_EQ(report.start.used, start);
    EXPECT_THAT(to_string(report), HasSubstr("pcg (because each factorization would take "));
  }
}

TEST_P(EveryAlgorithm, StopsAtTheToleranceOfTheCostTheStepOrTheGradient) {
  const auto reason_with = [&](double Options::*tolerance, double value) {
    Graph graph;
    add_noisy_grid(graph, 3);
    options_.cost_tolerance = options_.step_tolerance = options_.gradient_tolerance = 0;
    options_.*tolerance = value;
    return optimize(graph, options_).reason;
  };
  EXPECT_EQ(reason_with(&Options::cost_tolerance, 1e-3), Report::Reason::kCostTolerance);
  EXPECT_EQ(reason_with(&Options::step_tolerance, 1e-3), Report::Reason::kStepTolerance);
  EXPECT_EQ(reason_with(&Options::gradient_tolerance, 1e-1), Report::Reason::kGradientTolerance);
}

TEST_P(EveryAlgorithm, EndsWhenOnlyRoundingErrorsRemainEvenIfTolerancesAreZero) {
  Graph graph;
  add_noisy_grid(graph, 6);
  options_.cost_tolerance = options_.noise_tolerance = options_.step_tolerance = 0;
  options_.max_iterations = 512;
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.reason, Report::Reason::kNoFurtherDecrease) << report;
  EXPECT_LT(report.iterations, 20) << report;
}

TEST_P(EveryAlgorithm, ReachesTheOptimumBesideAVertexThatStartsFarAway) {
  const auto run = [&](Graph& graph) {
    const Report report = optimize(graph, options_);
    EXPECT_TRUE(report.converged()) << report;
    return report.chi2_final;
  };
  Graph alone = simulate(World::kManhattan, {.poses = 500}).graph, beside = alone;
  using Clock = Vector<double, 1>;
  beside.add_edge(Prior(Clock(1.7e18)), beside.add_vertex(Clock(0.0)));
  const double chi2 = run(alone);
  EXPECT_NEAR(run(beside), chi2, 1e-6 * chi2);
}

TEST_P(EveryAlgorithm, FitsExactMeasurementsFarFromTheOriginInFewIterations) {
  for (const double scale : {1e-8, 1.0, 1e8}) {
    Graph graph = simulate(World::kTorus, {.poses = 300, .noise = 0}).graph;
    for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, scale);
    const SE3 far_away(Vector3(1e6, 2e6, 3e6), SO3::from_rotation_vector(Vector3(0.1, 0.2, 0.3)));
    for (const VertexRef& vertex : graph.all_vertices()) {
      const auto pose = graph.vertex<SE3>(graph.id(vertex));
      const double offset = graph.is_fixed(pose) ? 0 : 0.1 * std::sin(pose.slot);
      const SE3 displaced(Vector3(offset, -offset, offset), SO3());
      graph.set_estimate(pose, far_away * graph.estimate(pose) * displaced);
    }
    const Report report = optimize(graph, options_);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-16 * scale * report.scalars);
    EXPECT_LT(report.iterations, 30) << report;
  }
}

TEST_P(EveryAlgorithm, NamesTheEdgeWhoseErrorIsNotANumber) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  graph.add_edge([](const auto& x) { return sqrt(x.x() - 1e6); }, poses[4]);
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Report::Status::kFailed);
  EXPECT_EQ(report.reason, Report::Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("between vertices 4 is NaN"));
}

TEST_P(EveryAlgorithm, NamesTheEdgeWhoseJacobianIsNotANumber) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  // √ has no derivative at 0.
  graph.add_edge([x = graph.estimate(poses[4]).x()](const auto& p) { return sqrt(p.x() - x); }, poses[4]);
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Report::Status::kFailed);
  EXPECT_THAT(report.message, HasSubstr("a Jacobian (or the weight of the robust kernel) of"));
  EXPECT_THAT(report.message, HasSubstr("between vertices 4 is NaN"));
}

TEST_P(EveryAlgorithm, RestoresTheEstimatesIfAnErrorFunctionThrows) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  const SE2 before = graph.estimate(poses[5]);
  graph.add_edge(
      [x = before.x()](const auto& p) {
        if (p.x() != x) throw std::runtime_error("the sensor is gone");
        return p.x();
      },
      poses[5]);
  options_.threads = 1;
  EXPECT_THROW((void)optimize(graph, options_), std::runtime_error);
  EXPECT_EQ(graph.estimate(poses[5]).vector(), before.vector());
}

INSTANTIATE_TEST_SUITE_P(Optimize, EveryAlgorithm, testing::ValuesIn(every_algorithm()),
                         [](const auto& test) { return test_name(test.param); });

/// The error x − z with a wrong Jacobian.
struct WrongJacobian {
  double measurement, slope;
  double error(const double& x) const { return x - measurement; }
  template <class J>
  void jacobians(const double&, J& jacobian) const {
    jacobian(0, 0) = slope;
  }
};

TEST(Optimize, DoesNotReportConvergenceIfNoStepReachesItsPredictedDecrease) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const double unit : {1.0, 1e-10}) {
      for (const double slope : {-1.0, -10.0, -0.1}) {
        Graph graph;
        const auto x = graph.add_vertex(0.0);
        graph.add_edge(WrongJacobian{5 * unit, slope}, 1 / (unit * unit), x);
        const Report report = optimize(graph, {.algorithm = algorithm});
        EXPECT_EQ(report.status, Report::Status::kNotConverged);
        EXPECT_EQ(report.reason, Report::Reason::kNoStepFound);
        EXPECT_EQ(graph.estimate(x), 0.0);
      }
    }
  }
}

/// At z = 0, the Jacobian of z vanishes, but chi2 still falls along x. If the scale of z vanished, too, steps
/// would be long in z and short in x.
TEST(Optimize, DoesNotReportConvergenceIfTheJacobianOfAnotherDirectionVanishes) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const double weight : {1.0, 10.0, 100.0}) {
      Graph graph;
      const auto p = graph.add_vertex(Vector3(2, 2, 2));
      graph.add_edge(
          [](const auto& v) {
            using S = std::decay_t<decltype(v[0])>;
            return Vector<S, 2>(0.1 * (v[0] - 1.0), v[1] - v[0] * v[0]);
          },
          p);
      const auto sum = graph.add_edge([](const auto& v) { return v[0] + v[2] * v[2] + 1.0; }, weight, p);
      const Report report = optimize(graph, {.algorithm = algorithm});
      const double along_x = graph.error(sum)[0] * weight;  // the other edges contribute little
      EXPECT_TRUE(!report.converged() || std::abs(along_x) < 0.1) << report;
    }
  }
}

TEST(Optimize, DoesNotReportConvergenceIfGaussNewtonEndsAboveItsStart) {
  for (const auto algorithm : every_algorithm()) {
    Graph graph;
    const auto x = graph.add_vertex(0.0);
    graph.add_edge([](const auto& v) { return v - 10.0; }, x);
    graph.add_edge([](const auto& v) { return 100.0 / (1.0 + exp(20.0 * (5.0 - v))); }, x);  // a wall at 5
    const Report report = optimize(graph, {.algorithm = algorithm});
    const bool jumps = algorithm == AlgorithmKind::kGaussNewton;
    EXPECT_EQ(report.converged(), !jumps) << report;
    EXPECT_EQ(report.chi2_final > report.chi2_initial, jumps);
    EXPECT_EQ(report.reason == Report::Reason::kRaisedChi2, jumps);
    EXPECT_EQ(to_string(report).find("chi2 is above its start") != std::string::npos, jumps);
  }
}

TEST(Optimize, DoesNotReportConvergenceIfDampingOrTheTrustRegionShortensEveryStep) {
  for (const double tightness : {1e6, 1e10, 1e14, 1e30, 1e300}) {
    const Options damped{.algorithm = AlgorithmKind::kLevenbergMarquardt,
                         .max_iterations = 3,
                         .cost_tolerance = 1e-3,
                         .initial_lambda = tightness};
    const Options bounded{.algorithm = AlgorithmKind::kDogleg,
                          .max_iterations = 3,
                          .cost_tolerance = 1e-3,
                          .initial_radius = 1 / tightness};
    for (const Options& options : {damped, bounded}) {
      Graph graph;
      add_noisy_grid(graph, 3);
      const Report report = optimize(graph, options);
      EXPECT_EQ(report.status, Report::Status::kNotConverged) << report;
      EXPECT_EQ(report.reason, Report::Reason::kMaxIterations);
    }
  }
}

TEST(Optimize, RecoversFromDampingOrATrustRegionThatAllowsNoStep) {
  Graph reference;
  add_noisy_grid(reference, 3);
  const double chi2 = optimize(reference).chi2_final;
  for (const Options::DampingScale scale :
       {Options::DampingScale::kIdentity, Options::DampingScale::kDiagonal}) {
    const Options damped{
        .algorithm = AlgorithmKind::kLevenbergMarquardt, .damping = scale, .initial_lambda = 1e300};
    const Options bounded{.algorithm = AlgorithmKind::kDogleg, .initial_radius = 1e-300};
    for (const Options& options : {damped, bounded}) {
      Graph graph;
      add_noisy_grid(graph, 3);
      const Report report = optimize(graph, options);
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_NEAR(report.chi2_final, chi2, 1e-8 * chi2);
    }
  }
}

TEST(Optimize, ReportsConvergenceAtAMinimumForAnyDampingAndTrustRegion) {
  for (const Options& options :
       {Options{.algorithm = AlgorithmKind::kLevenbergMarquardt, .initial_lambda = 1e300},
        Options{.algorithm = AlgorithmKind::kDogleg, .initial_radius = 1e-300}}) {
    Graph graph;
    add_noisy_grid(graph, 3);
    std::ignore = optimize(graph);
    const Report report = optimize(graph, options);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.iterations, 3);
  }
}

TEST(Optimize, RefusesARunOnTheSameGraphInsideItsCallback) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kGaussNewton}) {
    Graph graph;
    add_noisy_circle(graph, 20);
    Options options{.algorithm = algorithm};
    options.callback = [&](const IterationRecord&) {
      std::ignore = optimize(graph);
      return true;
    };
    EXPECT_THROW((void)optimize(graph, options), InvalidArgument);
    options.callback = nullptr;
    EXPECT_TRUE(optimize(graph, options).converged()) << "the graph can be optimized again";
  }
}

TEST(Optimize, LeavesTheGraphUsableIfAnErrorFunctionThrows) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  bool throws = true;
  graph.add_edge(
      [&throws](const auto& value) {
        if (throws) throw std::runtime_error("no measurement");
        return value - 3;
      },
      x);
  EXPECT_THROW((void)optimize(graph), std::runtime_error);
  EXPECT_THROW((void)optimize(graph), std::runtime_error) << "the graph must not be in use any more";
  throws = false;
  EXPECT_TRUE(optimize(graph).converged());
}

}  // namespace
}  // namespace boxplus
